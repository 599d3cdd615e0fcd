/// Extreme inputs of plastic laws: the rows 32 to 46 of the list of extremes, by their numbers. Rows 32 (cap), 35 (apex),
/// 36 (smallest strength) and 44 of the two-stage laws are in laws_hostile.cpp as well, in more detail.

#include "tests/support/law_extremes.hpp"

BOOST_AUTO_TEST_SUITE(laws_extremes)

using namespace talus;
using namespace talus::extremes;
using boost::test_tools::tolerance;
using support::MaterialPoint;
using support::simple_shear;

BOOST_AUTO_TEST_CASE(row_32_a_pressure_of_a_million_strengths_ends_on_the_cap) {
  for_each_law<All>([](auto type, auto parameters) {
    LawOf<decltype(type)> const law(parameters);
    auto const point = stepped(law, 1e8, 0, 1e300);
    BOOST_TEST(point.p() == law.template strength<shape::Solid>(point.state), tolerance(1e-9));
  });
}

BOOST_AUTO_TEST_CASE(row_33_tension_beyond_the_tip_ends_at_the_tip) {
  for_each_law<All>([](auto type, auto parameters) {
    parameters.beta = 0.3;
    LawOf<decltype(type)> const law(parameters);
    auto const point = stepped(law, -1e4, 0, 1e300);
    double const p_c = law.template strength<shape::Solid>(point.state);
    BOOST_TEST(std::abs(point.p() + 0.3 * p_c) < 1e-10 * 100);
    for (double const q : {0.0, 1e-9, 1.0, 1e6}) BOOST_TEST(sound(law, -1e4, q, 1e-5));
  });
}

BOOST_AUTO_TEST_CASE(row_34_no_shear_stays_no_shear) {
  for_each_law<All>([](auto type, auto parameters) {
    LawOf<decltype(type)> const law(parameters);
    for (double const p : {-1e3, -1.0, 0.0, 50.0, 99.0, 101.0, 1e4})
      for (double const dt : {0.0, 1e-6, 1e300}) BOOST_TEST(stepped(law, p, 0, dt).q() <= 64 * eps * std::abs(p));
  });
}

BOOST_AUTO_TEST_CASE(row_35_the_apex_is_reached_alike_from_left_and_right) {
  for_each_law<All>([](auto type, auto parameters) {
    parameters.beta = 0.2;
    LawOf<decltype(type)> const law(parameters);
    auto const at = stepped(law, 40, 90);
    BOOST_TEST(at.p() == 40, tolerance(16 * eps));
    for (double const away : {-1e-12, 1e-12}) {
      auto const near = stepped(law, 40 * (1 + away), 90);
      BOOST_TEST(near.p() == at.p(), tolerance(1e-10));
      BOOST_TEST(near.q() == at.q(), tolerance(1e-10));
    }
  });
}

BOOST_AUTO_TEST_CASE(row_36_no_strength_is_refused_and_next_to_none_is_borne) {
  for_each_law<All>([](auto type, auto parameters) {
    using P = decltype(parameters);
    BOOST_TEST(!allows<P>("p_c0", 0.0));
    parameters.p_c0 = 1e-300;
    LawOf<decltype(type)> const law(parameters);
    for (double const p : {-1.0, 0.0, 1e-3, 1e3}) BOOST_TEST(sound(law, p, 1.0, 1e-5));
  });
}

BOOST_AUTO_TEST_CASE(row_37_without_hardening_the_strength_stays) {
  for_each_law<All>([](auto type, auto parameters) {
    parameters.xi = 0;
    LawOf<decltype(type)> const law(parameters);
    for (double const p : {-50.0, 20.0, 80.0, 1e5}) {
      auto const point = stepped(law, p, 90, 1e300);
      BOOST_TEST(law.template strength<shape::Solid>(point.state) == 100, tolerance(1e-14));
      BOOST_TEST(sound(law, p, 90, 1e-5));
    }
  });
}

BOOST_AUTO_TEST_CASE(row_38_a_strength_that_overflows_is_capped) {
  for_each_law<All>([](auto type, auto parameters) {
    parameters.xi = 1e4;
    LawOf<decltype(type)> const law(parameters);
    for (double const eps_V : {-1.0, -0.01, -1e-4, 0.0, 1e-4, 1.0})
      for (double const p : {-1e4, 10.0, 1e5}) BOOST_TEST(sound(law, p, 1e3, 1e-5, eps_V));
  });
}

BOOST_AUTO_TEST_CASE(row_39_material_that_softened_to_nothing_bears_nothing) {
  for_each_law<All>([](auto type, auto parameters) {
    LawOf<decltype(type)> const law(parameters);
    auto const point = stepped(law, -1e3, 500, 1e300, 2.0);  // strength p_c0 exp(-100), at its floor
    BOOST_TEST(std::abs(point.p()) < 1e-6);
    BOOST_TEST(point.q() < 1e-6);
  });
}

