/// Limits of infinitely fine grids, and how sure they are, where they are known.

#include "verification/suite/richardson.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

BOOST_AUTO_TEST_SUITE(richardson)

using namespace talus::verification;
using boost::test_tools::tolerance;

namespace {

std::vector<double> const halved{0.4, 0.2, 0.1, 0.05, 0.025};
constexpr double limit = 7;

std::vector<double> values_of(double factor, double order, std::vector<double> const& spacings) {
  std::vector<double> values;
  for (double const h : spacings) values.push_back(limit + factor * std::pow(h, order));
  return values;
}

double error_of(std::vector<double> const& values) {
  return std::abs(values.back() - limit);
}

}  // namespace

BOOST_AUTO_TEST_CASE(three_grids_of_any_ratio_give_order_and_limit_of_a_power) {
  for (auto const& spacings : {halved, {0.3, 0.2, 0.1}, {0.5, 0.2, 0.15}})
    for (double const p : {0.7, 1., 2., 3.}) {
      auto const values = values_of(-3, p, spacings);
      auto const found = convergence_of_three(spacings, values);
      BOOST_TEST((found.approach == Approach::monotone));
      BOOST_TEST(found.order == p, tolerance(1e-9));
      BOOST_TEST(found.extrapolated == limit, tolerance(1e-9));
      BOOST_TEST(found.uncertainty == 1.25 * error_of(values), tolerance(1e-7));
    }
}

BOOST_AUTO_TEST_CASE(two_grids_are_trusted_less) {
  auto const values = values_of(2, 2, halved);
  auto const found = convergence_of_two(halved, values, 2);
  BOOST_TEST(found.extrapolated == limit, tolerance(1e-12));
  BOOST_TEST(found.uncertainty == 3 * error_of(values), tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(what_does_not_converge_is_told) {
  auto const swings = convergence_of_three({4, 2, 1}, {1.2, 0.9, 1.1});
  BOOST_TEST((swings.approach == Approach::oscillating));
  BOOST_TEST(swings.uncertainty == 0.9, tolerance(1e-12));
  auto const flees = convergence_of_three({4, 2, 1}, {1, 1.1, 1.3});
  BOOST_TEST((flees.approach == Approach::unclear));
  BOOST_TEST(flees.uncertainty == 0.9, tolerance(1e-12));
  BOOST_TEST((convergence_of_three({4, 2, 1}, {1, 1.1, 1.1}).approach == Approach::unclear));
  BOOST_TEST(convergence_of_three({4, 2, 1}, {1, 1, 1}).uncertainty == 0);
}

BOOST_AUTO_TEST_CASE(least_squares_give_order_and_limit_of_a_power) {
  for (double const p : {0.8, 1., 1.5, 1.9}) {
    auto const values = values_of(2, p, halved);
    auto const found = convergence_by_least_squares(halved, values);
    BOOST_TEST(found.order == p, tolerance(1e-5));
    BOOST_TEST(found.extrapolated == limit, tolerance(1e-6));
    BOOST_TEST(found.uncertainty == 1.25 * error_of(values), tolerance(1e-3));
  }
}

BOOST_AUTO_TEST_CASE(an_order_that_is_too_good_is_not_believed) {
  auto const values = values_of(2, 4, halved);
  auto const found = convergence_by_least_squares(halved, values);
  BOOST_TEST(found.order == 4, tolerance(1e-4));
  BOOST_TEST(found.uncertainty > 3 * error_of(values));
}

BOOST_AUTO_TEST_CASE(scatter_and_oscillation_widen_the_uncertainty_and_it_holds_the_truth) {
  std::mt19937 source(1);
  std::normal_distribution<double> scatter;
  for (double const size : {0.001, 0.01, 0.1}) {
    int held = 0;
    for (int trial = 0; trial < 300; ++trial) {
      auto values = values_of(1, 1.5, halved);
      for (double& value : values) value += size * scatter(source);
      held += convergence_by_least_squares(halved, values).uncertainty >= error_of(values);
    }
    // 95 % are promised for many grids; five that scatter give somewhat less
    BOOST_TEST(held >= 255, held << " of 300 at scatter " << size);
  }
  std::vector<double> const swings{1.2, 0.9, 1.15, 0.95, 1.1};
  auto const found = convergence_by_least_squares(halved, swings);
  BOOST_TEST((found.approach == Approach::oscillating));
  BOOST_TEST(found.uncertainty > 0.1);
  BOOST_TEST(convergence_by_least_squares(halved, {1, 1, 1, 1, 1}).uncertainty == 0);
}

BOOST_AUTO_TEST_SUITE_END()
