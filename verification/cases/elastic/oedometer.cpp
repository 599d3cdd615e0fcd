/// Uniaxial compression of Hencky's solid by the height ratio e^-a, in closed form at any strain:
///
///   tau_yy = -(lambda + 2 G) a,   tau_xx = tau_zz = -lambda a,   tau_xx/tau_yy = nu/(1 - nu)                      (1)
///
/// once at a material point, in one step and in many; once on a grid, where a lid moves down slowly between frictionless
/// walls.

#include <cmath>

#include "core/material_point.hpp"
#include "models/boundaries/contacts/slip.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/boundaries/motions/fixed.hpp"
#include "models/boundaries/motions/translation.hpp"
#include "models/boundaries/shapes/half_space.hpp"
#include "models/kinematics/plane_strain.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/hencky.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/settle.hpp"

namespace talus::verification::elastic_oedometer {

namespace {

constexpr double E = 1e6, nu = 0.3, density = 1500;
constexpr double lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), G = E / (2 * (1 + nu));

/// A point, pressed in n steps; each multiplies the height by 1 - 0.5/n.
template <class Kinematics>
void of_point(Findings& findings, int n, std::string const& where) {
  MaterialPoint<Kinematics::dimension> point(make_material<Kinematics, law::Hencky>("only", density, {E, nu}),
                                             Symmetric<double, typename Kinematics::Shape>::size);
  Segment press;
  press.duration = 1;
  press.steps = n;
  press.controls[1].rate = -0.5;
  follow(point, press, [] {});
  double const a = -n * std::log1p(-0.5 / n);
  auto const tau = point.stress();
  double const vertical = std::abs(tau[1] / (-(lambda + 2 * G) * a) - 1),
               lateral = std::abs(tau[0] / (-lambda * a) - 1), across = std::abs(tau[2] / (-lambda * a) - 1);
  findings.check(where + ", " + std::to_string(n) + " steps", "stress over (1) - 1",
                 std::max({vertical, lateral, across}), at_most(1e-12), "closed form");
}

/// A box of 4 x 4 cells, the lid comes down by 1 % of the height; then the block settles.
void on_grid(Findings& findings, Scheme const& scheme) {
  constexpr double h = 0.25, height = 1, pressed = 0.01, speed = 0.02;
  Scene<2> scene = scene_of<kinematics::PlaneStrain, law::Hencky>(scheme, h, density, {E, nu});
  wall::HalfSpace::Parameters floor, lid;
  floor.normal = {0, 1};
  lid.point = {0, height};
  lid.normal = {0, -1};
  scene.periods = {1, 0};
  scene.walls.push_back(make_wall<2, wall::HalfSpace, wall::Slip, wall::Fixed>("floor", floor, {}, {}));
  scene.walls.push_back(make_wall<2, wall::HalfSpace, wall::Slip, wall::Translation>(
      "lid", lid, {}, {{0, -speed, 0}, 0, pressed / speed}));
  double const dt = 0.2 * h / std::sqrt((lambda + 2 * G) / density);
  set_step(scene, dt);
  std::vector<Seed<2>> seeds;
  for (auto const& x : lattice<2>({0, 0}, {4, 4}, {2, 2}, h)) {
    Seed<2> seed;
    seed.x = x;
    seed.mass = density * h * h / 4;
    seeds.push_back(seed);
  }
  auto const simulation = begin(std::move(scene), seeds);
  Cost cost;
  take_steps(*simulation, std::lround(pressed / speed / dt) + 1, cost);
  settle(*simulation, 2000, cost);
  double worst = 0;
  std::array<std::vector<double>, 3> eps;
  for (int k = 0; k < 3; ++k) eps[static_cast<std::size_t>(k)] = column(*simulation, "elastic_strain", k);
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    double const volume = eps[0][p] + eps[1][p] + eps[2][p];
    worst = std::max(
        worst,
        std::abs((lambda * volume + 2 * G * eps[0][p]) / (lambda * volume + 2 * G * eps[1][p]) / (nu / (1 - nu)) - 1));
  }
  findings.check(scheme.name() + ", grid", "lateral over vertical stress over nu/(1 - nu) - 1", worst, at_most(1e-9),
                 "lateral strain is zero exactly, whatever the vertical one", cost);
}

void run(Findings& findings) {
  for (int const n : {1, 1000}) {
    of_point<kinematics::PlaneStrain>(findings, n, "point, plane strain");
    of_point<kinematics::Solid>(findings, n, "point, solid");
  }
  for (Scheme const& scheme : all_schemes()) on_grid(findings, scheme);
}

}  // namespace

Case const the_case{"elastic/oedometer",
                    "Uniaxial compression without lateral strain",
                    "closed form of Hencky's law",
                    "derived in the case's file",
                    0,
                    5,
                    run};

}  // namespace talus::verification::elastic_oedometer
