/// A block is led through a rigid rotation, step by step: before each step its particles are given the velocities of an
/// affine field, which the affine transfers pass on exactly, so that dt L is the matrix that was chosen.
///
///   dt L = R - I, R a rotation:  eps' = R eps R^T exactly; ten revolutions leave nothing                          (1)
///   dt L = dt W, W = omega x:    F' = (I + dt W) F stretches by sqrt(1 + (omega dt)^2) across the axis,
///                                so that eps grows by ln(1 + (omega dt)^2)/2 ~ omega^2 dt t/2 in all            (2)
///
/// (1): the update of the strain is objective. (2) is what a rotation at constant velocity gradient costs, of order 1
/// in dt. The material is next to weightless in stiffness, so that stress does not move the nodes.

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "models/kinematics/plane_strain.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/hencky.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification::conservation_objectivity {

namespace {

constexpr double h = 0.25, density = 1000, dt = 1e-3;

template <int D>
using Square = Eigen::Matrix<double, D, D>;

/// Gives every particle the velocity rate x.
template <int D>
void lead(Simulation<D>& simulation, Square<D> const& rate) {
  Particles<D>& particles = simulation.particles();
  Layout const& layout = particles.layout();
  int const x = layout.find(field::position), v = layout.find(field::velocity), C = layout.find("affine_velocity");
  particles.for_each([&](std::ptrdiff_t slot, int) {
    for (int i = 0; i < D; ++i) {
      double sum = 0;
      for (int j = 0; j < D; ++j) {
        sum += rate(i, j) * particles.get(slot, x + j);
        particles.set(slot, C + i * D + j, rate(i, j));
      }
      particles.set(slot, v + i, sum);
    }
  });
}

/// A turn by `angle`; in space about an axis askew.
template <int D>
Square<D> rotation(double angle) {
  if constexpr (D == 2) return Eigen::Rotation2Dd(angle).toRotationMatrix();
  if constexpr (D == 3) return Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, -2) / 3).toRotationMatrix();
}
/// Its rate at unit speed.
template <int D>
Square<D> spin() {
  Square<D> W = Square<D>::Zero();
  if constexpr (D == 2) W << 0, -1, 1, 0;
  if constexpr (D == 3) W << 0, 2, 2, -2, 0, -1, -2, 1, 0;
  return D == 2 ? W : Square<D>(W / 3);
}

/// Takes n steps with the increment dt L; the strain of all particles differs by less than rounding, the first's is
/// returned.
template <class Kinematics>
Square<Kinematics::dimension> led(Scheme const& scheme, Square<Kinematics::dimension> const& start,
                                  Square<Kinematics::dimension> const& increment, long n, Cost& cost) {
  constexpr int D = Kinematics::dimension;
  using Strain = Symmetric<double, typename Kinematics::Shape>;
  Scene<D> scene = scene_of<Kinematics, law::Hencky>(scheme, h, density, {1e-12, 0.3});
  set_step(scene, dt);
  std::array<int, D> cells, per_axis;
  cells.fill(2);
  per_axis.fill(2);
  std::vector<Seed<D>> seeds;
  for (auto const& x : lattice<D>(Point<D>::Constant(-0.21), cells, per_axis, h)) {
    Seed<D> seed;
    seed.x = x;
    seed.mass = 10;
    seed.strain.assign(Strain::size, 0);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) seed.strain[static_cast<std::size_t>(Strain::index(i, j))] = start(i, j);
    seeds.push_back(seed);
  }
  auto const simulation = begin(std::move(scene), seeds);
  for (long k = 0; k < n; ++k) {
    lead<D>(*simulation, increment / dt);
    take_steps(*simulation, 1, cost);
  }
  Square<D> strain;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      auto const values = column(*simulation, "elastic_strain", Strain::index(i, j));
      strain(i, j) = values.front();
      for (double const value : values)
        if (!(std::abs(value - values.front()) < 1e-11)) strain(i, j) = NAN;  // not the same everywhere: a fault
    }
  return strain;
}

template <class Kinematics>
void of(Findings& findings, Scheme const& scheme, std::string const& where) {
  constexpr int D = Kinematics::dimension;
  Square<D> const none = Square<D>::Zero(), I = Square<D>::Identity();
  std::string const subject = scheme.name() + ", " + where;
  Cost unstressed, quarter, slow;
  long const steps = 720;
  Square<D> const step = rotation<D>(20 * std::numbers::pi / steps) - I;
  findings.check(subject, "strain after ten revolutions", led<Kinematics>(scheme, none, step, steps, unstressed).norm(),
                 at_most(1e-10), "(1), 720 steps", unstressed);
  Square<D> strain = none;
  strain(0, 0) = 0.4;
  strain(0, 1) = strain(1, 0) = 0.1;
  Square<D> const R = rotation<D>(std::numbers::pi / 2),
                  turned = led<Kinematics>(scheme, strain, rotation<D>(std::numbers::pi / 18) - I, 9, quarter);
  findings.check(subject, "strain turned by 90 degrees less R eps R^T", (turned - R * strain * R.transpose()).norm(),
                 at_most(1e-12), "(1), nine steps", quarter);
  double spurious[2];
  for (int const halved : {0, 1}) {
    double const angle = 0.02 / (1 + halved);
    long const n = 500 * (1 + halved);
    Square<D> const grown = led<Kinematics>(scheme, none, angle * spin<D>(), n, slow);
    spurious[halved] = grown.trace();
    findings.check(subject, "strain of (I + dt W)^n over (2) - 1",
                   std::abs(grown.trace() / (double(n) * std::log1p(angle * angle)) - 1), at_most(1e-10),
                   "(2), two directions; omega dt = " + std::to_string(angle), slow);
  }
  findings.check(subject, "order of that in dt", std::log2(spurious[0] / spurious[1]), {0.95, 1.05}, "(2): 1");
}

void run(Findings& findings) {
  for (Scheme const& scheme : all_schemes()) {
    if (!scheme.affine()) continue;
    of<kinematics::PlaneStrain>(findings, scheme, "2-D");
    of<kinematics::Solid>(findings, scheme, "3-D");
  }
  findings.omit("pic, flip", "all", "their particles cannot be led: they pass uniform velocities alone");
}

}  // namespace

Case const the_case{"conservation/objectivity",
                    "Rotations turn the strain and make none",
                    "eps' = R eps R^T",
                    "derived in the case's file; the test of rotated stretch: Kamojjala et al. (2015), "
                    "doi:10.1007/s00366-013-0342-x",
                    0,
                    10,
                    run};

}  // namespace talus::verification::conservation_objectivity
