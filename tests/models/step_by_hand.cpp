#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "models/boundaries/contacts/separating.hpp"
#include "models/boundaries/contacts/stick.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/boundaries/motions/fixed.hpp"
#include "models/boundaries/shapes/half_space.hpp"
#include "models/integrators/usl.hpp"
#include "models/kernels/cubic.hpp"
#include "models/kernels/linear.hpp"
#include "models/kernels/quadratic.hpp"
#include "models/kinematics/plane_strain.hpp"
#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/cam_clay_mu_i.hpp"
#include "models/laws/hencky.hpp"
#include "models/transfers/aflip.hpp"
#include "models/transfers/apic.hpp"
#include "models/transfers/flip.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/step_by_hand.hpp"

BOOST_AUTO_TEST_SUITE(step_by_hand)

using namespace talus;
using support::ByHand, support::Seed;

namespace {

/// Sixty steps round some hundred times each, by 1e-16 of the largest value; what leaves a yield surface or a wall at
/// another instant would differ by 1e-6 and more.
constexpr double tolerance = 1e-11;
constexpr int steps = 60;

double largest(std::vector<double> const& values) {
  double most = 0;
  for (double const v : values) most = std::max(most, std::abs(v));
  return most;
}

/// Largest difference of a component over its largest value, `least` where it has none.
template <int D, class F>
double difference(Simulation<D> const& simulation, std::string_view field, int components, double least, F const& of) {
  double worst = 0, scale = least;
  for (int c = 0; c < components; ++c) {
    auto const values = support::column(simulation, field, c);
    scale = std::max(scale, largest(values));
    for (std::size_t k = 0; k < values.size(); ++k) worst = std::max(worst, std::abs(values[k] - of(k, c)));
  }
  return worst / scale;
}

template <class Hand>
void agree(Hand const& hand, Simulation<Hand::D> const& simulation) {
  constexpr int D = Hand::D, strains = Symmetric<double, typename Hand::Shape>::size;
  auto const of = [&](auto const& member) {
    return [&](std::size_t k, int c) { return (hand.particles[k].*member)[c]; };
  };
  using P = typename Hand::Particle;
  BOOST_TEST(difference(simulation, "position", D, 0, of(&P::x)) < tolerance);
  BOOST_TEST(difference(simulation, "velocity", D, 0, of(&P::v)) < tolerance);
  BOOST_TEST(difference(simulation, "elastic_strain", strains, 0, of(&P::strain)) < tolerance);
}

/// Takes the steps of the simulation by hand, too.
template <class Hand>
void step_both(Hand& hand, Simulation<Hand::D>& simulation) {
  for (int k = 0; k < steps; ++k) {
    simulation.advance(std::numeric_limits<double>::infinity());
    hand.step(simulation.last_step().dt);
  }
}

/// Walls at y = 0, which holds, and at x = 0, which only pushes.
template <int D>
void add_walls(Scene<D>& scene) {
  wall::HalfSpace::Parameters floor, back;
  floor.normal = {0, 1, 0};
  back.normal = {1, 0, 0};
  scene.walls.push_back(make_wall<D, wall::HalfSpace, wall::Stick, wall::Fixed>("floor", floor, {}, {}));
  scene.walls.push_back(make_wall<D, wall::HalfSpace, wall::Separating, wall::Fixed>("back", back, {}, {}));
}
template <int D>
Point<D> walled(Point<D> const& x, Point<D> const& to, Point<D> v) {
  if (x[1] <= 0 || to[1] <= 0) return Point<D>::Zero();
  if (to[0] <= 0) v[0] = std::max(v[0], 0.0);
  return v;
}

/// A body in the corner of the two walls, thrown into it.
template <int D>
std::vector<Seed<D>> thrown(double spacing, double density, Point<D> const& v) {
  Point<D> const low = Point<D>::Constant(0.5 * spacing);
  Point<D> high = low + Point<D>::Constant((D == 2 ? 8 : 3) * spacing);
  high[1] += 2 * spacing;
  auto seeds = support::block<D>(low, high, spacing, 2, density, 0.4, 7);
  for (auto& seed : seeds) seed.v = v;
  return seeds;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_granular_body_in_a_corner_steps_as_by_hand_with_the_quadratic_kernel_and_aflip) {
  using Law = law::CamClayMuI;
  constexpr double h = 0.01, density = 1550, alpha = 0.95;
  Law::Parameters parameters;
  parameters.mu_1 = 0.4;
  parameters.d = 7e-4;
  auto scene =
      support::scene_of<kinematics::PlaneStrainReduced, Law, kernel::Quadratic, transfer::Aflip, integrator::Usl>(
          h, density, parameters, {alpha});
  scene.gravity = {3.7, -9.1};
  add_walls(scene);
  Simulation<2> simulation(std::move(scene));
  auto const seeds = thrown<2>(h, density, {-0.3, -0.5});
  support::fill(simulation, seeds);
  ByHand<kinematics::PlaneStrainReduced, Law> hand{2,           true,     alpha, h, density, 0, Law(parameters),
                                                   {3.7, -9.1}, walled<2>};
  hand.fill(seeds);
  step_both(hand, simulation);
  agree(hand, simulation);
  // The affine velocity, row by row, and the plastic strain, which the law must have produced.
  BOOST_TEST(difference(simulation, "affine_velocity", 4, 0,
                        [&](std::size_t k, int c) { return hand.particles[k].C(c / 2, c % 2); }) < tolerance);
  BOOST_TEST(difference(simulation, "plastic_volumetric_strain", 1, 0,
                        [&](std::size_t k, int) { return hand.particles[k].state.values[0]; }) < tolerance);
  BOOST_TEST(largest(support::column(simulation, "plastic_volumetric_strain")) > 1e-5);
  BOOST_TEST(simulation.momentum().walls[0].norm() > 0);
  BOOST_TEST(simulation.momentum().walls[1].norm() > 0);
}

BOOST_AUTO_TEST_CASE(an_elastic_body_in_space_steps_as_by_hand_with_the_cubic_kernel_and_apic) {
  using Law = law::Hencky;
  constexpr double h = 0.1, density = 1000;
  Law::Parameters const parameters{1e5, 0.3};
  auto scene = support::scene_of<kinematics::Solid, Law, kernel::Cubic, transfer::Apic, integrator::Usl>(
      h, density, parameters, {});
  scene.gravity = {0.5, -9.81, 0.2};
  add_walls(scene);
  Simulation<3> simulation(std::move(scene));
  auto const seeds = thrown<3>(h, density, {-0.6, -0.8, 0.3});
  support::fill(simulation, seeds);
  ByHand<kinematics::Solid, Law> hand{3, true, 0, h, density, 0, Law(parameters), {0.5, -9.81, 0.2}, walled<3>};
  hand.fill(seeds);
  step_both(hand, simulation);
  agree(hand, simulation);
  BOOST_TEST(difference(simulation, "affine_velocity", 9, 0,
                        [&](std::size_t k, int c) { return hand.particles[k].C(c / 3, c % 3); }) < tolerance);
}

BOOST_AUTO_TEST_CASE(an_elastic_body_in_the_plane_steps_as_by_hand_with_the_linear_kernel_and_flip) {
  using Law = law::Hencky;
  constexpr double h = 0.1, density = 1000;
  Law::Parameters const parameters{1e5, 0.3};
  auto scene = support::scene_of<kinematics::PlaneStrain, Law, kernel::Linear, transfer::Flip, integrator::Usl>(
      h, density, parameters, {1});
  scene.gravity = {0.5, -9.81};
  add_walls(scene);
  Simulation<2> simulation(std::move(scene));
  auto const seeds = thrown<2>(h, density, {-0.6, -0.8});
  support::fill(simulation, seeds);
  double const least_mass = 0.1 * seeds.front().mass;  // what internal forces accelerate with this kernel
  ByHand<kinematics::PlaneStrain, Law> hand{1,        false, 1, h, density, least_mass, Law(parameters), {0.5, -9.81},
                                            walled<2>};
  hand.fill(seeds);
  step_both(hand, simulation);
  agree(hand, simulation);
}

BOOST_AUTO_TEST_SUITE_END()
