/// Orders and floors are found where they are known.

#include "verification/suite/order.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "verification/suite/refinement.hpp"

BOOST_AUTO_TEST_SUITE(order)

using namespace talus::verification;
using boost::test_tools::tolerance;

namespace {

std::vector<double> const halved{1. / 16, 1. / 32, 1. / 64, 1. / 128};

/// factor h^order + floor, times 1 -+ scatter in turns.
std::vector<double> errors_of(double factor, double order, double floor = 0, double scatter = 0) {
  std::vector<double> errors;
  double sign = 1;
  for (double const h : halved)
    errors.push_back((factor * std::pow(h, order) + floor) * (1 + (sign = -sign) * scatter));
  return errors;
}

/// What a study finds whose only norm is this one.
Findings found(Norm norm, std::vector<double> const& errors) {
  Findings findings;
  norm.name = "u";
  refine(findings, {"thing", halved, {norm}, [&](std::size_t k) { return Measured{{errors[k]}, {1, 10, 100}}; }}, "T");
  return findings;
}

}  // namespace

BOOST_AUTO_TEST_CASE(exact_powers_have_their_order_and_no_doubt) {
  for (double const p : {0.5, 1., 2., 3.7}) {
    for (double const pair : pairwise_orders(halved, errors_of(3, p))) BOOST_TEST(pair == p, tolerance(1e-12));
    auto const slope = fitted_slope(halved, errors_of(3, p));
    BOOST_TEST(slope->value == p, tolerance(1e-12));
    BOOST_TEST(*slope->interval.high - *slope->interval.low < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(the_interval_is_students) {
  // x = 0, 1, 2, 3 and y = 0, 1, 0, 1: sum of squares of x about its mean 5, slope 0.2, of the residuals 0.8
  std::vector<double> const h{1, std::exp(1), std::exp(2), std::exp(3)}, e{1, std::exp(1), 1, std::exp(1)};
  auto const slope = fitted_slope(h, e);
  double const half = 4.302652730 * std::sqrt(0.8 / 2 / 5);
  BOOST_TEST(slope->value == 0.2, tolerance(1e-12));
  BOOST_TEST(*slope->interval.low == 0.2 - half, tolerance(1e-8));
  BOOST_TEST(*slope->interval.high == 0.2 + half, tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(quantiles_are_those_of_the_tables) {
  BOOST_TEST(student_95(1) == 12.706204736, tolerance(1e-9));
  BOOST_TEST(student_95(10) == 2.228138852, tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_scattered_order_lies_within_its_interval) {
  auto const slope = fitted_slope(halved, errors_of(3, 2, 0, 0.1));
  BOOST_TEST(slope->interval.contains(2));
  BOOST_TEST(!slope->interval.contains(4));
}

BOOST_AUTO_TEST_CASE(a_floor_is_found_and_no_power_has_one) {
  for (double const p : {1., 2., 3.}) {
    double const floor = 0.5 * std::pow(halved.back(), p);
    auto const fit = fitted_floor(halved, errors_of(1, p, floor));
    BOOST_TEST(fit->order == p, tolerance(1e-5));
    BOOST_TEST(fit->floor == floor, tolerance(1e-4));
    BOOST_TEST(fit->floored());
    BOOST_TEST(!fitted_floor(halved, errors_of(1, p))->floored());
  }
  BOOST_TEST(fitted_floor(halved, {1e-2, 2.6e-3, 1.1e-3, 1.2e-3})->floored());
}

BOOST_AUTO_TEST_CASE(what_is_no_convergence_is_told_apart) {
  BOOST_TEST(!fitted_floor(halved, {1e-3, 2e-3, 4e-3, 8e-3}));  // rises
  BOOST_TEST(!fitted_floor(halved, {1, 0.1, 0, 1e-3}));
  BOOST_TEST(!fitted_slope(halved, {1, 0.1, std::nan(""), 1e-3}));
  BOOST_TEST(std::isnan(pairwise_orders(halved, {1, 0.1, 0, 1e-3}).back()));
  BOOST_TEST(pairwise_orders(halved, {1e-3, 2e-3, 4e-3, 8e-3}).back() == -1, tolerance(1e-12));
  BOOST_TEST(!fitted_slope({1, 0.5}, {1, 0.25})->interval.low);
}

BOOST_AUTO_TEST_CASE(a_study_passes_or_fails_by_order_and_level) {
  auto const good = found({.unit = "m", .order = 1.85, .level = 2e-4, .because = "theory"}, errors_of(3, 2));
  BOOST_TEST_REQUIRE(good.rows.size() == 2u);
  BOOST_TEST(good.rows[0].measure == "order of u");
  BOOST_TEST(good.rows[1].measure == "error of u at h = 1/128");
  BOOST_TEST(good.rows[1].unit == "m");
  BOOST_TEST(good.rows[0].cost.seconds == 4);
  BOOST_TEST(good.rows[1].cost.steps == 10);
  BOOST_TEST((good.rows[0].verdict == Verdict::pass && good.rows[1].verdict == Verdict::pass));
  BOOST_TEST((found({.order = 1.85}, errors_of(3, 1.5)).rows[0].verdict == Verdict::fail));
  BOOST_TEST((found({.order = 1, .most_order = 1.2}, errors_of(3, 2)).rows[0].verdict == Verdict::fail));
  BOOST_TEST((found({.level = 1e-9}, errors_of(3, 2)).rows[1].verdict == Verdict::fail));
  BOOST_TEST((found({.order = 2}, {1, 0.1, 0.01, std::nan("")}).rows[0].verdict == Verdict::fail));
}

BOOST_AUTO_TEST_CASE(a_study_tells_floors_and_lucky_orders) {
  auto const floored = found({.order = 1.85}, errors_of(1, 2, 1e-4)).rows[0];
  BOOST_TEST((floored.verdict == Verdict::floored));
  BOOST_TEST(floored.because.find("errors approach 0.0001") != std::string::npos);
  auto const lucky = found({.order = 1}, errors_of(1, 2)).rows[0];
  BOOST_TEST((lucky.verdict == Verdict::pass));
  BOOST_TEST(lucky.because.find("pre-asymptotic") != std::string::npos);
  auto const free = found({}, errors_of(1, 2));
  BOOST_TEST((free.rows[0].verdict == Verdict::noted && free.rows[1].verdict == Verdict::noted));
}

BOOST_AUTO_TEST_CASE(studies_of_one_title_share_a_plot) {
  Findings findings;
  auto const solve = [](std::size_t k) { return Measured{{halved[k], halved[k] * halved[k]}}; };
  for (auto const* subject : {"a", "b"})
    refine(findings, {subject, halved, {{.name = "u"}, {.name = "v"}}, solve}, "Ring");
  BOOST_TEST_REQUIRE(findings.plots.size() == 2u);
  BOOST_TEST(findings.plots[1].title == "Ring: v");
  BOOST_TEST(findings.plots[1].curves.size() == 4u);  // two guides, two subjects
  BOOST_TEST(findings.plots[1].curves[0].guide);
}

BOOST_AUTO_TEST_CASE(a_study_that_makes_no_sense_is_refused) {
  Findings findings;
  auto const solve = [](std::size_t) { return Measured{{1}}; };
  BOOST_CHECK_THROW(refine(findings, {"a", {0.1}, {{.name = "u"}}, solve}, "T"), std::logic_error);
  BOOST_CHECK_THROW(refine(findings, {"a", {0.1, 0.2}, {{.name = "u"}}, solve}, "T"), std::logic_error);
  BOOST_CHECK_THROW(refine(findings, {"a", {0.2, 0.1}, {{.name = "u"}, {.name = "v"}}, solve}, "T"), std::logic_error);
}

BOOST_AUTO_TEST_SUITE_END()
