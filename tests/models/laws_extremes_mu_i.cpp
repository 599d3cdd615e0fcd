/// Extreme inputs of the mu(I) rheology: the rows 47 to 54 of the list of extremes, by their numbers.

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "models/laws/drucker_prager_viscous.hpp"
#include "tests/support/law_extremes.hpp"

BOOST_AUTO_TEST_SUITE(laws_extremes_mu_i)

using namespace talus;
using namespace talus::extremes;
using boost::test_tools::tolerance;

BOOST_AUTO_TEST_CASE(row_47_and_48_friction_is_mu_1_at_rest_and_mu_2_at_any_rate_of_a_trillion) {
  for_each_law<MuIs>([](auto type, auto parameters) {
    LawOf<decltype(type)> const law(parameters);
    auto const rest = stepped(law, 50, 0);
    BOOST_TEST(law.friction(rest.eps, rest.state) == parameters.mu_1);
    auto const slow = stepped(law, 50, 90, 1e300);
    BOOST_TEST(law.friction(slow.eps, slow.state) == parameters.mu_1, tolerance(1e-10));
    auto const fast = stepped(law, 50, 90, 90 / (law.G * 1e12));  // 1e12/s
    BOOST_TEST(law.friction(fast.eps, fast.state) == parameters.mu_2, tolerance(1e-9));
  });
}

BOOST_AUTO_TEST_CASE(row_49_shear_stress_goes_with_the_pressure) {
  for_each_law<MuIs>([](auto type, auto parameters) {
    LawOf<decltype(type)> const law(parameters);
    for (double const p_tr : {-1.0, -1e3, -1e5}) {
      auto const point = stepped(law, p_tr, 10, 1e-5);
      double const S = law.surface.at(point.p(), law.template strength<shape::Solid>(point.state)).S;
      BOOST_TEST(point.q() <= parameters.mu_2 * S + 1e-3);
    }
  });
  law::DruckerPragerMuI const cone(law::DruckerPragerMuI::Parameters{});
  for (double const p : {1e-12, 1e-6, -1e-6, -1e3}) {
    auto const point = stepped(cone, p, 10, 1e-5);
    BOOST_TEST(point.q() <= cone.rate.mu_2 * std::max(0.0, p) + 64 * eps * 10);
  }
}

BOOST_AUTO_TEST_CASE(row_50_equal_frictions_leave_no_viscosity_and_falling_ones_are_refused) {
  for_each_law<MuIs>([](auto type, auto parameters) {
    using P = decltype(parameters);
    BOOST_TEST(!allows<P>("I_0", 0.0));
    parameters.mu_2 = 0.99 * parameters.mu_1;
    BOOST_TEST(P::check(parameters).has_value());
    parameters.mu_2 = parameters.mu_1;
    BOOST_TEST(!P::check(parameters).has_value());
    LawOf<decltype(type)> const law(parameters);
    BOOST_TEST(!law.viscous());
    auto const soon = stepped(law, 60, 80, 0), late = stepped(law, 60, 80, 1e300);
    BOOST_TEST(soon.p() == late.p(), tolerance(1e-12));
    BOOST_TEST(soon.q() == late.q(), tolerance(1e-12));
  });
}

BOOST_AUTO_TEST_CASE(row_51_grains_of_no_size_are_rate_independent_and_those_of_a_metre_are_borne) {
  for_each_law<MuIs>([](auto type, auto parameters) {
    parameters.d = 1e-300;
    LawOf<decltype(type)> const fine(parameters);
    auto const soon = stepped(fine, 60, 80, 1e-5), late = stepped(fine, 60, 80, 1e300);
    BOOST_TEST(soon.p() == late.p(), tolerance(1e-12));
    BOOST_TEST(soon.q() == late.q(), tolerance(1e-12));
    parameters.d = 1;
    LawOf<decltype(type)> const coarse(parameters);
    for (double const p : {-10.0, 60.0, 1e4}) BOOST_TEST(sound(coarse, p, 80, 1e-5));
  });
}

BOOST_AUTO_TEST_CASE(row_52_no_rate_bears_more_than_mu_2_and_next_to_mu_1_flow_is_slow) {
  law::DruckerPragerMuI const law(law::DruckerPragerMuI::Parameters{});
  double const p = 100;
  for (double const ratio : {law.rate.mu_1 - 1e-6, law.rate.mu_1 + 1e-6, law.rate.mu_2, law.rate.mu_2 + 0.1}) {
    auto const point = stepped(law, p, ratio * p, 1e-9);
    double const rate = point.derived(field::shear_rate), z = (ratio - law.rate.mu_1) * p;
    if (z < 0) BOOST_TEST(rate == 0);
    if (z > 0) BOOST_TEST(rate > 0);
    if (z > 0 && ratio < law.rate.mu_1 + 1e-3) BOOST_TEST(rate < 1e-3);
    BOOST_TEST(point.q() < law.rate.mu_2 * p);
  }
}

BOOST_AUTO_TEST_CASE(row_53_the_quadratic_loses_no_digits) {
  using Real = boost::multiprecision::cpp_bin_float_100;
  law::MuI const rate(law::MuI::Parameters{});
  double const G = 4e5;
  for (double const S : {1e-6, 1.0, 1e6})
    for (double const P : {1e-9, 1.0, 1e6})
      for (double const excess : {1e-9, 1e-3, 1.0, 1e6})
        for (double const dt : {1e-12, 1e-6, 1.0, 1e6}) {
          double const q_tr = rate.mu_1 * S * (1 + excess);
          Real const O = Real(q_tr) - Real(rate.mu_1) * S, L = (Real(rate.mu_2) - rate.mu_1) * S;
          Real const sum = O + L + Real(G) * rate.Q * dt * sqrt(Real(P)), z = (sum - sqrt(sum * sum - 4 * O * L)) / 2;
          Real const q = Real(rate.mu_1) * S + z;
          double const got = rate.relax(q_tr, law::EllipsePoint<double>{0, 0, P, S}, G, dt);
          BOOST_TEST(got == static_cast<double>(q), tolerance(1e-14));
        }
}

BOOST_AUTO_TEST_CASE(row_54_long_steps_lie_between_yield_and_trial) {
  for_each_law<All>([](auto type, auto parameters) {
    using L = LawOf<decltype(type)>;
    if constexpr (L::rate_dependent) {
      L const law(parameters);
      for (double const p : {-10.0, 30.0, 60.0, 1e3}) {
        double last = 80;
        for (double const dt : {1e-6, 1e-3, 1.0, 1e3}) {
          auto const point = stepped(law, p, 80, dt);
          BOOST_TEST(point.q() <= last * (1 + 1e-9));
          BOOST_TEST(law.yield(point.eps, point.state) >= -1e-9 * 100);
          last = point.q();
        }
      }
    }
  });
}

BOOST_AUTO_TEST_SUITE_END()
