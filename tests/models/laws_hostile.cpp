#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "core/type_list.hpp"
#include "models/laws/cam_clay_mu_i.hpp"
#include "models/laws/drucker_prager.hpp"
#include "models/laws/modified_cam_clay.hpp"
#include "tests/support/law_states.hpp"

BOOST_AUTO_TEST_SUITE(laws_hostile)

using namespace talus;
using boost::test_tools::tolerance;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
using CamClays = TypeList<law::CamClay, law::CamClaySinh, law::CamClayMuI, law::CamClayMuISinh>;

/// Finite, between tip and cap, on or under the curve: else what is wrong.
template <class Shape, class L>
std::string complaint(L const& law, Symmetric<double, Shape> const& after,
                      Record<double, typename L::State> const& state, Invariants<double> const& trial) {
  auto const [p, q] = invariants(law, after);
  double const p_c = law.template strength<Shape>(state), beta = law.surface.beta;
  double const K = law.template bulk<Shape>(), scale = std::max({p_c, std::abs(p), q});
  // rounding of a stress, what rounding of the strain makes of a strength that hardens steeply, and what the rounding
  // of a trial strain leaves in its deviator
  double const slack = 64 * eps * scale * (1 - law.hardening.slope(p_c, K) / K) +
                       8 * eps * std::max(std::abs(trial.p), trial.q) + 1e-250;
  bool const elastic = p_c >= law.hardening.ceiling(K);
  std::string why;
  if (!std::isfinite(p) || !std::isfinite(q) || !std::isfinite(p_c)) why += " not finite";
  if (!std::isfinite(state[field::plastic_volumetric_strain])) why += " state not finite";
  if (!elastic && (p > p_c + slack || p < -beta * p_c - slack)) why += " p outside [-beta p_c, p_c]";
  if (!L::rate_dependent && law.yield(after, state) > slack * (1 + law.surface.M)) why += " above the yield surface";
  if (q > trial.q * (1 + 64 * eps) + slack) why += " sheared beyond the trial";
  for (double const value : law.derive(after, state).values)
    if (!std::isfinite(value)) why += " a derived field is not finite";
  if (!why.empty())
    why += ": p " + std::to_string(p) + " q " + std::to_string(q) + " p_c " + std::to_string(p_c) + " beta " +
           std::to_string(beta) + " eps_V " + std::to_string(state[field::plastic_volumetric_strain]);
  return why;
}

template <class Shape, class L>
std::string after_step(L const& law, double p_tr, double q_tr, double eps_V, double dt = 1e-5) {
  Record<double, typename L::State> state{{eps_V}};
  auto const trial = support::strain_of<Shape>(law, p_tr, q_tr);
  auto const after = law.project(trial, state, dt);
  std::string const why = complaint(law, after, state, {p_tr, q_tr});
  return why.empty() ? why : why + " from p_tr " + std::to_string(p_tr) + " q_tr " + std::to_string(q_tr);
}

template <class L>
L with(double beta, double xi = 50, double p_c0 = 100) {
  typename L::Parameters p;
  p.beta = beta;
  p.xi = xi;
  p.p_c0 = p_c0;
  return L(p);
}

}  // namespace

BOOST_AUTO_TEST_CASE(stresses_over_twenty_four_decades_become_finite_and_admissible) {
  for_each_type(CamClays{}, [](auto type) {
    using L = typename decltype(type)::type;
    support::LogUniform stress(1e-12, 1e12, 1), strain(1e-6, 20, 2);
    int shown = 0;
    for (int k = 0; k < 25000; ++k) {
      double const beta = k % 2 == 0 ? 0 : 0.99 * stress.unit();
      auto const law = with<L>(beta);
      double const p_tr = stress.signed_(), q_tr = k % 5 == 0 ? 0 : stress.positive();
      std::string const why = k % 3 == 0 ? after_step<shape::Plane>(law, p_tr, q_tr, strain.signed_())
                                         : after_step<shape::Solid>(law, p_tr, q_tr, strain.signed_());
      if (!why.empty() && ++shown < 5) BOOST_ERROR(std::string(L::name) + why);
    }
    BOOST_TEST(shown == 0, L::name);
  });
}

