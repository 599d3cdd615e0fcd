/// Viscous laws against closed forms, against their rate equations, and in their limits.

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "models/laws/cam_clay_mu_i.hpp"
#include "models/laws/cam_clay_mu_i_consistent.hpp"
#include "models/laws/cam_clay_viscous.hpp"
#include "models/laws/drucker_prager_viscous.hpp"
#include "models/laws/modified_cam_clay.hpp"
#include "models/laws/von_mises_softening.hpp"
#include "tests/support/law_states.hpp"
#include "tests/support/material_point.hpp"

BOOST_AUTO_TEST_SUITE(laws_viscous)

using namespace talus;
using boost::test_tools::tolerance;
using support::MaterialPoint;
using support::simple_shear;

namespace {

/// Order of the last halving of the step, from the errors with n, 2 n, 4 n, ... steps.
double last_order(std::vector<double> const& errors) {
  for (double const error : errors) BOOST_TEST_MESSAGE("error " << error);
  return std::log2(errors[errors.size() - 2] / errors.back());
}

/// Pressure, shear stress and plastic volume of viscous Cam-Clay in simple shear at constant volume.
struct Path {
  double p, q, eps_V;
};

/// The rate equations by Runge–Kutta: q' = G (rate - gamma), eps_V' = gamma mu ((1 - beta) p_c - 2 p)/(2 S),
/// p' = K eps_V', gamma = Q sqrt(P) z/(L - z).
Path rate_equations(law::CamClayMuIConsistent const& law, Path y, double rate, double time, int steps) {
  double const K = law.bulk<shape::Plane>(), beta = law.surface.beta, h = time / steps;
  auto const slope = [&](Path const& a) -> Path {
    double const p_c = law.hardening.p_c0 * std::exp(-law.hardening.xi * a.eps_V), P = a.p + beta * p_c;
    double const S = std::sqrt((p_c - a.p) * P), L = (law.rate.mu_2 - law.rate.mu_1) * S;
    double const z = std::max(0.0, a.q - law.rate.mu_1 * S), gamma = law.rate.Q * std::sqrt(P) * z / (L - z);
    double const dilation = gamma * a.q / S * ((1 - beta) * p_c - 2 * a.p) / (2 * S);
    return {K * dilation, law.G * (rate - gamma), dilation};
  };
  auto const moved = [](Path const& a, double s, Path const& b) -> Path {
    return {a.p + s * b.p, a.q + s * b.q, a.eps_V + s * b.eps_V};
  };
  for (int k = 0; k < steps; ++k) {
    Path const k1 = slope(y), k2 = slope(moved(y, h / 2, k1)), k3 = slope(moved(y, h / 2, k2)),
               k4 = slope(moved(y, h, k3));
    y = moved(moved(moved(moved(y, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
  }
  return y;
}

/// The same by steps of a law, from the yield surface at pressure p.
template <class L>
MaterialPoint<shape::Plane, L> sheared(L const& law, double p, double rate, double time, int steps) {
  MaterialPoint<shape::Plane, L> point{law};
  double const q = law.rate.mu_1 * law.surface.at(p, law.hardening.p_c0).S;
  point.eps = isotropic<shape::Plane>(-p / law.template volumetric_modulus<shape::Plane>()) +
              simple_shear<shape::Plane>(q / law.G);
  for (int k = 0; k < steps; ++k) point.step(simple_shear<shape::Plane>(rate * time / steps), time / steps);
  return point;
}

}  // namespace

BOOST_AUTO_TEST_CASE(linear_perzyna_approaches_its_viscous_stress_exponentially) {
  // q = q_y + eta rate (1 - exp(-G t/eta)), eta = q_y t_v
  law::VonMisesPerzyna::Parameters parameters;
  parameters.q_max = parameters.q_min = 1000;
  parameters.t_v = 0.01;
  law::VonMisesPerzyna const law(parameters);
  double const eta = 1000 * 0.01, rate = 20, time = eta / law.G;
  auto const after = [&](double t, int steps) {
    MaterialPoint<shape::Solid, law::VonMisesPerzyna> point{law};
    point.eps = simple_shear<shape::Solid>(1000 / law.G);
    for (int k = 0; k < steps; ++k) point.step(simple_shear<shape::Solid>(rate * t / steps), t / steps);
    return point;
  };
  std::vector<double> errors;
  for (int const n : {50, 100, 200})
    errors.push_back(std::abs(after(time, n).q() - (1000 + eta * rate * (1 - std::exp(-1)))) / (eta * rate));
  BOOST_TEST(last_order(errors) == 1.0, tolerance(0.02));
  BOOST_TEST(after(100 * time, 50).q() == 1000 + eta * rate, tolerance(1e-12));  // at any step
  BOOST_TEST(after(100 * time, 50).derived(field::shear_rate) == rate, tolerance(1e-11));
}

BOOST_AUTO_TEST_CASE(perzyna_with_any_exponent_satisfies_its_flow_law) {
  for (double const s : {0.01, 0.3, 1.0, 2.5, 30.0})
    for (double const dt : {1e-9, 1e-6, 1e-3, 1.0}) {
      law::DruckerPragerPerzyna::Parameters parameters;
      parameters.s = s;
      parameters.c = 50;
      law::DruckerPragerPerzyna const law(parameters);
      MaterialPoint<shape::Solid, law::DruckerPragerPerzyna> point{law};
      double const q_tr = 900, q_y = parameters.M * 300 + 50;
      point.step(support::strain_of<shape::Solid>(law, 300, q_tr), dt);
      double const gamma = (q_tr - point.q()) / (law.G * dt);
      BOOST_TEST_CONTEXT("s " << s << " dt " << dt) {
        // as logarithms, in which a rounding of q_tr is divided by G dt
        double const rounding = 1e-13 + s * parameters.t_v * 1e-13 * q_tr / (law.G * dt);
        BOOST_TEST(std::abs(std::log(point.q() / q_y) - s * std::log1p(parameters.t_v * gamma)) < rounding);
        BOOST_TEST(point.p() == 300, tolerance(1e-13));
      }
    }
}

BOOST_AUTO_TEST_CASE(duvaut_lions_relaxes_exponentially_to_the_yield_stress) {
  law::VonMisesDuvautLions::Parameters parameters;
  parameters.q_max = parameters.q_min = 1000;
  parameters.t_v = 0.01;
  law::VonMisesDuvautLions const law(parameters);
  std::vector<double> errors;
  for (int const n : {50, 100, 200}) {
    MaterialPoint<shape::Solid, law::VonMisesDuvautLions> point{law};
    point.eps = support::strain_of<shape::Solid>(law, 0, 5000);
    for (int k = 0; k < n; ++k) point.step({}, 0.02 / n);
    errors.push_back(std::abs(point.q() - (1000 + 4000 * std::exp(-2))) / 4000);
  }
  BOOST_TEST(last_order(errors) == 1.0, tolerance(0.02));
}

BOOST_AUTO_TEST_CASE(duvaut_lions_makes_the_same_part_of_the_flow_in_volume_and_shear) {
  law::CamClayDuvautLions::Parameters parameters;
  law::CamClayDuvautLions const law(parameters);
  law::CamClay const rigid(law::CamClay::Parameters{});
  for (auto const& [p_tr, q_tr] : {std::pair{60.0, 80.0}, {20.0, 60.0}, {-10.0, 30.0}, {500.0, 10.0}}) {
    auto const trial = support::strain_of<shape::Solid>(law, p_tr, q_tr);
    MaterialPoint<shape::Solid, law::CamClay> projected{rigid};
    MaterialPoint<shape::Solid, law::CamClayDuvautLions> third{law};
    projected.step(trial, 1);
    third.step(trial, 0.5 * parameters.t_v);  // 1/(1 + 2)
    BOOST_TEST(third.p() == p_tr + (projected.p() - p_tr) / 3, tolerance(1e-12));
    BOOST_TEST(third.q() == q_tr + (projected.q() - q_tr) / 3, tolerance(1e-12));
    BOOST_TEST(third.state.values[0] == projected.state.values[0] / 3, tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(without_time_the_coupled_map_is_elastic_and_with_all_time_rate_independent) {
  for (double const beta : {0.0, 0.2}) {
    law::CamClayMuIConsistent::Parameters parameters;
    parameters.beta = beta;
    law::CamClay::Parameters slow;
    slow.beta = beta;
    slow.M = parameters.mu_1;
    law::CamClayMuIConsistent const law(parameters);
    law::CamClay const rigid(slow);
    support::LogUniform random(0.1, 10, 21);
    for (int k = 0; k < 500; ++k) {
      auto const trial = support::strain_of<shape::Solid>(law, 100 * random.signed_(), 100 * random.positive());
      MaterialPoint<shape::Solid, law::CamClayMuIConsistent> point{law}, at_once{law};
      MaterialPoint<shape::Solid, law::CamClay> yielded{rigid};
      point.step(trial, 1e300), yielded.step(trial, 1), at_once.step(trial, 0);
      double const scale = std::max({std::abs(yielded.p()), yielded.q(), 100.0});
      BOOST_TEST(std::abs(point.p() - yielded.p()) < 1e-10 * scale);
      BOOST_TEST(std::abs(point.q() - yielded.q()) < 1e-10 * scale);
      auto const [p_tr, q_tr] = invariants(law, trial);
      bool const carried = p_tr > -beta * 100 && p_tr < 100 && q_tr < parameters.mu_2 * law.surface.at(p_tr, 100.0).S;
      if (carried) BOOST_TEST(support::largest(at_once.eps - trial) < 1e-12 * support::largest(trial));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_coupled_map_follows_its_rate_equations_with_order_one_and_the_two_stages_do_not) {
  law::CamClayMuIConsistent const law(law::CamClayMuIConsistent::Parameters{});
  law::CamClayMuI const published(law::CamClayMuI::Parameters{});
  double const rate = 20;
  for (double const p : {80.0, 20.0}) {  // from the compacting and from the dilating side
    double const q = law.rate.mu_1 * law.surface.at(p, 100.0).S, time = 6e-6;
    Path const exact = rate_equations(law, {p, q, 0}, rate, time, 60000);
    auto const error = [&](auto const& point) {
      return std::max(std::abs(point.p() - exact.p), std::abs(point.q() - exact.q)) / 100;
    };
    std::vector<double> errors, published_errors;
    for (int const n : {40, 80, 160, 320}) {
      errors.push_back(error(sheared(law, p, rate, time, n)));
      published_errors.push_back(error(sheared(published, p, rate, time, n)));
    }
    BOOST_TEST_MESSAGE("p " << p << " -> " << exact.p << ", coupled:");
    BOOST_TEST(last_order(errors) == 1.0, tolerance(0.05));
    BOOST_TEST_MESSAGE("two stages:");
    BOOST_TEST(last_order(published_errors) < 0.7);
    BOOST_TEST(published_errors.back() > 10 * errors.back());
  }
}

BOOST_AUTO_TEST_CASE(both_couplings_end_in_the_same_critical_state) {
  for (double const beta : {0.0, 0.3}) {
    law::CamClayMuI::Parameters published;
    law::CamClayMuIConsistent::Parameters parameters;
    published.beta = parameters.beta = beta;
    law::CamClayMuI const two(published);
    law::CamClayMuIConsistent const one(parameters);
    for (double const dt : {1e-7, 1e-5}) {
      int const steps = static_cast<int>(3e-3 / dt);
      auto const a = sheared(two, 70, 20, 3e-3, steps);
      auto const b = sheared(one, 70, 20, 3e-3, steps);
      BOOST_TEST(a.p() == b.p(), tolerance(1e-8));
      BOOST_TEST(a.q() == b.q(), tolerance(1e-8));
      BOOST_TEST(b.derived(field::shear_rate) == 20, tolerance(1e-7));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
