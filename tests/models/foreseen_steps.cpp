#include <boost/test/unit_test.hpp>
#include <limits>

#include "models/boundaries/contacts/stick.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/boundaries/motions/fixed.hpp"
#include "models/boundaries/shapes/half_space.hpp"
#include "models/integrators/musl.hpp"
#include "models/integrators/usl.hpp"
#include "models/kernels/cubic.hpp"
#include "models/kernels/linear.hpp"
#include "models/kernels/quadratic.hpp"
#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/cam_clay_mu_i.hpp"
#include "models/transfers/aflip.hpp"
#include "models/transfers/apic.hpp"
#include "models/transfers/pic.hpp"
#include "tests/support/scenes.hpp"

BOOST_AUTO_TEST_SUITE(foreseen_steps)

using namespace talus;
using namespace talus::support;

namespace {

constexpr double h = 0.01;

/// A heap that falls upon a floor.
template <class Kinematics, class K, class T, class I>
std::unique_ptr<Simulation<Kinematics::dimension>> heap(double gravity) {
  constexpr int D = Kinematics::dimension;
  auto scene = scene_of<Kinematics, law::CamClayMuI, K, T, I>(h, 1550, {}, {});
  scene.gravity[1] = -gravity;
  wall::HalfSpace::Parameters floor;
  floor.normal = {0, 1, 0};
  scene.walls.push_back(make_wall<D, wall::HalfSpace, wall::Stick, wall::Fixed>("floor", floor, {}, {}));
  auto simulation = std::make_unique<Simulation<D>>(std::move(scene));
  Point<D> const low = Point<D>::Constant(h), high = low + Point<D>::Constant(D == 2 ? 0.12 : 0.06);
  auto seeds = block<D>(low, high, h, 2, 1550, 0.3, 3);
  for (auto& seed : seeds) seed.v[0] = 20 * seed.x[1];  // 1/s: sheared, so that particles cross blocks
  fill(*simulation, seeds);
  return simulation;
}

/// Takes steps with and without what was scattered ahead: whoever asks for the particles may change them, so that the
/// next step must scatter by itself.
template <class Kinematics, class K, class T, class I>
void compare(double gravity, int steps) {
  auto const ahead = heap<Kinematics, K, T, I>(gravity), anew = heap<Kinematics, K, T, I>(gravity);
  for (int k = 0; k < steps; ++k) {
    ahead->advance(std::numeric_limits<double>::infinity());
    static_cast<void>(anew->particles());
    anew->advance(std::numeric_limits<double>::infinity());
  }
  BOOST_TEST(ahead->sorts() > 1);
  BOOST_TEST(ahead->sorts() == anew->sorts());
  for (auto const& field : ahead->particles().layout().columns())
    for (int c = 0; c < field.components; ++c)
      BOOST_TEST(column(*ahead, field.info.name, c) == column(*anew, field.info.name, c),
                 boost::test_tools::per_element());
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_step_that_was_scattered_ahead_has_the_bits_of_one_that_scatters_by_itself) {
  using Plane = kinematics::PlaneStrainReduced;
  using Space = kinematics::Solid;
  compare<Plane, kernel::Quadratic, transfer::Apic, integrator::Usl>(9.81, 150);
  compare<Plane, kernel::Cubic, transfer::Aflip, integrator::Musl>(9.81, 150);
  compare<Plane, kernel::Linear, transfer::Pic, integrator::Usl>(9.81, 150);
  compare<Space, kernel::Quadratic, transfer::Aflip, integrator::Usl>(9.81, 100);
  compare<Space, kernel::Cubic, transfer::Apic, integrator::Musl>(9.81, 100);
}

// So strong a pull moves particles further in a step than the step before let expect: they are out of their arenas
// before a sort is due, and must not be scattered there.
BOOST_AUTO_TEST_CASE(particles_that_outrun_their_arenas_are_not_scattered) {
  compare<kinematics::PlaneStrainReduced, kernel::Quadratic, transfer::Apic, integrator::Usl>(2e4, 60);
  compare<kinematics::Solid, kernel::Cubic, transfer::Aflip, integrator::Usl>(2e4, 60);
}

BOOST_AUTO_TEST_SUITE_END()
