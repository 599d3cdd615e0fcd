#include <boost/math/special_functions/lambert_w.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/dual.hpp"
#include "models/laws/drucker_prager.hpp"
#include "models/laws/hencky.hpp"
#include "models/laws/modified_cam_clay.hpp"
#include "models/laws/neo_hookean.hpp"
#include "tests/support/law_states.hpp"
#include "tests/support/material_point.hpp"

BOOST_AUTO_TEST_SUITE(laws_closed_forms)

using namespace talus;
using boost::math::lambert_w0;
using boost::test_tools::tolerance;
using support::MaterialPoint;
using support::simple_shear;

namespace {

constexpr double round_off = 1e-14;

/// Young's modulus [Pa] that makes K = E/(3 (1 - 2 nu)) = 833300 Pa in three dimensions at nu = 0.3.
constexpr double bulk_833300 = 999960;

}  // namespace

BOOST_AUTO_TEST_CASE(hencky_stress_of_a_uniaxial_stretch_is_the_p_wave_modulus_times_its_logarithm) {
  law::Hencky const law(law::Hencky::Parameters{});
  Symmetric<double, shape::Solid> eps{};
  eps[0] = std::log(1.3);
  auto const tau = law.stress(eps);
  // E (1 - nu)/((1 + nu)(1 - 2 nu)) and nu/(1 - nu) of it across, E = 1e6, nu = 0.3
  double const along = 1e6 * 0.7 / (1.3 * 0.4) * std::log(1.3);
  BOOST_TEST(tau[0] == along, tolerance(round_off));
  BOOST_TEST(tau[1] == along * 3 / 7, tolerance(round_off));
  BOOST_TEST(tau[3] == 0);
}

BOOST_AUTO_TEST_CASE(neo_hookean_stress_of_a_stretch_and_of_a_simple_shear_are_those_of_the_textbook) {
  law::NeoHookean const law(law::NeoHookean::Parameters{});
  double const stretch = 1.7;
  Symmetric<double, shape::PlaneStrain> eps{};
  eps[0] = std::log(stretch);
  auto const tau = law.stress(eps);
  BOOST_TEST(tau[0] == law.G * (stretch * stretch - 1) + law.lambda * std::log(stretch), tolerance(round_off));
  BOOST_TEST(tau[2] == law.lambda * std::log(stretch), tolerance(round_off));

  // F = I + gamma e1 (x) e2: b = [[1 + gamma^2, gamma], [gamma, 1]], ln b = 2 k [[gamma/2, 1], [1, -gamma/2]],
  // k = asinh(gamma/2)/sqrt(4 + gamma^2)
  double const gamma = 2.5, k = std::asinh(gamma / 2) / std::sqrt(4 + gamma * gamma);
  Symmetric<double, shape::Plane> shear{{k * gamma, -k * gamma, 2 * k}};
  auto const sheared = law.stress(shear);
  double const tolerated = 64 * std::numeric_limits<double>::epsilon() * law.G * gamma * gamma;
  BOOST_TEST(std::abs(sheared[0] - law.G * gamma * gamma) < tolerated);
  BOOST_TEST(std::abs(sheared[1]) < tolerated);
  BOOST_TEST(std::abs(sheared[2] - law.G * gamma) < tolerated);
}

BOOST_AUTO_TEST_CASE(drucker_prager_scales_the_deviator_to_the_line_and_returns_tension_to_the_tip) {
  law::DruckerPrager::Parameters parameters;
  parameters.M = 0.5;
  parameters.c = 20;
  law::DruckerPrager const law(parameters);
  MaterialPoint<shape::Plane, law::DruckerPrager> sheared{law}, torn{law};
  sheared.step(support::strain_of<shape::Plane>(law, 100, 200), 1);
  BOOST_TEST(sheared.p() == 100, tolerance(round_off));
  BOOST_TEST(sheared.q() == 0.5 * 100 + 20, tolerance(round_off));
  BOOST_TEST(sheared.state[field::plastic_volumetric_strain] == 0);

  torn.step(support::strain_of<shape::Plane>(law, -1000, 5), 1);
  BOOST_TEST(torn.p() == -20 / 0.5, tolerance(round_off));
  BOOST_TEST(torn.q() == 0);
  BOOST_TEST(torn.state[field::plastic_volumetric_strain] == (1000 - 40) / law.bulk<shape::Plane>(),
             tolerance(round_off));
}

