/// A block that falls free, thrown: symplectic Euler has the exact motion
///
///   v_n = v_0 + g t_n,   x_n = x_0 + v_0 t_n + g t_n (t_n + dt)/2                                       (1)
///
/// for every scheme, because a uniform velocity passes every transfer and gravity strains nothing.

#include "models/kinematics/plane_strain.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/hencky.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification {

namespace {

constexpr double h = 0.1, density = 1500, dt = 1e-3;
constexpr int steps = 500;

/// Largest distance of a particle from (1), and the ledger's residuals.
template <class Kinematics>
void fall(Findings& findings, Scheme const& scheme, std::string const& where) {
  constexpr int D = Kinematics::dimension;
  Point<D> g = Point<D>::Zero(), v0 = Point<D>::Constant(0.7);
  g[0] = 1.3;
  g[1] = -9.81;
  Scene<D> scene = scene_of<Kinematics, law::Hencky>(scheme, h, density, {1e5, 0.3});
  scene.gravity = g;
  scene.keeps_ledger = true;
  set_step(scene, dt);
  std::array<int, D> cells, per_axis;
  cells.fill(4);
  per_axis.fill(2);
  std::vector<Seed<D>> seeds;
  auto const places = lattice<D>(Point<D>::Constant(0.03), cells, per_axis, h);
  for (Point<D> const& x : places) seeds.push_back({x, v0, density * std::pow(h / 2, D)});
  auto const simulation = begin(std::move(scene), seeds);
  Cost cost;
  take_steps(*simulation, steps, cost);
  double const t = steps * dt;
  Point<D> const way = v0 * t + 0.5 * t * (t + dt) * g;
  double off = 0, scale = way.norm();
  auto const x = vectors(*simulation, "position");
  for (std::size_t p = 0; p < x.size(); ++p) off = std::max(off, (x[p] - places[p] - way).norm());
  std::string const subject = scheme.name() + ", " + where;
  findings.check(subject, "distance from the discrete motion", off / scale, at_most(1e-12), "exact in every scheme",
                 cost);
  findings.check(subject, "residual of the energy ledger", std::abs(simulation->ledger().relative_energy_residual()),
                 at_most(1e-12), "rounding");
}

void run(Findings& findings) {
  for (Scheme const& scheme : all_schemes()) {
    fall<kinematics::PlaneStrain>(findings, scheme, "2-D");
    fall<kinematics::Solid>(findings, scheme, "3-D");
  }
}

}  // namespace

Case const motion_free_fall{"motion/free_fall",
                            "A block is thrown and falls free",
                            "the exact motion of symplectic Euler",
                            "derived in the case's file",
                            0,
                            5,
                            run};

}  // namespace talus::verification
