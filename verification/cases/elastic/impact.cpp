/// Two halves of a periodic row meet at speed +-v_0: a shock runs from x = 1/2, a wave of tension from x = 0, both with
/// c = sqrt(M/rho):
///
///   |x - 1/2| < c t:  sigma = -rho c v_0,   |x| < c t or |1 - x| < c t:  sigma = rho c v_0,   else 0             (1)
///
/// for small v_0. A jump is no smooth solution: the error falls with an order of 1/2 to 1 where the scheme damps, and
/// FLIP rings. The front of a scheme whose waves' speed falls as (kh)^2 tends to the integral of Airy's function, which
/// overshoots by 0.274.

#include <cmath>

#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/laws/hencky.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/refinement.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification::elastic_impact {

namespace {

constexpr double modulus = 1e5, density = 1000, courant = 0.2, way = 0.15;  // way: c t
constexpr int per_cell = 4;
double const c = std::sqrt(modulus / density);

struct Profile {
  Curve found;
  double error = 0;  ///< mean |sigma - exact| over rho c v_0
  double overshoot = 0;
};

Profile solved(Scheme const& scheme, int N, Cost& cost) {
  double const h = 1.0 / N, v0 = 1e-6 * c;
  Scene<2> scene = scene_of<kinematics::PlaneStrainReduced, law::Hencky>(scheme, h, density, {modulus, 0});
  scene.periods = {N / block_edge, 1};
  set_step(scene, courant * h / c);
  std::vector<Seed<2>> seeds;
  for (auto const& x : lattice<2>({0, 0}, {N, block_edge}, {per_cell, 1}, h)) {
    Seed<2> seed;
    seed.x = x;
    seed.v[0] = x[0] < 0.5 ? v0 : -v0;
    seed.mass = density * h * h / per_cell;
    seeds.push_back(seed);
  }
  auto const simulation = begin(std::move(scene), seeds);
  take_steps(*simulation, std::lround(way * N / courant), cost);
  auto const strain = column(*simulation, "elastic_strain");
  Profile profile;
  profile.found.name = scheme.name();
  for (std::size_t p = 0; p < strain.size(); ++p) {
    double const x = seeds[p].x[0], y = seeds[p].x[1], stress = strain[p] * c / v0;  // over rho c v_0
    double const exact = std::abs(x - 0.5) < way ? -1 : x < way || x > 1 - way ? 1 : 0;
    profile.error += std::abs(stress - exact) / double(strain.size());
    profile.overshoot = std::max(profile.overshoot, std::abs(stress) - 1);
    if (y > h) continue;
    profile.found.x.push_back(x);
    profile.found.y.push_back(stress);
  }
  return profile;
}

void run(Findings& findings) {
  constexpr int cells[] = {64, 128, 256, 512};
  Plot plot{"Stress after an impact", "x [m]", "sigma/(rho c v_0)", false, false, {}};
  for (Scheme const& scheme : all_schemes()) {
    double overshoot = 0;
    Refinement study;
    study.subject = scheme.name();
    for (int const N : cells) study.spacings.push_back(1.0 / N);
    Norm norm;
    norm.name = "stress, mean";
    norm.order = 0.45;
    norm.most_order = 1.05;
    norm.because = "a jump: 1/2 to 1";
    study.norms = {norm};
    study.solve = [&](std::size_t level) {
      Measured measured;
      Profile const profile = solved(scheme, cells[level], measured.cost);
      measured.errors = {profile.error};
      overshoot = profile.overshoot;
      if (level == 1) plot.curves.push_back(profile.found);
      return measured;
    };
    refine(findings, study, "Impact");
    if (scheme.transfer == "pic")
      findings.check(scheme.name(), "overshoot", overshoot, at_most(1e-3), "PIC is monotone");
    else if (scheme.transfer == "flip")
      findings.check(scheme.name(), "overshoot", overshoot, about(0.2744, 0.1),
                     "front of a dispersive scheme, see the case's file; 10 %: a finite way from the start");
    else
      findings.note(scheme.name(), "overshoot", overshoot);
  }
  findings.plots.push_back(plot);
}

}  // namespace

Case const the_case{"elastic/impact", "Two halves of a bar collide", "d'Alembert's solution", "textbook", 2, 30, run};

}  // namespace talus::verification::elastic_impact