BOOST_AUTO_TEST_CASE(isotropic_compression_is_exact_at_any_step_size) {
  // ln(V_0/V) = p/K + ln(p/p_c0)/xi, so p = (K/xi) W0((xi p_c0/K) exp(xi ln(V_0/V)))
  law::CamClay::Parameters parameters;
  parameters.E = bulk_833300;
  law::CamClay const law(parameters);
  double const K = law.bulk<shape::Solid>(), xi = 50, p_c0 = 100, compaction = 0.08;
  double const exact = K / xi * lambert_w0(xi * p_c0 / K * std::exp(xi * compaction));
  BOOST_TEST(exact == 4234.734631528, tolerance(1e-9));  // found independently with the same formula
  for (int const steps : {1, 7, 1000}) {
    MaterialPoint<shape::Solid, law::CamClay> point{law};
    for (int k = 0; k < steps; ++k) point.step(isotropic<shape::Solid>(-compaction / steps / 3), 1);
    BOOST_TEST(point.p() == exact, tolerance(1e-11));
    BOOST_TEST(point.q() < 1e-11 * exact);
    BOOST_TEST(point.derived(field::compressive_strength) == exact, tolerance(1e-11));
  }
}

BOOST_AUTO_TEST_CASE(shear_at_constant_volume_ends_at_critical_state) {
  // p + (K/xi) ln(p_c/p_c0) = p_i on the way, and p_c = 2 p/(1 - beta), q = M w p at its end
  for (double const beta : {0.0, 0.2}) {
    law::CamClay::Parameters parameters;
    parameters.E = bulk_833300;
    parameters.beta = beta;
    law::CamClay const law(parameters);
    double const K = law.bulk<shape::Solid>(), xi = 50, p_c0 = 100, p_i = 60;
    double const p_f = K / xi * lambert_w0(xi * p_c0 * (1 - beta) / (2 * K) * std::exp(xi * p_i / K));
    MaterialPoint<shape::Solid, law::CamClay> point{law};
    point.step(isotropic<shape::Solid>(-p_i / (3 * K)), 1);
    for (int k = 0; k < 4000; ++k) {
      point.step(simple_shear<shape::Solid>(1e-3), 1);
      double const p_c = point.derived(field::compressive_strength);
      // p_c = p_c0 exp(...) and its logarithm: eps K/xi
      if (k % 100 == 0) BOOST_TEST(std::abs(point.p() + K / xi * std::log(p_c / p_c0) - p_i) < 1e-11 * K / xi);
    }
    BOOST_TEST(point.p() == p_f, tolerance(1e-11));
    BOOST_TEST(point.q() == parameters.M * (1 + beta) / (1 - beta) * p_f, tolerance(1e-11));
    if (beta == 0) BOOST_TEST(p_f == 50.029920384, tolerance(1e-10));  // integration of the rate form: 50.02992038
  }
}

BOOST_AUTO_TEST_CASE(both_hardenings_start_at_p_c0_with_their_slopes) {
  law::Strength::Parameters const parameters{.p_c0 = 250, .xi = 40};
  law::ExponentialHardening const exponential(parameters);
  law::HyperbolicSineHardening const sine(parameters);
  double const K = 1e6;
  BOOST_TEST(exponential.strength(0.0, K) == 250.0, tolerance(round_off));
  BOOST_TEST(sine.strength(0.0, K) == 250.0, tolerance(round_off));
  // 250 e^2 and 1e6 sinh(2 + asinh(2.5e-4))
  BOOST_TEST(exponential.strength(-0.05, K) == 250 * std::exp(2.0), tolerance(round_off));
  BOOST_TEST(sine.strength(-0.05, K) == K * std::sinh(2 + std::asinh(250 / K)), tolerance(round_off));
  for (double const eps : {-0.1, -0.001, 0.0, 5e-6}) {
    Dual<1> const at = Dual<1>::variable(eps, 0);
    BOOST_TEST(exponential.slope(exponential.strength(eps, K), K) == exponential.strength(at, K).derivative(0),
               tolerance(round_off));
    BOOST_TEST(sine.slope(sine.strength(eps, K), K) == sine.strength(at, K).derivative(0), tolerance(1e-11));
  }
  // the hyperbolic sine is at its floor after a dilation of asinh(p_c0/K)/xi, the exponential is not
  BOOST_TEST(sine.strength(1.01 * std::asinh(250 / K) / 40, K) == 250e-9, tolerance(round_off));
  BOOST_TEST(exponential.strength(0.1, K) == 250 * std::exp(-4.0), tolerance(round_off));
}

BOOST_AUTO_TEST_SUITE_END()
