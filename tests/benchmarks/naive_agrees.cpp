/// The baseline of the speed ratios computes what Talus computes, particle by particle.

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "benchmarks/naive/solver.hpp"
#include "benchmarks/scenes/compose.hpp"
#include "models/integrators/usl.hpp"
#include "models/kernels/cubic.hpp"
#include "models/kernels/quadratic.hpp"
#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/hencky.hpp"
#include "models/transfers/apic.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/symmetric_function.hpp"

BOOST_AUTO_TEST_SUITE(naive_agrees)

using namespace talus;

namespace {

/// Of positions and velocities, over the largest. Each of sixty steps rounds some hundred times by 1e-16 of the largest
/// value, and the elastic waves hand on what was rounded: 1e-13 is expected. A wall that acted on another node would
/// show as 1e-4 and more.
constexpr double tolerance = 1e-11;
/// Of a component of the strain, absolute. The baseline carries F, of order 1, through sixty products: each rounds by
/// some 1e-16. Velocities that differ by 1e-13 m/s over h = 0.01 m add less than that.
constexpr double strain_tolerance = 1e-13;
constexpr int steps = 60;
template <class K, class W>
struct Choices {
  using Kinematics = K;
  using Kernel = W;
  using Transfer = transfer::Apic;
  using Integrator = integrator::Usl;
  using Law = law::Hencky;
};

/// Largest differences: of places and velocities relative to the largest, of strains absolute.
struct Difference {
  double place = 0, velocity = 0, strain = 0;
};

/// A block that whirls and is thrown into the corner.
template <int D>
bench::Cloud<D> thrown(Point<D> const& low) {
  bench::Filling filling;
  filling.particles = 3000;
  filling.a_cell = D == 2 ? 6 : 8;
  auto cloud = bench::block<D>(filling, low);
  Point<D> velocity = Point<D>::Constant(-0.7);
  velocity[1] = -0.9;
  for (auto& v : cloud.velocities) v += velocity;
  return cloud;
}

template <int D>
Point<D> gravity() {
  Point<D> g = Point<D>::Constant(0.8);
  g[1] = -9.81;
  return g;
}

/// 1/2 ln(F F^T).
template <int D>
Eigen::Matrix<double, D, D> strain(Eigen::Matrix<double, D, D> const& F) {
  Eigen::Matrix<double, D, D> const squared = F * F.transpose();
  return support::symmetric_function(squared, [](double b) { return 0.5 * std::log(b); });
}

template <int D, class Shape>
Difference between(Simulation<D> const& simulation, std::vector<naive::Particle<D>> const& particles) {
  Difference worst;
  auto const x = support::vectors(simulation, "position"), v = support::vectors(simulation, "velocity");
  double farthest = 0, fastest = 0;
  for (std::size_t k = 0; k < particles.size(); ++k) {
    farthest = std::max(farthest, x[k].cwiseAbs().maxCoeff());
    fastest = std::max(fastest, v[k].cwiseAbs().maxCoeff());
    worst.place = std::max(worst.place, (x[k] - particles[k].x).cwiseAbs().maxCoeff());
    worst.velocity = std::max(worst.velocity, (v[k] - particles[k].v).cwiseAbs().maxCoeff());
  }
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j) {
      auto const eps = support::column(simulation, "elastic_strain", Symmetric<double, Shape>::index(i, j));
      for (std::size_t k = 0; k < particles.size(); ++k)
        worst.strain = std::max(worst.strain, std::abs(eps[k] - strain<D>(particles[k].F)(i, j)));
    }
  worst.place /= farthest;
  worst.velocity /= fastest;
  return worst;
}

/// Both take the steps of Talus; the shear modulus of the baseline is off by a factor.
template <class K, class W, class Spline>
Difference after_sixty_steps(Point<K::dimension> const& low, double factor) {
  constexpr int D = K::dimension;
  auto const cloud = thrown<D>(low);
  Setup<Choices<K, W>> setup;
  setup.spacing = cloud.spacing;
  setup.density = 1550;
  setup.gravity = gravity<D>();
  auto simulation = bench::simulate<Choices<K, W>>(setup, {cloud}, bench::corner<D>(low));
  law::Moduli const moduli(setup.law);
  naive::Solver<D, Spline> solver(cloud, {setup.density, moduli.lambda, factor * moduli.G}, setup.gravity);
  BOOST_TEST_REQUIRE(simulation->particles().count() == solver.particles().size());
  for (int k = 0; k < steps; ++k) {
    simulation->advance(std::numeric_limits<double>::infinity());
    solver.step(simulation->last_step().dt);
  }
  for (auto const& impulse : simulation->momentum().walls) BOOST_TEST(impulse.norm() > 0);  // all have acted
  return between<D, typename K::Shape>(*simulation, solver.particles());
}

/// Agreement with walls through nodes and between them; and that a shear modulus off by 1e-6 is noticed.
template <class K, class W, class Spline>
void agree() {
  using Corner = Point<K::dimension>;
  Corner const between_nodes = Corner::LinSpaced(0.0237, -0.0171);
  for (Corner const& low : {Corner(Corner::Zero()), between_nodes}) {
    auto const same = after_sixty_steps<K, W, Spline>(low, 1);
    BOOST_TEST(same.place < tolerance);
    BOOST_TEST(same.velocity < tolerance);
    BOOST_TEST(same.strain < strain_tolerance);
    BOOST_TEST_MESSAGE("place " << same.place << ", velocity " << same.velocity << ", strain " << same.strain);
  }
  auto const other = after_sixty_steps<K, W, Spline>(Corner::Zero(), 1 + 1e-6);
  BOOST_TEST_MESSAGE("other G: " << other.place << ", velocity " << other.velocity << ", strain " << other.strain);
  BOOST_TEST(other.place > 100 * tolerance);
  BOOST_TEST(other.velocity > 100 * tolerance);
  BOOST_TEST(other.strain > 100 * strain_tolerance);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_baseline_steps_as_talus_in_the_plane_with_the_quadratic_kernel) {
  agree<kinematics::PlaneStrainReduced, kernel::Quadratic, naive::Quadratic>();
}

BOOST_AUTO_TEST_CASE(the_baseline_steps_as_talus_in_the_plane_with_the_cubic_kernel) {
  agree<kinematics::PlaneStrainReduced, kernel::Cubic, naive::Cubic>();
}

BOOST_AUTO_TEST_CASE(the_baseline_steps_as_talus_in_space_with_the_quadratic_kernel) {
  agree<kinematics::Solid, kernel::Quadratic, naive::Quadratic>();
}

BOOST_AUTO_TEST_CASE(the_baseline_steps_as_talus_in_space_with_the_cubic_kernel) {
  agree<kinematics::Solid, kernel::Cubic, naive::Cubic>();
}

BOOST_AUTO_TEST_CASE(a_particle_that_leaves_the_grid_of_the_baseline_is_named) {
  auto cloud = thrown<2>(Point<2>::Zero());
  cloud.places = {{0.02, 0.02}, {0.15, 0.15}};
  cloud.velocities = {{0, 0}, {0, 1e6}};
  naive::Solver<2, naive::Quadratic> solver(cloud, {1550, 0, 0}, Point<2>::Zero());
  BOOST_CHECK_EXCEPTION(solver.step(1e-3), std::runtime_error, [](std::runtime_error const& error) {
    return error.what() == std::string("particle 1 has left the grid");
  });
}

BOOST_AUTO_TEST_SUITE_END()
