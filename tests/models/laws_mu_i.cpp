#include <boost/test/unit_test.hpp>
#include <cmath>

#include "models/laws/cam_clay_mu_i.hpp"
#include "models/laws/modified_cam_clay.hpp"
#include "tests/support/law_states.hpp"
#include "tests/support/material_point.hpp"

BOOST_AUTO_TEST_SUITE(laws_mu_i)

using namespace talus;
using boost::test_tools::tolerance;
using support::MaterialPoint;
using support::simple_shear;
using support::tan_deg;

namespace {

constexpr double round_off = 1e-14;

/// Simple shear by gamma, with the change of volume that keeps the pressure at p.
template <class Shape, class L>
void shear_at_pressure(MaterialPoint<Shape, L>& point, double gamma, double p, double dt) {
  auto const moved = [&](double volume) {
    auto copy = point;
    copy.step(simple_shear<Shape>(gamma) + isotropic<Shape>(volume / Shape::normals), dt);
    return copy;
  };
  double low = -1e-3, high = 1e-3;  // pressure falls with volume
  for (int k = 0; k < 70; ++k) {
    double const middle = 0.5 * (low + high);
    (moved(middle).p() > p ? low : high) = middle;
  }
  auto const after = moved(0.5 * (low + high));
  point.eps = after.eps;
  point.state = after.state;
}

law::CamClayMuI::Parameters glass_beads(double beta) {
  law::CamClayMuI::Parameters p;
  p.mu_1 = tan_deg(20.9);
  p.mu_2 = tan_deg(32.76);
  p.beta = beta;
  return p;
}

/// mu = w (mu_1 + (mu_2 - mu_1)/(sqrt(w) I_0/I + 1)), w = (1 + beta)/(1 - beta): q/p at critical state.
double critical_friction(law::CamClayMuI::Parameters const& m, double shear_rate, double p) {
  double const w = (1 + m.beta) / (1 - m.beta), I = m.d * shear_rate * std::sqrt(m.rho_s / p);
  return w * (m.mu_1 + (m.mu_2 - m.mu_1) / (std::sqrt(w) * m.I_0 / I + 1));
}

}  // namespace

BOOST_AUTO_TEST_CASE(shear_at_constant_pressure_recovers_mu_of_I) {
  // printed by an earlier driver in another language: p = 100 Pa, p_c0 = 400 Pa, xi = 100, 20/s
  struct Row {
    double beta, friction, eps_V;
  };
  for (auto const& row : {Row{0.0, 0, 0.0069315}, Row{0.1, 0.60985957, 0.0058779}, Row{0.2, 0.73859020, 0.0047000},
                          Row{0.3, 0.90190194, 0.0033647}}) {
    auto parameters = glass_beads(row.beta);
    parameters.p_c0 = 400;
    parameters.xi = 100;
    law::CamClayMuI const law(parameters);
    double const p = 100, shear_rate = 20, dt = 1e-4;
    MaterialPoint<shape::Plane, law::CamClayMuI> point{law};
    point.eps = isotropic<shape::Plane>(-p / law.volumetric_modulus<shape::Plane>());
    for (int k = 0; k < 1500; ++k) shear_at_pressure(point, shear_rate * dt, p, dt);

    double const friction = point.q() / point.p(), w = (1 + row.beta) / (1 - row.beta);
    BOOST_TEST_CONTEXT("beta " << row.beta) {
      BOOST_TEST(friction == critical_friction(parameters, shear_rate, p), tolerance(1e-9));
      if (row.friction > 0) BOOST_TEST(friction == row.friction, tolerance(1e-8));
      double const eps_V = point.state[field::plastic_volumetric_strain];
      BOOST_TEST(eps_V == std::log(400 * (1 - row.beta) / (2 * p)) / 100, tolerance(1e-9));
      BOOST_TEST(eps_V == row.eps_V, tolerance(1e-4));
      BOOST_TEST(point.derived(field::shear_rate) == shear_rate, tolerance(1e-9));
      BOOST_TEST(point.derived(field::friction) == friction / w, tolerance(1e-9));
      BOOST_TEST(point.derived(field::inertial_number) == 2.5e-3 * shear_rate * std::sqrt(2500 / (w * p)),
                 tolerance(1e-9));
    }
  }
}

