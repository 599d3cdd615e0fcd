/// Whatever the text of a case holds, every form of the report stays what it is.

#include "verification/report/report.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/io/provenance.hpp"

BOOST_AUTO_TEST_SUITE(report)

using namespace talus::verification;

namespace {

Report hostile() {
  Result result{"some/case", "A | title", "truth", "source", 1};
  result.findings.check("a | b", "order \"of\" <u>", 0.4, at_least(1.85), "why,\nindeed \x01").verdict =
      Verdict::floored;
  result.findings.check("c", "d & </script>", std::nan(""), at_most(1), "");
  result.findings.omit("e", "all", "singular");
  result.findings.note("f", "u", 1.5e-7).unit = "m";
  result.findings.rows.push_back({.subject = "the case", .measure = "ends", .verdict = Verdict::error, .because = "x"});
  return {{result}, talus::io::provenance_document({}), 1.5, 2};
}

std::size_t count(std::string const& text, std::string const& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

bool holds(std::string const& text, std::string const& part) {
  return count(text, part) > 0;
}

}  // namespace

BOOST_AUTO_TEST_CASE(text_shows_what_is_not_green_and_all_if_asked) {
  auto const brief = text_of(hostile(), false, false), full = text_of(hostile(), true, false);
  BOOST_TEST(holds(brief, "FLOORED  a | b: order \"of\" <u> = 0.4, asked ≥ 1.85"));
  BOOST_TEST(holds(brief, "ERROR  the case: ends (x)"));
  BOOST_TEST(!holds(brief, "singular"));
  BOOST_TEST(holds(full, "singular"));
  BOOST_TEST(holds(full, "1.5e-07 m"));
  BOOST_TEST(holds(brief, "5 rows: 1 failed, 1 floored, 1 with an error, 1 omitted, 1 noted; 1 case in 1.5 s"));
  BOOST_TEST(!holds(brief, "\033"));
  BOOST_TEST(holds(text_of(hostile(), false, true), "\033[31mERROR\033[0m"));
}

BOOST_AUTO_TEST_CASE(a_row_of_markdown_stays_one_row) {
  auto const text = markdown_of(hostile());
  BOOST_TEST(holds(text, "| a \\| b | order \"of\" \\<u> | 0.4 |  | ≥ 1.85 | **floored** |"));
  BOOST_TEST(holds(text, "why, indeed"));
  BOOST_TEST(holds(text, "[some/case](#somecase)"));
}

BOOST_AUTO_TEST_CASE(csv_quotes_what_must_be_quoted) {
  auto const text = csv_of(hostile());
  BOOST_TEST(holds(text, "some/case,1,a | b,\"order \"\"of\"\" <u>\",1,0.4,,,1.85,,floored,0,0,0,\"why,\nindeed"));
  BOOST_TEST(holds(text, "c,d & </script>,1,,,,,1,fail,"));
}

BOOST_AUTO_TEST_CASE(junit_counts_and_escapes) {
  auto const text = junit_of(hostile());
  BOOST_TEST(holds(text, "tests=\"5\" failures=\"2\" errors=\"1\" skipped=\"1\""));
  BOOST_TEST(holds(text, "name=\"a | b: order &quot;of&quot; &lt;u&gt;\""));
  BOOST_TEST(count(text, "<testcase ") == 5u);
  BOOST_TEST(count(text, "<failure type=\"floored\"") == 1u);
  BOOST_TEST(!holds(text, "\x01"));
}

BOOST_AUTO_TEST_CASE(nothing_ends_the_pages_data_early) {
  auto const page = page_of(hostile());
  BOOST_TEST(count(page, "</script>") == 2u);
  BOOST_TEST(holds(page, "d & \\u003c/script>"));
  BOOST_TEST(!holds(page, "/* the script */"));
  BOOST_TEST(!holds(page, "/* the style */"));
}

BOOST_AUTO_TEST_SUITE_END()
