#include "core/material_point.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/errors.hpp"
#include "models/kinematics/plane_strain.hpp"
#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/cam_clay_mu_i.hpp"
#include "models/laws/hencky.hpp"
#include "models/laws/modified_cam_clay.hpp"
#include "models/make.hpp"
#include "tests/support/says.hpp"

BOOST_AUTO_TEST_SUITE(material_point)

using namespace talus;
using boost::test_tools::tolerance;

namespace {

template <class K, class L>
MaterialPoint<K::dimension> point_of(typename L::Parameters const& parameters) {
  return {make_material<K, L>("point", 1, parameters), Symmetric<double, typename K::Shape>::size};
}

double value(PointExperiment const& point, std::string const& name) {
  auto const quantities = point.quantities();
  auto const row = point.measure();
  BOOST_REQUIRE(quantities.size() == row.size());
  for (std::size_t k = 0; k < row.size(); ++k)
    if (quantities[k].name == name) return row[k];
  BOOST_FAIL("no quantity " + name);
  return 0;
}

Control rate(double value) {
  return {.rate = value};
}
Control stress(double to) {
  return {.of_stress = true, .target = to};
}
constexpr Control held{.of_stress = true};

void go(PointExperiment& point, double duration, int steps, std::array<Control, 6> const& controls) {
  follow(point, {"", duration, steps, controls}, [] {});
}

/// Friction of steady shear (docs/theory/mu_i.md): mu(I) with omega = (1 + beta)/(1 - beta).
double steady_friction(law::CamClayMuI::Parameters const& p, double shear_rate, double pressure) {
  double const omega = (1 + p.beta) / (1 - p.beta), I = p.d * shear_rate * std::sqrt(p.rho_s / pressure);
  return omega * (p.mu_1 + (p.mu_2 - p.mu_1) / (std::sqrt(omega) * p.I_0 / I + 1));
}

}  // namespace

// The strain of the point is that of the law by hand, step by step, on a path that turns and yields.
BOOST_AUTO_TEST_CASE(a_led_motion_gives_the_strain_and_state_of_the_law) {
  law::CamClayMuI::Parameters parameters;
  parameters.beta = 0.2;
  law::CamClayMuI const law(parameters);
  auto point = point_of<kinematics::Solid, law::CamClayMuI>(parameters);
  Symmetric<double, shape::Solid> eps{};
  auto state = law.initial<shape::Solid>();
  double const dt = 1e-4;
  Components6 const motion{-2e-5, -1e-5, 1e-5, 4e-5, 1e-5, -3e-5};
  for (int n = 1; n <= 300; ++n) {
    point.step(motion, {}, n * dt);
    Matrix<double, 3> H{};
    H(0, 0) = motion[0], H(1, 1) = motion[1], H(2, 2) = motion[2];
    H(0, 1) = motion[3], H(0, 2) = motion[4], H(1, 2) = motion[5];
    eps = law.project(trial_strain(eps, H), state, dt);
  }
  auto const tau = law.stress(eps);
  double const scale = pressure(tau) + shear_stress(tau);
  BOOST_TEST_REQUIRE(value(point, "shear_stress") > 1);
  for (std::size_t c = 0; c < 6; ++c)
    BOOST_TEST(std::abs(point.stress()[c] - tau[static_cast<int>(c)]) < 1e-11 * scale);
  BOOST_TEST(value(point, "plastic_volumetric_strain") == state[field::plastic_volumetric_strain], tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(an_elastic_point_under_uniaxial_stress_has_young_s_modulus) {
  auto point = point_of<kinematics::Solid, law::Hencky>({.E = 1e6, .nu = 0.3});
  go(point, 1, 7, {held, stress(-1e4), held, held, held, held});
  // exact in the logarithmic strain; a step multiplies a length by 1 + motion
  BOOST_TEST(value(point, "volume_strain") == -1e4 / 1e6 * (1 - 2 * 0.3), tolerance(1e-11));
  BOOST_TEST(value(point, "stress_xx") == 0, tolerance(1e-9));
  BOOST_TEST(value(point, "elastic_energy") == 0.5 * 1e8 / 1e6, tolerance(1e-9));
}

// Stress paths of all components, to the digit, through yield: what is asked for is what is there after each step.
BOOST_AUTO_TEST_CASE(a_led_stress_is_reached_after_every_step) {
  law::CamClayMuI::Parameters parameters;
  parameters.p_c0 = 400;
  auto point = point_of<kinematics::Solid, law::CamClayMuI>(parameters);
  go(point, 0.01, 50, {stress(-100), stress(-100), stress(-100), rate(0), rate(0), rate(0)});
  for (double const c : {0, 1, 2}) BOOST_TEST(point.stress()[static_cast<std::size_t>(c)] == -100, tolerance(1e-11));
  double worst = 0;
  follow(point, {"shear", 0.2, 2000, {rate(0), held, rate(0), rate(1), rate(0), rate(0)}},
         [&] { worst = std::max(worst, std::abs(point.stress()[1] + 100)); });
  BOOST_TEST(worst < 1e-8);
  BOOST_TEST(value(point, "iterations") <= 5);
  go(point, 0.2, 2000, {stress(-120), stress(-100), held, stress(20), stress(5), stress(-5)});
  BOOST_TEST(point.stress()[0] == -120, tolerance(1e-9));
  BOOST_TEST(point.stress()[5] == -5, tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(steady_shear_has_the_friction_of_mu_of_I_with_cohesion) {
  for (double const beta : {0.0, 0.1, 0.2, 0.3})
    for (double const shear_rate : {0.5, 20.0, 300.0}) {
      law::CamClayMuI::Parameters parameters;
      parameters.p_c0 = 400, parameters.xi = 100, parameters.beta = beta;
      auto point = point_of<kinematics::PlaneStrainReduced, law::CamClayMuI>(parameters);
      go(point, 0.01, 100, {stress(-100), stress(-100)});
      go(point, 1 / shear_rate, 5000, {rate(0), held, rate(0), rate(shear_rate)});
      double const found = value(point, "stress_ratio");
      BOOST_TEST(found == steady_friction(parameters, shear_rate, value(point, "pressure")), tolerance(1e-7));
    }
}

// Full plane strain carries a stress across the plane; its critical state is that of space.
BOOST_AUTO_TEST_CASE(the_stress_across_the_plane_tends_to_the_pressure) {
  auto point = point_of<kinematics::PlaneStrain, law::CamClay>({});
  go(point, 0.01, 100, {rate(-0.1), rate(-0.1)});
  go(point, 1, 20000, {rate(0), rate(0), rate(0), rate(1)});
  BOOST_TEST(value(point, "stress_zz") == -value(point, "pressure"), tolerance(1e-4));
  BOOST_TEST(value(point, "stress_ratio") == law::CamClay::Parameters{}.M, tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(what_the_law_cannot_carry_is_told) {
  auto point = point_of<kinematics::Solid, law::CamClay>({});
  go(point, 0.01, 50, {stress(-10), stress(-10), stress(-10), rate(0), rate(0), rate(0)});
  BOOST_CHECK_EXCEPTION(go(point, 1, 100, {held, stress(5), held, rate(0), rate(0), rate(0)}), RunError,
                        support::says("no motion was found"));
  BOOST_CHECK_EXCEPTION(go(point, 1, 1, {rate(-2), rate(0), rate(0), rate(0), rate(0), rate(0)}), RunError,
                        support::says("inside out"));
}

BOOST_AUTO_TEST_SUITE_END()