BOOST_AUTO_TEST_CASE(start_up_at_critical_state_is_first_order_in_time_with_an_exact_fixed_point) {
  // x = q/p, x' = (G/p)(rate - gamma), gamma = a (x - mu_1)/(mu_2 - x), a = (I_0/d) sqrt(p/rho_s), from x = mu_1:
  // t(x) = (p/G)/(rate + a) ((x - mu_1) - (mu_2 - x_inf) ln((x_inf - x)/(x_inf - mu_1)))
  auto const parameters = glass_beads(0);
  law::CamClayMuI const law(parameters);
  double const p = 50, rate = 30, a = parameters.I_0 / parameters.d * std::sqrt(p / parameters.rho_s);
  double const mu_1 = parameters.mu_1, mu_2 = parameters.mu_2;
  double const x_inf = (rate * mu_2 + a * mu_1) / (rate + a);
  double const x_end = mu_1 + 0.7 * (x_inf - mu_1);
  double const end = p / law.G / (rate + a) * ((x_end - mu_1) - (mu_2 - x_inf) * std::log(0.3));

  auto const ratio_after = [&](double time, int steps) {
    MaterialPoint<shape::Plane, law::CamClayMuI> point{law};  // p_c0 = 100 = 2 p
    point.eps = isotropic<shape::Plane>(-p / law.volumetric_modulus<shape::Plane>()) +
                simple_shear<shape::Plane>(mu_1 * p / law.G);
    for (int k = 0; k < steps; ++k) point.step(simple_shear<shape::Plane>(rate * time / steps), time / steps);
    return point.q() / point.p();
  };
  double const coarse = std::abs(ratio_after(end, 50) - x_end), fine = std::abs(ratio_after(end, 100) - x_end);
  BOOST_TEST_MESSAGE("start-up error " << coarse << ", " << fine << ", order " << std::log2(coarse / fine));
  BOOST_TEST(std::log2(coarse / fine) == 1.0, tolerance(0.05));
  for (double const dt : {0.01 * end, end, 100 * end})
    BOOST_TEST(ratio_after(400 * std::max(dt, end), static_cast<int>(400 * std::max(dt, end) / dt)) == x_inf,
               tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(friction_that_falls_with_the_shear_rate_is_refused) {
  auto parameters = glass_beads(0);
  BOOST_TEST(!law::CamClayMuI::Parameters::check(parameters).has_value());
  parameters.mu_2 = parameters.mu_1;
  BOOST_TEST(!law::CamClayMuI::Parameters::check(parameters).has_value());
  parameters.mu_2 = 0.999 * parameters.mu_1;
  BOOST_TEST(law::CamClayMuI::Parameters::check(parameters).has_value());
}

BOOST_AUTO_TEST_CASE(equal_frictions_make_the_viscous_law_rate_independent) {
  auto parameters = glass_beads(0.1);
  parameters.mu_2 = parameters.mu_1;
  law::CamClay::Parameters slow;
  slow.M = parameters.mu_1;
  slow.beta = 0.1;
  law::CamClayMuI const viscous(parameters);
  law::CamClay const plastic(slow);
  auto const trial = support::strain_of<shape::Solid>(plastic, 30, 90);
  MaterialPoint<shape::Solid, law::CamClayMuI> one{viscous};
  MaterialPoint<shape::Solid, law::CamClay> other{plastic};
  one.step(trial, 1e-5);
  other.step(trial, 1e-5);
  BOOST_TEST(one.q() == other.q(), tolerance(round_off));
  BOOST_TEST(one.p() == other.p(), tolerance(round_off));
}

BOOST_AUTO_TEST_CASE(without_a_rate_of_rearrangement_or_with_one_that_is_infinite_the_limits_are_met) {
  law::CamClay::Parameters slow;
  slow.M = tan_deg(20.9);
  law::CamClay const plastic(slow);
  auto const trial = support::strain_of<shape::Plane>(plastic, 60, 80);
  MaterialPoint<shape::Plane, law::CamClay> yielded{plastic};
  yielded.step(trial, 1);
  double const S = yielded.q() / slow.M;

  auto const shear_stress_with = [&](double diameter, double dt) {
    auto parameters = glass_beads(0);
    parameters.d = diameter;
    law::CamClayMuI const law(parameters);
    MaterialPoint<shape::Plane, law::CamClayMuI> point{law};
    point.step(trial, dt);
    return point.q();
  };
  BOOST_TEST(shear_stress_with(1e-300, 2.5e-5) == yielded.q(), tolerance(round_off));        // d -> 0
  BOOST_TEST(shear_stress_with(2.5e-3, 1e300) == yielded.q(), tolerance(round_off));         // dt -> infinity
  BOOST_TEST(shear_stress_with(1e300, 2.5e-5) == tan_deg(32.76) * S, tolerance(round_off));  // d -> infinity
  BOOST_TEST(shear_stress_with(2.5e-3, 0) == tan_deg(32.76) * S, tolerance(round_off));      // dt -> 0
}

BOOST_AUTO_TEST_CASE(the_two_stage_map_makes_energy_where_it_dilates_in_very_short_steps) {
  // why its `dissipative` is false: the volume follows the whole overstress while the shear stress is all but kept
  law::CamClayMuI const law(glass_beads(0));
  MaterialPoint<shape::Plane, law::CamClayMuI> point{law};
  auto const trial = support::strain_of<shape::Plane>(law, 10, 15);
  point.step(trial, 1e-12);
  BOOST_TEST(contract(law.stress(point.eps), trial - point.eps) < 0);
  BOOST_TEST(law.energy(point.eps) > law.energy(trial));
}

BOOST_AUTO_TEST_SUITE_END()