BOOST_AUTO_TEST_CASE(the_search_converges_wherever_it_starts) {
  law::ExponentialHardening const hardening({.p_c0 = 100, .xi = 50});
  double const K = 1e6, G = 4e5;
  support::LogUniform stress(1e-12, 1e12, 3), strain(1e-6, 20, 4);
  long evaluations = 0, plastic = 0;
  int most = 0;
  for (int k = 0; k < 100000; ++k) {
    law::Ellipse const surface{.M = 0.38, .beta = k % 2 == 0 ? 0 : 0.5 * stress.unit()};
    double const p_tr = stress.signed_(), q_tr = stress.positive(), eps_V = strain.signed_();
    double const p_c = hardening.strength(eps_V, K);
    if (!(surface.excess(p_tr, q_tr, p_c) > 0) || p_c >= hardening.ceiling(K)) continue;
    auto const mapped =
        law::CamClayMap<law::ExponentialHardening>{surface, hardening, K, G}(p_tr, q_tr, eps_V, p_c, true);
    BOOST_TEST_REQUIRE(mapped.converged);
    evaluations += mapped.iterations;
    most = std::max(most, mapped.iterations);
    ++plastic;
  }
  BOOST_TEST_MESSAGE("evaluations: mean " << static_cast<double>(evaluations) / static_cast<double>(plastic)
                                          << ", most " << most << " of " << plastic << " plastic states");
  BOOST_TEST(plastic > 50000);
}

BOOST_AUTO_TEST_CASE(steps_of_a_flow_take_about_four_evaluations) {
  law::ExponentialHardening const hardening({.p_c0 = 100, .xi = 50});
  law::Ellipse const surface{.M = 0.38, .beta = 0};
  support::LogUniform random(1, 2, 5);
  for (int k = 0; k < 10000; ++k) {
    double const p_tr = 100 * (2 * random.unit() - 0.6), q_tr = 100 * random.unit();
    if (!(surface.excess(p_tr, q_tr, 100.0) > 0)) continue;
    auto const mapped =
        law::CamClayMap<law::ExponentialHardening>{surface, hardening, 1e6, 4e5}(p_tr, q_tr, 0.0, 100.0, true);
    BOOST_TEST(mapped.iterations <= 5);
  }
}

BOOST_AUTO_TEST_CASE(without_cohesion_tension_leaves_no_stress) {
  for_each_type(CamClays{}, [](auto type) {
    using L = typename decltype(type)::type;
    auto const law = with<L>(0);
    for (double const p_tr : {-1e-6, -1.0, -1e6}) {
      Record<double, typename L::State> state{};
      auto const after = law.project(support::strain_of<shape::Solid>(law, p_tr, 0), state, 1e-5);
      auto const [p, q] = invariants(law, after);
      double const searched = 2 * law::CamClayMap<law::ExponentialHardening>::tolerance * 100;
      BOOST_TEST(std::abs(p) <= searched);
      BOOST_TEST(q <= searched);
      // what was taken from the elastic strain is in the plastic strain
      double const opened = -p_tr / law.template bulk<shape::Solid>();
      BOOST_TEST(std::abs(state[field::plastic_volumetric_strain] - opened) <=
                 searched / law.template bulk<shape::Solid>() + 4 * eps * opened);
    }
  });
}

BOOST_AUTO_TEST_CASE(an_unstressed_particle_is_elastic) {
  for (double const beta : {0.0, 0.3}) {
    auto const law = with<law::CamClayMuI>(beta);
    Record<double, law::CamClayMuI::State> state{};
    auto const after = law.project(Symmetric<double, shape::Solid>{}, state, 1e-5);
    BOOST_TEST(support::largest(after) == 0);
    BOOST_TEST(law.yield(after, state) <= 0);
    BOOST_TEST(law.friction(after, state) == law.rate.mu_1);
    BOOST_TEST(law.derive(after, state)[field::shear_rate] == 0);
  }
}

BOOST_AUTO_TEST_CASE(a_pressure_a_million_times_the_strength_ends_on_the_cap) {
  for_each_type(CamClays{}, [](auto type) {
    using L = typename decltype(type)::type;
    for (double const xi : {0.0, 50.0}) {
      auto const law = with<L>(0.1, xi, 0.1);
      Record<double, typename L::State> state{};
      auto const after = law.project(support::strain_of<shape::Plane>(law, 1e6 * 0.1, 0), state, 1e-5);
      double const p_c = law.template strength<shape::Plane>(state);
      BOOST_TEST(invariants(law, after).p == p_c, tolerance(1e-9));
      if (xi == 0) BOOST_TEST(p_c == 0.1, tolerance(1e-12));  // hyperbolic sine of nothing: p_c0 again
    }
  });
}

BOOST_AUTO_TEST_CASE(the_apex_is_exact_and_continuous_from_both_sides) {
  for (double const beta : {0.0, 0.3}) {
    auto const law = with<law::CamClay>(beta);
    double const apex = 0.5 * (1 - beta) * 100, height = law.rate.M * 0.5 * (1 + beta) * 100;
    auto const after = [&](double p_tr) {
      Record<double, law::CamClay::State> state{};
      return invariants(law, law.project(support::strain_of<shape::Plane>(law, p_tr, 90), state, 1.0));
    };
    BOOST_TEST(after(apex).p == apex, tolerance(4 * eps));
    BOOST_TEST(after(apex).q == height, tolerance(4 * eps));
    for (double const away : {1e-14, 1e-12, 1e-10, 1e-8})
      for (double const side : {-1.0, 1.0}) {
        auto const near = after(apex * (1 + side * away));
        BOOST_TEST(near.p == apex, tolerance(2 * away + 8 * eps));
        BOOST_TEST(near.q == height, tolerance(2 * away + 8 * eps));
      }
  }
}

