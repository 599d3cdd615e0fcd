/// A block that falls free, thrown: symplectic Euler has the exact motion
///
///   v_n = v_0 + g t_n,   x_n = x_0 + v_0 t_n + g (t_n^2 + sum_k dt_k^2)/2                               (1)
///
/// for every scheme and any steps, because a uniform velocity passes every transfer and gravity strains nothing.

#include "models/kinematics/plane_strain.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/hencky.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification::motion_free_fall {

namespace {

constexpr double h = 0.1, density = 1500, dt = 1e-3, speed = 0.7;  // m, kg/m^3, s, m/s
constexpr int steps = 500;

template <int D>
Point<D> gravity() {
  Point<D> g = Point<D>::Zero();
  g[0] = 1.3;
  g[1] = -9.81;
  return g;
}

/// A block of elastic particles, thrown.
template <class Kinematics>
auto thrown(Scheme const& scheme, std::vector<Point<Kinematics::dimension>>& places) {
  constexpr int D = Kinematics::dimension;
  Scene<D> scene = scene_of<Kinematics, law::Hencky>(scheme, h, density, {1e5, 0.3});
  scene.gravity = gravity<D>();
  scene.keeps_ledger = true;
  set_step(scene, dt);
  std::array<int, D> cells, per_axis;
  cells.fill(4);
  per_axis.fill(2);
  std::vector<Seed<D>> seeds;
  places = lattice<D>(Point<D>::Constant(0.03), cells, per_axis, h);
  for (Point<D> const& x : places) seeds.push_back({x, Point<D>::Constant(speed), density * std::pow(h / 2, D)});
  return begin(std::move(scene), seeds);
}

/// Largest distance of a particle from (1) at time t, over the way; squares: sum of the squares of the steps.
template <int D>
double distance(Simulation<D> const& simulation, std::vector<Point<D>> const& places, double t, double squares) {
  Point<D> const way = speed * t * Point<D>::Ones() + 0.5 * (t * t + squares) * gravity<D>();
  auto const x = vectors(simulation, "position");
  double off = 0;
  for (std::size_t p = 0; p < x.size(); ++p) off = std::max(off, (x[p] - places[p] - way).norm());
  return off / way.norm();
}

template <class Kinematics>
void fall(Findings& findings, Scheme const& scheme, std::string const& where) {
  std::vector<Point<Kinematics::dimension>> places;
  auto const simulation = thrown<Kinematics>(scheme, places);
  Cost cost;
  take_steps(*simulation, steps, cost);
  std::string const subject = scheme.name() + ", " + where;
  findings.check(subject, "distance from the discrete motion",
                 distance(*simulation, places, steps * dt, steps * dt * dt), at_most(1e-12), "exact in every scheme",
                 cost);
  findings.check(subject, "residual of the energy ledger", std::abs(simulation->ledger().relative_energy_residual()),
                 at_most(1e-12), "rounding");
}

/// Steps that the speed shortens, up to an end that is no multiple of them.
void fall_to_an_end(Findings& findings) {
  constexpr double end = 1.2345678;
  std::vector<Point<2>> places;
  auto const simulation = thrown<kinematics::PlaneStrain>({}, places);
  double squares = 0, shortest = dt, longest = 0;
  while (simulation->time() < end) {
    simulation->advance(end);
    double const step = simulation->last_step().dt;
    squares += step * step;
    shortest = std::min(shortest, step);
    longest = std::max(longest, step);
  }
  findings.check("steps of many lengths", "distance from the discrete motion",
                 distance(*simulation, places, end, squares), at_most(1e-12), "(1) at the end that was asked for");
  findings.check("steps of many lengths", "end less the end that was asked for", std::abs(simulation->time() - end),
                 at_most(0), "the last step lands on it");
  findings.check("steps of many lengths", "shortest step over the longest", shortest / longest, at_most(0.99),
                 "else nothing was tried");
}

void run(Findings& findings) {
  for (Scheme const& scheme : all_schemes()) {
    fall<kinematics::PlaneStrain>(findings, scheme, "2-D");
    fall<kinematics::Solid>(findings, scheme, "3-D");
  }
  fall_to_an_end(findings);
}

}  // namespace

Case const the_case{"motion/free_fall",
                    "A block is thrown and falls free",
                    "the exact motion of symplectic Euler",
                    "derived in the case's file",
                    0,
                    5,
                    run};

}  // namespace talus::verification::motion_free_fall
