#include "core/roots.hpp"

#include <boost/test/unit_test.hpp>
#include <set>

#include "core/dual.hpp"

BOOST_AUTO_TEST_SUITE(roots)

using namespace talus;

namespace {

namespace bt = boost::test_tools;
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// x^3 - a.
template <class T>
auto cube_less(T a) {
  return [a](T const& x) { return WithDerivative<T>{x * x * x - a, T(3.0) * x * x}; };
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_smooth_root_is_found_to_the_last_digits_in_a_few_steps) {
  auto const root = bracketed_newton(cube_less(2.0), 0.0, 2.0, 1.0, 0.0);
  BOOST_TEST(root.converged);
  BOOST_TEST(root.x == std::cbrt(2.0), bt::tolerance(2 * eps));
  BOOST_TEST(root.iterations <= 8);  // digits double: 1, 2, 4, 8, 16 and one step to see it
}

BOOST_AUTO_TEST_CASE(the_ends_may_come_in_any_order) {
  auto const falling = [](double x) { return WithDerivative<double>{2.0 - x * x * x, -3.0 * x * x}; };
  BOOST_TEST(bracketed_newton(cube_less(2.0), 0.0, 2.0, 0.5, 1e-14).x == std::cbrt(2.0), bt::tolerance(4 * eps));
  BOOST_TEST(bracketed_newton(falling, 2.0, 0.0, 0.5, 1e-14).x == std::cbrt(2.0), bt::tolerance(4 * eps));
}

BOOST_AUTO_TEST_CASE(a_step_that_leaves_the_bracket_is_not_taken) {
  // Newton's iteration for atan diverges from |x| > 1.39.
  std::set<double> asked;
  auto const f = [&asked](double x) {
    asked.insert(x);
    return WithDerivative<double>{std::atan(x - 1.0), 1.0 / (1.0 + (x - 1.0) * (x - 1.0))};
  };
  auto const root = bracketed_newton(f, -40.0, 50.0, 45.0, 1e-13);
  BOOST_TEST(root.converged);
  BOOST_TEST(root.x == 1.0, bt::tolerance(1e-13));
  BOOST_TEST(*asked.begin() > -40.0);
  BOOST_TEST(*asked.rbegin() < 50.0);
  BOOST_TEST(asked.size() + 1 == static_cast<std::size_t>(root.iterations));  // again where the first step failed
}

BOOST_AUTO_TEST_CASE(nor_is_a_short_one) {
  // Newton's iteration for the cube root goes from x to -2 x, here 0.03 far in a bracket of length 1.
  double least = 1.0;
  auto const f = [&least](double x) {
    least = std::min(least, x);
    return WithDerivative<double>{std::cbrt(x), 1.0 / (3.0 * std::cbrt(x * x))};
  };
  auto const root = bracketed_newton(f, -1e-3, 1.0, 0.01, 1e-13);
  BOOST_TEST(root.converged);
  BOOST_TEST(std::abs(root.x) < 1e-12);
  BOOST_TEST(least > -1e-3);
}

BOOST_AUTO_TEST_CASE(the_equation_may_be_singular_at_the_ends) {
  // log(x/(1 - x)): minus and plus infinity at 0 and 1; root 1/2.
  auto const f = [](double x) { return WithDerivative<double>{std::log(x / (1.0 - x)), 1.0 / (x * (1.0 - x))}; };
  for (double const start : {1e-12, 0.3, 1.0 - 1e-12}) {
    auto const root = bracketed_newton(f, 0.0, 1.0, start, 1e-15);
    BOOST_TEST(root.converged);
    BOOST_TEST(root.x == 0.5, bt::tolerance(2 * eps));
  }
}

BOOST_AUTO_TEST_CASE(a_root_at_an_end_is_found) {
  auto const f = [](double x) { return WithDerivative<double>{x * x, 2.0 * x}; };  // double root at 0
  auto const root = bracketed_newton(f, 0.0, 1.0, 1.0, 1e-12);
  BOOST_TEST(root.converged);
  BOOST_TEST(std::abs(root.x) <= 2e-12);
  BOOST_TEST(root.x >= 0.0);
}

BOOST_AUTO_TEST_CASE(a_useless_slope_leaves_bisection) {
  auto const jump = [](double x) { return WithDerivative<double>{x < 0.3 ? -1.0 : 1.0, 0.0}; };
  auto const root = bracketed_newton(jump, 0.0, 1.0, 0.5, 1e-12);
  BOOST_TEST(root.converged);
  BOOST_TEST(root.x == 0.3, bt::tolerance(1e-11));
  BOOST_TEST(root.iterations <= 42);  // 1e-12 = 2^-40
}

BOOST_AUTO_TEST_CASE(a_flat_root_takes_no_more_than_the_bound) {
  auto const flat = [](double x) {
    double const y = x - 0.7;
    return WithDerivative<double>{std::pow(y, 9), 9 * std::pow(y, 8)};
  };
  auto const root = bracketed_newton(flat, 0.0, 1.0, 0.01, 1e-10);
  BOOST_TEST(root.converged);
  BOOST_TEST(std::abs(root.x - 0.7) < 1e-9);  // the ninth root: a step is a ninth of the error
}

BOOST_AUTO_TEST_CASE(a_bracket_of_one_point_is_its_root_whatever_the_equation_answers) {
  auto const f = [](double) { return WithDerivative<double>{nan, nan}; };
  auto const root = bracketed_newton(f, 3.0, 3.0, 3.0, 1e-12);
  BOOST_TEST(root.converged);
  BOOST_TEST(root.x == 3.0);
  BOOST_TEST(root.iterations == 0);
}

BOOST_AUTO_TEST_CASE(a_bracket_that_is_not_finite_is_reported) {
  BOOST_TEST(!bracketed_newton(cube_less(2.0), nan, 2.0, nan, 1e-12).converged);
}

BOOST_AUTO_TEST_CASE(with_its_curvature_a_root_takes_fewer_steps_and_none_to_see_it) {
  // x^3 - 2 from 1.2: errors 6e-2, 8e-5 (Halley: 2/(3 x^2) e^3), 4e-13, and so on to the last digit
  auto const bent = [](double x) { return WithCurvature<double>{x * x * x - 2, 3 * x * x, 6 * x}; };
  auto const root = bracketed_newton(bent, 0.0, 2.0, 1.2, 1e-12),
             plain = bracketed_newton(cube_less(2.0), 0.0, 2.0, 1.2, 1e-12);
  BOOST_TEST(root.converged);
  BOOST_TEST(root.x == std::cbrt(2.0), bt::tolerance(2 * eps));
  BOOST_TEST(root.iterations == 3);
  BOOST_TEST(plain.iterations == 5);
}

BOOST_AUTO_TEST_CASE(a_rough_or_wrong_curvature_does_no_harm) {
  for (double const wrong : {-HUGE_VAL, -1e308, -1e3, -1.0, 0.0, 0.9, 3.0, 1e3, HUGE_VAL, nan}) {
    auto const bent = [&](double x) { return WithCurvature<double>{x * x * x - 2, 3 * x * x, wrong * 6 * x}; };
    for (double const start : {1e-3, 1.1, 1.2, 1.9}) {
      auto const root = bracketed_newton(bent, 0.0, 2.0, start, 1e-12);
      BOOST_TEST(root.converged);
      BOOST_TEST(std::abs(root.x - std::cbrt(2.0)) < 1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE(where_the_slope_vanishes_the_bracket_is_halved) {
  auto const hill = [](double x) { return WithCurvature<double>{1 - (x - 1) * (x - 1), -2 * (x - 1), -2}; };
  auto const root = bracketed_newton(hill, -1.0, 1.5, 1.0, 1e-12);
  BOOST_TEST(root.converged);
  BOOST_TEST(std::abs(root.x) < 1e-11);
}

BOOST_AUTO_TEST_CASE(a_lane_that_creeps_takes_nothing_from_its_neighbours) {
  // x^2 halves its way to 0 for ever; Newton's iteration for atan leaves the bracket at once
  Lanes creeps = 0.0, start = 9.0;
  creeps.set(0, 1.0);
  start.set(0, 1.0);
  auto const f = [&](Lanes x) {
    Lanes const y = Lanes(10.0) * (x - Lanes(3.0)), steep = lane_by_lane(y, [](double s) { return std::atan(s); });
    auto const first = creeps == Lanes(1.0);
    return WithDerivative<Lanes>{select<Lanes>(first, x * x, steep),
                                 select<Lanes>(first, Lanes(2.0) * x, Lanes(10.0) / (Lanes(1.0) + y * y))};
  };
  auto const root = bracketed_newton<Lanes>(f, 0.0, 10.0, start, 1e-200);
  for (int lane = 1; lane < lanes; ++lane) BOOST_TEST(root.x[lane] == 3.0, bt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(every_lane_finds_its_own_root) {
  Lanes a;
  for (int lane = 0; lane < lanes; ++lane) a.set(lane, std::pow(10.0, lane - 4));
  auto const root = bracketed_newton(cube_less(a), Lanes(0.0), 100.0, 1.0, 1e-15);
  BOOST_TEST(root.converged);
  int slowest = 0;
  for (int lane = 0; lane < lanes; ++lane) {
    auto const alone = bracketed_newton(cube_less(a[lane]), 0.0, 100.0, 1.0, 1e-15);
    slowest = std::max(slowest, alone.iterations);
    BOOST_TEST(root.x[lane] == std::cbrt(a[lane]), bt::tolerance(1e-14));
    BOOST_TEST(root.x[lane] == alone.x, bt::tolerance(4 * eps));
  }
  BOOST_TEST(root.iterations >= slowest - 1);  // a last unit may take one step more
  BOOST_TEST(root.iterations <= 2 * slowest);  // one lane may look after its bracket while another does not
}

BOOST_AUTO_TEST_CASE(a_lane_that_is_done_waits_for_the_others_unchanged) {
  Lanes a = 2.0, tolerance = 0.1;
  auto const early = bracketed_newton(cube_less(a), Lanes(0.0), 2.0, 1.0, tolerance);
  BOOST_TEST(std::abs(early.x[0] - std::cbrt(2.0)) > 1e-4);  // stopped by the tolerance, far from the last digit
  a.set(6, 1e-6);
  tolerance.set(6, 0.0);
  auto const among_slower = bracketed_newton(cube_less(a), Lanes(0.0), 2.0, 1.0, tolerance);
  BOOST_TEST(among_slower.iterations > early.iterations);
  BOOST_TEST(among_slower.x[0] == early.x[0]);
}

BOOST_AUTO_TEST_CASE(a_lane_that_fails_leaves_its_neighbours_alone) {
  Lanes a = 2.0, end = 2.0;
  auto const healthy = bracketed_newton(cube_less(a), Lanes(0.0), end, 1.0, 1e-15);
  end.set(3, nan);
  auto const root = bracketed_newton(cube_less(a), Lanes(0.0), end, 1.0, 1e-15);
  BOOST_TEST(healthy.converged);
  BOOST_TEST(!root.converged);
  BOOST_TEST(root.iterations >= root_iteration_limit);
  for (int lane = 0; lane < lanes; ++lane)
    if (lane != 3) BOOST_TEST(root.x[lane] == healthy.x[lane]);
}

BOOST_AUTO_TEST_CASE(a_root_of_duals_carries_the_derivatives_of_the_implicit_function) {
  using D = Dual<1, Dual<1>>;
  D const a = D::variable(Dual<1>::variable(2.0, 0), 0);
  auto const root = bracketed_newton(cube_less(a), D(0.0), 2.0, 1.0, 0.0);
  BOOST_TEST(root.converged);
  double const x = std::cbrt(2.0);  // x = a^(1/3), x' = x/(3 a), x'' = -2 x/(9 a^2)
  BOOST_TEST(root.x.value.value == x, bt::tolerance(4 * eps));
  BOOST_TEST(root.x.derivative(0).value == x / 6, bt::tolerance(8 * eps));
  BOOST_TEST(root.x.derivative(0).derivative(0) == -x / 18, bt::tolerance(16 * eps));
}

BOOST_AUTO_TEST_SUITE_END()