BOOST_AUTO_TEST_CASE(material_that_expands_without_end_keeps_its_plastic_strain_and_carries_nothing) {
  for_each_type(CamClays{}, [](auto type) {
    using L = typename decltype(type)::type;
    auto const law = with<L>(0.2);
    Record<double, typename L::State> state{};
    Symmetric<double, shape::Solid> strain{};
    for (int k = 0; k < 200; ++k) {
      strain = law.project(strain + isotropic<shape::Solid>(0.1 / 3), state, 1e-5);
      BOOST_TEST_REQUIRE(complaint(law, strain, state, {}).empty());
    }
    double const total = trace(strain) + state[field::plastic_volumetric_strain];
    BOOST_TEST(total == 20, tolerance(1e-12));
    BOOST_TEST(std::abs(invariants(law, strain).p) <= 1e-9 * 100);
    BOOST_TEST(law.volume_ratio(strain, state) == std::exp(20.0), tolerance(1e-11));
    // and it must come back the same way before it carries load again
    for (int k = 0; k < 199; ++k) strain = law.project(strain - isotropic<shape::Solid>(0.1 / 3), state, 1e-5);
    BOOST_TEST(invariants(law, strain).p < 1.0);
  });
}

BOOST_AUTO_TEST_CASE(extreme_parameters_leave_every_state_finite_and_admissible) {
  support::LogUniform stress(1e-6, 1e9, 7), strain(1e-6, 1, 8);
  for_each_type(CamClays{}, [&](auto type) {
    using L = typename decltype(type)::type;
    for (double const xi : {0.0, 1.0, 1e4})
      for (double const p_c0 : {1e-300, 1e-6, 1e5})
        for (double const beta : {0.0, 0.999})
          for (double const slope : {0.0, 0.5, 1e3}) {
            typename L::Parameters parameters;
            parameters.xi = xi;
            parameters.p_c0 = p_c0;
            parameters.beta = beta;
            if constexpr (L::rate_dependent) {
              parameters.mu_1 = slope;
              parameters.mu_2 = 2 * slope;
            } else {
              parameters.M = slope;
            }
            L const law(parameters);
            for (int k = 0; k < 40; ++k) {
              std::string const why = after_step<shape::Solid>(law, stress.signed_(), stress.positive(),
                                                               strain.signed_(), k % 2 ? 1e-5 : 1e5);
              BOOST_TEST(why.empty(), L::name << " xi " << xi << " p_c0 " << p_c0 << " M " << slope << why);
            }
          }
  });
}

BOOST_AUTO_TEST_CASE(a_slope_of_zero_is_a_fluid) {
  law::CamClay::Parameters parameters;
  parameters.M = 0;
  law::CamClay const law(parameters);
  Record<double, law::CamClay::State> state{};
  auto const after = law.project(support::strain_of<shape::Plane>(law, 30, 200), state, 1.0);
  // the flow rule at kappa = G/(K M^2) = 4e7: p - p_tr is q_tr/(M a kappa) = 1e-3 of x
  BOOST_TEST(invariants(law, after).p == 30, tolerance(1e-2));
  BOOST_TEST(invariants(law, after).q <= law::least_slope * 50);
}

BOOST_AUTO_TEST_CASE(strength_beyond_ten_bulk_moduli_is_elastic) {
  auto const law = with<law::CamClay>(0);
  Record<double, law::CamClay::State> state{{-1.0}};  // p_c0 e^50, far above
  auto const trial = support::strain_of<shape::Solid>(law, 1e5, 1e7);
  auto const after = law.project(trial, state, 1.0);
  BOOST_TEST(support::largest(after - trial) == 0);
  BOOST_TEST(law.yield(after, state) < 0);
}

BOOST_AUTO_TEST_CASE(drucker_prager_stays_finite_over_twenty_four_decades) {
  support::LogUniform stress(1e-12, 1e12, 9);
  for (double const cohesion : {0.0, 1e-6, 1e3}) {
    law::DruckerPrager::Parameters parameters;
    parameters.c = cohesion;
    law::DruckerPrager const law(parameters);
    for (int k = 0; k < 20000; ++k) {
      Record<double, law::DruckerPrager::State> state{};
      double const p_tr = stress.signed_(), q_tr = k % 5 == 0 ? 0 : stress.positive();
      auto const after = law.project(support::strain_of<shape::Solid>(law, p_tr, q_tr), state, 1.0);
      auto const [p, q] = invariants(law, after);
      BOOST_TEST_REQUIRE(law.yield(after, state) <= 64 * eps * std::max({cohesion, std::abs(p), q}));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
