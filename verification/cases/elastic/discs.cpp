/// Two elastic discs meet head on and part (E = 1000 Pa, nu = 0.3, rho = 1000 kg/m^3, R = 0.2 m, centres (0.2, 0.2) and
/// (0.8, 0.8) m, velocities +-(0.1, 0.1) m/s, h = 1/20 m).
///
/// The second disc is the first one, turned by 180 degrees about (0.5, 0.5), a node: the discrete problem has that
/// symmetry. Points of the rims meet after
///
///   t = (0.6 sqrt 2 - 2 R)/(0.2 sqrt 2) = 1.5858 s                                                                (1)
///
/// but on a grid bodies feel one another as soon as they share a node, up to (p + 1) h before that.

#include <cmath>

#include "models/kinematics/plane_strain.hpp"
#include "models/laws/hencky.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification::elastic_discs {

namespace {

constexpr double R = 0.2, E = 1000, density = 1000, dt = 1e-3;
constexpr long steps = 4400;  // 4.4 s
double const closing = 0.2 * std::sqrt(2), meeting = (0.6 * std::sqrt(2) - 2 * R) / closing;

/// Particle 2 k + 1 is particle 2 k turned about (0.5, 0.5).
std::vector<Seed<2>> discs(double h) {
  std::vector<Seed<2>> seeds;
  int const across = static_cast<int>(std::lround(2 * R / h));
  for (auto const& x : lattice<2>({0, 0}, {across, across}, {2, 2}, h)) {
    if ((x - Point<2>(0.2, 0.2)).norm() > R) continue;
    Seed<2> seed;
    seed.x = x;
    seed.v = {0.1, 0.1};
    seed.mass = density * h * h / 4;
    seeds.push_back(seed);
    seed.x = Point<2>(1, 1) - x;
    seed.v = -seed.v;
    seeds.push_back(seed);
  }
  return seeds;
}

struct Found {
  double asymmetry = 0;               ///< largest distance of a particle from its turned partner [m]
  double momentum = 0;                ///< largest |sum m v| over sum m |v| at the start
  double contact = 0;                 ///< when a disc has lost 1 % of its momentum [s]
  double kinetic = 1;                 ///< largest kinetic energy since its least, over that at the start
  double total = 0;                   ///< energy at the end over that at the start
  double transfer = 0, stepping = 0;  ///< what transfer and stepping took, over the energy at the start
  Curve energy = {};
};

Found collided(Scheme const& scheme, double h, Cost& cost) {
  Scene<2> scene = scene_of<kinematics::PlaneStrain, law::Hencky>(scheme, h, density, {E, 0.3});
  scene.keeps_ledger = true;
  set_step(scene, dt);
  auto const seeds = discs(h);
  auto const simulation = begin(std::move(scene), seeds);
  double const mass = seeds.front().mass, start = double(seeds.size()) * mass * seeds.front().v.norm();
  auto const& ledger = simulation->ledger();
  Found found;
  found.energy.name = scheme.name();
  double least = 1;
  take_steps(*simulation, steps, cost, [&] {
    auto const x = vectors(*simulation, "position"), v = vectors(*simulation, "velocity");
    Point<2> one = Point<2>::Zero(), both = Point<2>::Zero();
    for (std::size_t p = 0; p < x.size(); p += 2) {
      found.asymmetry = std::max(found.asymmetry, (x[p] + x[p + 1] - Point<2>(1, 1)).norm());
      one += mass * v[p];
      both += mass * (v[p] + v[p + 1]);
    }
    found.momentum = std::max(found.momentum, both.norm() / start);
    if (found.contact == 0 && one.norm() < 0.99 * start / 2) found.contact = simulation->time();
    double const kinetic = ledger.now.kinetic / ledger.start.kinetic;
    if (kinetic < least) least = found.kinetic = kinetic;
    found.kinetic = std::max(found.kinetic, kinetic);
    if (simulation->step_count() % 40 != 0) return;
    found.energy.x.push_back(simulation->time());
    found.energy.y.push_back(kinetic);
  });
  found.transfer = ledger.transfer / ledger.start.kinetic;
  found.stepping = ledger.stepping / ledger.start.kinetic;
  found.total = (ledger.now.kinetic + ledger.now.elastic) / ledger.start.kinetic;
  return found;
}

void of(Findings& findings, Plot& plot, Scheme const& scheme, double h) {
  Cost cost;
  Found const found = collided(scheme, h, cost);
  std::string const subject = scheme.name();
  double const reach = (scheme.degree() + 1) * h / closing;
  findings
      .check(subject, "distance from symmetry", found.asymmetry, at_most(1e-12), "a symmetry of the discrete problem",
             cost)
      .unit = "m";
  findings.check(subject, "momentum over sum m |v|", found.momentum, at_most(1e-13), "exact");
  findings
      .check(subject, "time of contact", found.contact, {meeting - reach, meeting + 0.5 * h / closing},
             "(1) less the kernel's reach; outermost particles lie up to h/2 inside the rim")
      .unit = "s";
  bool const increments = scheme.transfer == "flip" || scheme.transfer == "aflip";
  if (increments && scheme.integrator == "musl" && scheme.degree() == 2) {
    findings.check(subject, "kinetic energy recovered", found.kinetic, at_least(0.9),
                   "elastic; part goes into vibrations");
    findings.check(subject, "total energy at the end", found.total, {0.98, 1.02}, "next to no loss");
  } else {
    std::string const why =
        increments && scheme.integrator == "musl"
            ? "asked of the quadratic kernel: four cells in the radius are few for a wider one"
        : increments ? "asked with musl alone: with usl, flip takes (1 - S) pi omega dt of a wave in a period, "
                       "which of the short waves of a collision is much"
                     : "the transfer smooths";
    findings.note(subject, "kinetic energy recovered", found.kinetic, why);
    findings.note(subject, "total energy at the end", found.total, why);
  }
  findings.note(subject, "energy that the transfer took", found.transfer);
  findings.note(subject, "energy that stepping took", found.stepping);
  plot.curves.push_back(found.energy);
}

void run(Findings& findings) {
  Plot plot{"Kinetic energy of two discs that collide", "t [s]", "over that at the start", false, false, {}};
  for (std::string const integrator : {"usl", "musl"})
    for (Scheme const& scheme : all_schemes(integrator))
      if (scheme.degree() > 1) of(findings, plot, scheme, 0.05);
  findings.omit("linear", "all", "internal forces on nodes of next to no mass are weakened: momentum is not kept");
  findings.plots.push_back(plot);
}

}  // namespace

Case const the_case{"elastic/discs",
                    "Two elastic discs collide",
                    "symmetry, momentum, the time of free contact, elastic rebound",
                    "Sulsky, Chen & Schreyer (1994), doi:10.1016/0045-7825(94)90112-0 (parameters from memory)",
                    1,
                    40,
                    run};

}  // namespace talus::verification::elastic_discs
