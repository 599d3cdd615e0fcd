/// Results keep every bit on their way through JSON, and are compared with those of an earlier run.

#include "verification/suite/document.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/config/json.hpp"
#include "core/errors.hpp"
#include "tests/support/says.hpp"
#include "verification/suite/comparison.hpp"

BOOST_AUTO_TEST_SUITE(document)

using namespace talus::verification;
using talus::json_of;
using talus::support::says;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Findings all_there_can_be() {
  Findings findings;
  findings.check("a", "order of u", 0.1 + 0.2, {1.85, 2.2}, "theory", {0.3, 100, 1e6}).uncertainty = {-infinity,
                                                                                                      1.0 / 3};
  findings.note("a", "error of u", -infinity).unit = "m";
  findings.omit("b", "all", "\"why\" \n not");
  findings.rows.back().verdict = Verdict::floored;
  findings.plots.push_back({"T", "h [m]", "e [m]", true, false, {{"c", {0.1, 0.05}, {std::nan(""), 1e-300}, true}}});
  findings.work.push_back({"vortex", "u", "cubic", "apic", 3, 64, 1e-3, {0.3, 100, 1e6}});
  return findings;
}

Result result(std::string id, std::vector<Row> rows) {
  Result made{std::move(id), "title", "truth", "source"};
  made.findings.rows = std::move(rows);
  return made;
}

Row row(std::string measure, double found, Verdict verdict = Verdict::pass) {
  return {.subject = "s", .measure = std::move(measure), .found = found, .verdict = verdict};
}

}  // namespace

BOOST_AUTO_TEST_CASE(findings_come_back_as_they_were) {
  auto const before = all_there_can_be();
  auto const text = document_of(before).dump();
  auto const after = findings_of(json_of(text));
  BOOST_TEST(document_of(after).dump() == text);
  BOOST_TEST_REQUIRE(after.rows.size() == 3u);
  BOOST_TEST(after.rows[0].found == 0.1 + 0.2);
  BOOST_TEST(*after.rows[0].uncertainty.low == -infinity);
  BOOST_TEST(*after.rows[0].uncertainty.high == 1.0 / 3);
  BOOST_TEST(*after.rows[0].allowed.high == 2.2);
  BOOST_TEST(after.rows[0].cost.steps == 100);
  BOOST_TEST(after.rows[1].found == -infinity);
  BOOST_TEST(!after.rows[1].allowed.low);
  BOOST_TEST(std::isnan(after.rows[2].found));
  BOOST_TEST(after.rows[2].because == "\"why\" \n not");
  BOOST_TEST((after.rows[2].verdict == Verdict::floored));
  BOOST_TEST(std::isnan(after.plots.at(0).curves.at(0).y.at(0)));
  BOOST_TEST(after.plots[0].curves[0].y[1] == 1e-300);
  BOOST_TEST(after.work.at(0).cost.seconds == 0.3);
}

BOOST_AUTO_TEST_CASE(what_is_no_such_document_is_refused) {
  BOOST_CHECK_THROW((void)findings_of(json_of("{\"rows\": 3}")), talus::InputError);
  BOOST_CHECK_EXCEPTION((void)results_of(json_of(R"({"schema": "talus/bench/1"})")), talus::InputError,
                        says("talus/verification/1"));
  BOOST_CHECK_THROW((void)results_of(json_of("[]")), talus::InputError);
  BOOST_CHECK_THROW((void)verdict_named("passed"), talus::InputError);
}

BOOST_AUTO_TEST_CASE(a_run_is_green_where_nothing_failed) {
  auto const passed = result("a", {row("x", 1), row("y", 1, Verdict::noted), row("z", 1, Verdict::omitted)});
  BOOST_TEST(is_green(totals({passed})));
  for (auto const verdict : {Verdict::fail, Verdict::floored, Verdict::error})
    BOOST_TEST(!is_green(totals({passed, result("b", {row("x", 1, verdict)})})));
  auto const document = document_of({passed}, {}, 1, 2);
  BOOST_TEST(document["green"] == true);
  BOOST_TEST(document["totals"]["omitted"] == 1);
  BOOST_TEST(results_of(document).at(0).findings.rows.size() == 3u);
}

BOOST_AUTO_TEST_CASE(rows_meet_those_of_the_earlier_run) {
  auto const now =
      result("a", {row("x", 1.1), row("twice", 1), row("twice", 2), row("fresh", 1), row("bad", 3, Verdict::fail)});
  auto const before = result("a", {row("twice", 1), row("twice", 4), row("x", 1), row("lost", 7), row("bad", 2)});
  auto const found = compare({now}, {before, result("b", {row("x", 1)})});
  BOOST_TEST_REQUIRE(found.changes.size() == 6u);
  BOOST_TEST(change_text(found.changes[0]) == "+10.00 %");
  BOOST_TEST(change_text(found.changes[1]) == "same");
  BOOST_TEST(change_text(found.changes[2]) == "-50.00 %");
  BOOST_TEST(change_text(found.changes[3]) == "new");
  BOOST_TEST(found.changes[4].verdict_changed());
  BOOST_TEST(found.changes[5].measure == "lost");
  BOOST_TEST(change_text(found.changes[5]) == "gone");
  BOOST_TEST((found.not_run == std::vector<std::string>{"b"}));
}

BOOST_AUTO_TEST_CASE(a_change_that_is_no_percentage_is_told_by_the_earlier_value) {
  auto const text = [](double now, double before) {
    return change_text(compare({result("a", {row("x", now)})}, {result("a", {row("x", before)})}).changes.at(0));
  };
  BOOST_TEST(text(1, 0) == "0 before");
  BOOST_TEST(text(1, 1e-4) == "0.0001 before");
  BOOST_TEST(text(std::nan(""), 2) == "2 before");
  BOOST_TEST(text(std::nan(""), std::nan("")) == "same");
  BOOST_TEST(text(0, 0) == "same");
  BOOST_TEST(text(1 + 1e-12, 1) == "+1e-10 %");
}

BOOST_AUTO_TEST_CASE(values_are_told_in_short) {
  BOOST_TEST(value_text(1.23456e-5, "m") == "1.235e-05 m");
  BOOST_TEST(value_text(2, "1") == "2");
  BOOST_TEST(allowed_text({1.85, {}}) == "≥ 1.85");
  BOOST_TEST(allowed_text({-1, 1}) == "-1 … 1");
  BOOST_TEST(interval_text({1.9, 2.0512}) == "[1.9, 2.05]");
  BOOST_TEST(interval_text({}) == "");
  BOOST_TEST(duration_text(0.012) == "0.01 s");
  BOOST_TEST(duration_text(4.06) == "4.1 s");
  BOOST_TEST(duration_text(123.4) == "2:03");
  BOOST_TEST(duration_text(3723) == "1:02:03");
}

BOOST_AUTO_TEST_SUITE_END()