BOOST_AUTO_TEST_CASE(row_40_the_tip_without_cohesion_is_the_origin_and_other_cohesions_are_refused) {
  for_each_law<All>([](auto type, auto parameters) {
    using P = decltype(parameters);
    BOOST_TEST(!allows<P>("beta", -1e-9));
    BOOST_TEST(!allows<P>("beta", 1.0));
    LawOf<decltype(type)> const law(parameters);
    auto const point = stepped(law, -1e6, 1.0, 1e300);
    BOOST_TEST(std::abs(point.p()) < 1e-3);
    BOOST_TEST(point.q() < 1e-3);
  });
}

BOOST_AUTO_TEST_CASE(row_41_a_stiffness_of_a_trillion_strengths_leaves_no_residual) {
  for_each_law<All>([](auto type, auto parameters) {
    parameters.E = 1e14;
    LawOf<decltype(type)> const law(parameters);
    for (double const p : {-20.0, 20.0, 80.0, 300.0}) {
      auto const point = stepped(law, p, 90, 1e300);
      double const p_c = law.template strength<shape::Solid>(point.state);
      BOOST_TEST(std::abs(law.yield(point.eps, point.state)) <= 1e-10 * std::max(p_c, 100.0));
    }
  });
}

BOOST_AUTO_TEST_CASE(row_42_no_friction_is_a_fluid_and_a_thousand_is_borne) {
  for_each_law<All>([](auto type, auto parameters) {
    for (double const slope : {0.0, 1e3}) {
      set_slope(parameters, slope);
      LawOf<decltype(type)> const law(parameters);
      for (double const p : {-10.0, 30.0, 1e4})
        for (double const q : {0.0, 1e-3, 200.0}) BOOST_TEST(sound(law, p, q, 1e300));
      if (slope == 0) BOOST_TEST(stepped(law, 30, 200, 1e300).q() <= 100 * law::least_slope);
    }
  });
}

BOOST_AUTO_TEST_CASE(row_43_and_44_random_states_over_twenty_four_decades_are_sound) {
  // that the search converges, and in how many evaluations: laws_hostile
  for_each_law<All>([](auto type, auto parameters) {
    support::LogUniform stress(1e-12, 1e12, 51), strain(1e-6, 20, 52);
    LawOf<decltype(type)> const plain(parameters);
    parameters.beta = 0.4;
    LawOf<decltype(type)> const cohesive(parameters);
    int unsound = 0;
    for (int k = 0; k < 100000; ++k) {
      double const p_tr = stress.signed_(), q_tr = stress.positive(), eps_V = strain.signed_();
      if (!sound(k % 2 ? plain : cohesive, p_tr, q_tr, k % 3 ? 1e300 : 1e-5, eps_V) && ++unsound < 5)
        BOOST_TEST_MESSAGE("p_tr " << p_tr << " q_tr " << q_tr << " eps_V " << eps_V << " k " << k);
    }
    BOOST_TEST(unsound == 0);
  });
}

BOOST_AUTO_TEST_CASE(row_45_steps_of_any_size_end_in_the_same_critical_state) {
  for_each_law<MuIs>([](auto type, auto parameters) {
    LawOf<decltype(type)> const law(parameters);
    double const rate = 20, K = law.template bulk<shape::Plane>();
    double p_first = 0, q_first = 0;
    for (double const dt : {1e-6, 1e-4, 1e-2, 1.0}) {
      MaterialPoint<shape::Plane, LawOf<decltype(type)>> point{law};
      point.eps = isotropic<shape::Plane>(-60 / (2 * K));
      for (int k = 0; k < std::max(200, static_cast<int>(2e-3 / dt)); ++k)
        point.step(simple_shear<shape::Plane>(rate * dt), dt);
      if (p_first == 0) p_first = point.p(), q_first = point.q();
      BOOST_TEST(point.p() == p_first, tolerance(1e-6));
      BOOST_TEST(point.q() == q_first, tolerance(1e-6));
    }
  });
}

BOOST_AUTO_TEST_CASE(row_46_spray_bears_nothing_until_its_gap_is_closed) {
  for_each_law<All>([](auto type, auto parameters) {
    LawOf<decltype(type)> const law(parameters);
    MaterialPoint<shape::Solid, LawOf<decltype(type)>> point{law};
    auto const move = [&](double volume) { point.step(isotropic<shape::Solid>(volume / 3), 1e9); };
    for (int k = 0; k < 100; ++k) move(0.02);
    BOOST_TEST(law.volume_ratio(point.eps, point.state) == std::exp(2.0), tolerance(1e-12));
    for (int k = 0; k < 95; ++k) {
      move(-0.02);
      BOOST_TEST_REQUIRE(std::abs(point.p()) < 2.0);  // of p_c0 = 100
    }
    for (int k = 0; k < 10; ++k) move(-0.02);
    BOOST_TEST(point.p() > 100.0);
    BOOST_TEST(law.volume_ratio(point.eps, point.state) == std::exp(-0.1), tolerance(1e-12));
  });
}

BOOST_AUTO_TEST_SUITE_END()
