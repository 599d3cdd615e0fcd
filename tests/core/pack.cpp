#include "core/pack_functions.hpp"

#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>
#include <random>

#include "core/scalar.hpp"

BOOST_AUTO_TEST_SUITE(pack)

using namespace talus;

namespace {

namespace bt = boost::test_tools;
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
using Packs = boost::mpl::list<Pack<2>, Pack<4>, Pack<8>>;

template <class P>
P ramp(double first, double step) {
  P r;
  for (int lane = 0; lane < P::size; ++lane) r.set(lane, first + step * lane);
  return r;
}

/// Distance in units in the last place of the exact value.
double ulps(double got, long double exact) {
  double const rounded = static_cast<double>(exact);
  double const unit = std::max(std::nextafter(std::abs(rounded), inf) - std::abs(rounded), 5e-324);
  return static_cast<double>(std::abs((static_cast<long double>(got) - exact) / unit));
}

}  // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(arithmetic_acts_lane_by_lane, P, Packs) {
  P const a = ramp<P>(1.5, 1.0), b = ramp<P>(-3.25, 0.5);
  P c = a;
  c += b;
  c *= b;
  c -= a;
  c /= b;
  for (int i = 0; i < P::size; ++i) {
    double const x = 1.5 + i, y = -3.25 + 0.5 * i;
    BOOST_TEST((a + b)[i] == x + y);
    BOOST_TEST((a - b)[i] == x - y);
    BOOST_TEST((a * b)[i] == x * y);
    BOOST_TEST((a / b)[i] == x / y);
    BOOST_TEST((-a)[i] == -x);
    BOOST_TEST((2.0 * a)[i] == 2 * x);
    BOOST_TEST(c[i] == ((x + y) * y - x) / y, bt::tolerance(8 * eps));
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(memory_keeps_the_order_of_the_lanes, P, Packs) {
  std::array<double, P::size> in{}, out{};
  for (std::size_t i = 0; i < in.size(); ++i) in[i] = 1.0 / (1.0 + static_cast<double>(i));
  P const p = P::load(in.data());
  p.store(out.data());
  for (int i = 0; i < P::size; ++i) BOOST_TEST(p[i] == in[static_cast<std::size_t>(i)]);
  BOOST_TEST(in == out, bt::per_element());
}

BOOST_AUTO_TEST_CASE_TEMPLATE(comparisons_give_the_truth_of_every_lane, P, Packs) {
  P const a = ramp<P>(0.0, 1.0), one = 1.0;
  for (int i = 0; i < P::size; ++i) {
    BOOST_TEST((a < one)[i] == (i < 1));
    BOOST_TEST((a <= one)[i] == (i <= 1));
    BOOST_TEST((a > one)[i] == (i > 1));
    BOOST_TEST((a >= one)[i] == (i >= 1));
    BOOST_TEST((a == one)[i] == (i == 1));
    BOOST_TEST((a != one)[i] == (i != 1));
    BOOST_TEST(((a < one) || (a > one))[i] == (i != 1));
    BOOST_TEST(((a < one) | (a == one))[i] == (i <= 1));
    BOOST_TEST(((a >= one) && (a <= one))[i] == (i == 1));
    BOOST_TEST(((a >= one) & (a > one))[i] == (i > 1));
    BOOST_TEST((!(a < one))[i] == (i >= 1));
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(any_needs_one_lane_and_all_needs_every_lane, P, Packs) {
  for (int i = 0; i < P::size; ++i) {
    P one_lane = 0.0, all_but_one = 1.0;
    one_lane.set(i, 1.0);
    all_but_one.set(i, 0.0);
    BOOST_TEST(any(one_lane > P(0.5)));
    BOOST_TEST(!all(one_lane > P(0.5)));
    BOOST_TEST(!all(all_but_one > P(0.5)));
  }
  BOOST_TEST(!any(P(0.0) > P(0.5)));
  BOOST_TEST(all(P(1.0) > P(0.5)));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(nan_is_neither_less_nor_equal_nor_finite, P, Packs) {
  P const a = nan;
  BOOST_TEST(!any((a < P(0.0)) || (a >= P(0.0)) || (a == a)));
  BOOST_TEST(all(a != a));
  BOOST_TEST(!any(is_finite(a)));
  BOOST_TEST(!any(is_finite(P(inf)) || is_finite(P(-inf))));
  BOOST_TEST(all(is_finite(P(-std::numeric_limits<double>::max()))));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(select_takes_each_lane_from_its_own_side, P, Packs) {
  P const a = ramp<P>(0.0, 1.0);
  P const r = select<P>(a < P(1.0), -1.0, nan), s = select<P>(a < P(1.0), nan, a);
  BOOST_TEST(r[0] == -1.0);
  BOOST_TEST(std::isnan(s[0]));
  for (int i = 1; i < P::size; ++i) {
    BOOST_TEST(std::isnan(r[i]));
    BOOST_TEST(s[i] == i);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(min_max_abs_and_the_largest_lane_are_those_of_numbers, P, Packs) {
  P const a = ramp<P>(-2.5, 1.0), b = ramp<P>(1.0, -1.0);
  for (int i = 0; i < P::size; ++i) {
    BOOST_TEST(min(a, b)[i] == std::min(a[i], b[i]));
    BOOST_TEST(max(a, b)[i] == std::max(a[i], b[i]));
    BOOST_TEST(abs(a)[i] == std::abs(a[i]));
  }
  BOOST_TEST(horizontal_max(a) == -2.5 + (P::size - 1));
  BOOST_TEST(horizontal_max(b) == 1.0);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(functions_are_those_of_numbers, P, Packs) {
  P const a = ramp<P>(0.25, 0.75);
  for (int i = 0; i < P::size; ++i) {
    double const x = a[i];
    BOOST_TEST(sqrt(a)[i] == std::sqrt(x));
    BOOST_TEST(log(a)[i] == std::log(x), bt::tolerance(2 * eps));
    BOOST_TEST(log1p(a)[i] == std::log1p(x), bt::tolerance(2 * eps));
    BOOST_TEST(expm1(a)[i] == std::expm1(x), bt::tolerance(2 * eps));
    BOOST_TEST(sinh(a)[i] == std::sinh(x), bt::tolerance(2 * eps));
    BOOST_TEST(cosh(a)[i] == std::cosh(x), bt::tolerance(2 * eps));
    BOOST_TEST(asinh(a)[i] == std::asinh(x), bt::tolerance(2 * eps));
  }
}

// Half a unit for the last rounding, the rest for the sums of the polynomial: 0.84 with fused multiply-add, 1.2
// without.
BOOST_AUTO_TEST_CASE_TEMPLATE(exp_is_within_a_unit_and_a_half_in_the_last_place, P, Packs) {
  std::mt19937 random(7);
  double worst = 0;
  for (double const range : {1e-10, 0.3, 1.0, 20.0, 708.0}) {
    std::uniform_real_distribution<double> anywhere(-range, range);
    for (int sample = 0; sample < 20000; ++sample) {
      P x;
      for (int i = 0; i < P::size; ++i) x.set(i, anywhere(random));
      P const e = exp(x);
      for (int i = 0; i < P::size; ++i) worst = std::max(worst, ulps(e[i], std::exp(static_cast<long double>(x[i]))));
    }
  }
  BOOST_TEST_MESSAGE("exp: " << worst << " units in the last place");
  BOOST_TEST(worst < 1.5);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(exp_ends_in_zero_and_infinity_and_keeps_nan, P, Packs) {
  BOOST_TEST(exp(P(0.0))[0] == 1.0);
  BOOST_TEST(exp(P(709.0))[0] == std::exp(709.0), bt::tolerance(2 * eps));
  BOOST_TEST(exp(P(-708.0))[0] == std::exp(-708.0), bt::tolerance(2 * eps));
  for (double const x : {710.0, 1e300, inf}) BOOST_TEST(exp(P(x))[0] == inf);
  for (double const x : {-709.0, -1e300, -inf}) BOOST_TEST(exp(P(x))[0] == 0.0);
  BOOST_TEST(std::isnan(exp(P(nan))[0]));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_lane_of_exp_does_not_depend_on_its_neighbours, P, Packs) {
  for (double const neighbour : {nan, inf, -800.0, 3.0}) {
    P x = neighbour;
    x.set(P::size / 2, 0.7);
    BOOST_TEST(exp(x)[P::size / 2] == exp(P(0.7))[0]);
  }
}

BOOST_AUTO_TEST_SUITE_END()
