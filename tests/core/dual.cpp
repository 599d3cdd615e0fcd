#include "core/dual.hpp"

#include <boost/test/unit_test.hpp>
#include <complex>
#include <functional>

BOOST_AUTO_TEST_SUITE(dual)

using namespace talus;

namespace {

namespace bt = boost::test_tools;
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
using D1 = Dual<1>;
using D2 = Dual<2>;

D1 unknown(double x) {
  return D1::variable(x, 0);
}

/// f'(x) = Im f(x + i h)/h, exact to rounding for h = 1e-100.
double complex_step(std::function<std::complex<double>(std::complex<double>)> const& f, double x) {
  return f({x, 1e-100}).imag() / 1e-100;
}

}  // namespace

BOOST_AUTO_TEST_CASE(slopes_of_functions_agree_with_the_complex_step) {
  for (double const x : {1e-3, 0.3, 1.0, 2.5}) {
    auto const agree = [x](auto const& f) {
      D1 const mine = f(unknown(x));
      BOOST_TEST(mine.value == f(std::complex<double>(x)).real(), bt::tolerance(8 * eps));
      BOOST_TEST(mine.derivative(0) == complex_step(f, x), bt::tolerance(8 * eps));
    };
    agree([](auto y) { return sqrt(y); });
    agree([](auto y) { return exp(y); });
    agree([](auto y) { return log(y); });
    agree([](auto y) { return sinh(y); });
    agree([](auto y) { return cosh(y); });
    agree([](auto y) { return asinh(y); });
    agree([](auto y) { return (y * y - 3.0) / (y + 1.0) * -y; });
  }
}

BOOST_AUTO_TEST_CASE(log1p_and_expm1_undo_one_another_with_all_digits_at_tiny_arguments) {
  for (double const x : {1e-12, -1e-5, 0.2, 3.0}) {
    D1 const there = expm1(unknown(x)), back = log1p(there);
    BOOST_TEST(there.derivative(0) == std::exp(x), bt::tolerance(2 * eps));
    BOOST_TEST(back.value == x, bt::tolerance(8 * eps));
    BOOST_TEST(back.derivative(0) == 1.0, bt::tolerance(8 * eps));
  }
}

BOOST_AUTO_TEST_CASE(gradients_follow_every_unknown) {
  D2 const x = D2::variable(3.0, 0), y = D2::variable(2.0, 1);
  D2 const f = x * x * y - x / y;  // f_x = 2 x y - 1/y, f_y = x^2 + x/y^2
  BOOST_TEST(f.value == 16.5);
  BOOST_TEST(f.derivative(0) == 11.5);
  BOOST_TEST(f.derivative(1) == 9.75);
  D2 g = x;
  g += y;
  g *= x;
  g -= 1.0;
  g /= y;  // ((x + y) x - 1)/y: g_x = (2 x + y)/y, g_y = (1 - x^2)/y^2
  BOOST_TEST(g.value == 7.0);
  BOOST_TEST(g.derivative(0) == 4.0);
  BOOST_TEST(g.derivative(1) == -2.0);
}

BOOST_AUTO_TEST_CASE(a_number_depends_on_nothing) {
  D2 const x = D2::variable(5.0, 1);
  D2 const f = 2.0 * x + 1.0;
  BOOST_TEST(f.derivative(0) == 0.0);
  BOOST_TEST(f.derivative(1) == 2.0);
  BOOST_TEST(D2(7.0).derivative(1) == 0.0);
}

BOOST_AUTO_TEST_CASE(nested_duals_give_second_derivatives) {
  using Second = Dual<2, Dual<2>>;
  auto const x = Second::variable(D2::variable(1.5, 0), 0), y = Second::variable(D2::variable(0.5, 1), 1);
  Second const f = x * x * x * exp(2.0 * y) + sqrt(x);
  double const e = std::exp(1.0), root = std::sqrt(1.5);
  auto const close = bt::tolerance(8 * eps);
  BOOST_TEST(f.value.value == 3.375 * e + root, close);
  BOOST_TEST(f.derivative(0).value == 6.75 * e + 0.5 / root, close);
  BOOST_TEST(f.derivative(0).derivative(0) == 9.0 * e - 0.25 / (1.5 * root), close);
  BOOST_TEST(f.derivative(0).derivative(1) == 13.5 * e, close);
  BOOST_TEST(f.derivative(1).derivative(0) == 13.5 * e, close);
  BOOST_TEST(f.derivative(1).derivative(1) == 13.5 * e, close);
}

BOOST_AUTO_TEST_CASE(comparisons_look_at_values_alone) {
  D1 const a = unknown(1.0), b = 1.0;
  BOOST_TEST(bool(a == b));
  BOOST_TEST(!bool(a != b));
  BOOST_TEST(bool(a <= b && a >= b));
  BOOST_TEST(bool(a < 2.0 && 2.0 > a));
}

BOOST_AUTO_TEST_CASE(abs_min_and_max_follow_the_branch_that_they_take) {
  D1 const x = unknown(-2.0);
  BOOST_TEST(abs(x).value == 2.0);
  BOOST_TEST(abs(x).derivative(0) == -1.0);
  BOOST_TEST(max(x, D1(-3.0)).derivative(0) == 1.0);
  BOOST_TEST(max(x, D1(0.0)).derivative(0) == 0.0);
  BOOST_TEST(min(x, D1(-3.0)).derivative(0) == 0.0);
  BOOST_TEST(min(x, D1(0.0)).derivative(0) == 1.0);
}

BOOST_AUTO_TEST_CASE(select_drops_the_derivatives_of_the_branch_not_taken) {
  D1 const x = unknown(0.0), poisoned = log(x);
  BOOST_TEST(!is_finite(poisoned));
  D1 const kept = select<D1>(x > D1(0.0), poisoned, 3.0 * x);
  BOOST_TEST(kept.value == 0.0);
  BOOST_TEST(kept.derivative(0) == 3.0);
}

BOOST_AUTO_TEST_CASE(a_norm_is_flat_where_its_argument_vanishes_but_the_root_of_a_ramp_is_not) {
  D1 const x = unknown(0.0);
  D1 const norm = sqrt(x * x);
  BOOST_TEST(norm.value == 0.0);
  BOOST_TEST(norm.derivative(0) == 0.0);
  BOOST_TEST(!is_finite(sqrt(x)));
}

BOOST_AUTO_TEST_CASE(a_derivative_that_is_not_finite_is_seen) {
  D2 a = 1.0;
  BOOST_TEST(is_finite(a));
  a.gradient[1] = nan;
  BOOST_TEST(!is_finite(a));
}

BOOST_AUTO_TEST_CASE(duals_of_packs_are_duals_in_every_lane) {
  using P = Pack<4>;
  P x;
  for (int lane = 0; lane < 4; ++lane) x.set(lane, lane - 1.5);
  auto const d = Dual<1, P>::variable(x, 0);
  auto const f = select<Dual<1, P>>(d < Dual<1, P>(0.0), d * d, exp(d));
  for (int lane = 0; lane < 4; ++lane) {
    double const s = lane - 1.5;
    BOOST_TEST_CONTEXT("x = " << s) {
      BOOST_TEST(f.value[lane] == (s < 0 ? s * s : std::exp(s)), bt::tolerance(4 * eps));
      BOOST_TEST(f.derivative(0)[lane] == (s < 0 ? 2 * s : std::exp(s)), bt::tolerance(4 * eps));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
