/// The forms for programs: CSV and JUnit's XML.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/io/xml.hpp"
#include "verification/report/report.hpp"

namespace talus::verification {

namespace {

/// A field of RFC 4180.
std::string field(std::string const& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char const c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// Empty where there is no number, or none that is finite.
std::string number(std::optional<double> const& value) {
  return value && std::isfinite(*value) ? fmt::format("{}", *value) : "";
}

/// Text in an attribute; control characters, which XML cannot hold, are left out.
std::string attribute(std::string text) {
  std::erase_if(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t'; });
  return io::xml::escape(text);
}

/// What stands in the element of a row that is no plain success.
std::string outcome(Row const& row) {
  auto const said = attribute(row.because);
  auto const found = attribute(
      fmt::format("found {}, asked {}: {}", value_text(row.found, row.unit), allowed_text(row.allowed), row.because));
  switch (row.verdict) {
    case Verdict::fail:
      return fmt::format("<failure type=\"fail\" message=\"{}\"/>", found);
    case Verdict::floored:
      return fmt::format("<failure type=\"floored\" message=\"{}\"/>", found);
    case Verdict::error:
      return fmt::format("<error type=\"error\" message=\"{}\"/>", said);
    case Verdict::omitted:
      return fmt::format("<skipped message=\"{}\"/>", said);
    case Verdict::pass:
    case Verdict::noted:
      break;
  }
  return "";
}

std::string counts(Totals const& all) {
  std::size_t tests = 0;
  for (std::size_t const some : all) tests += some;
  return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\"", tests,
                     count(all, Verdict::fail) + count(all, Verdict::floored), count(all, Verdict::error),
                     count(all, Verdict::omitted));
}

}  // namespace

std::string csv_of(Report const& report) {
  std::string text =
      "case,tier,subject,measure,unit,found,uncertainty_low,uncertainty_high,allowed_low,allowed_high,verdict,seconds,"
      "steps,particle_steps,because\n";
  for (Result const& result : report.results)
    for (Row const& row : result.findings.rows)
      text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", field(result.id), result.tier,
                          field(row.subject), field(row.measure), field(row.unit), number(row.found),
                          number(row.uncertainty.low), number(row.uncertainty.high), number(row.allowed.low),
                          number(row.allowed.high), word_of(row.verdict), row.cost.seconds, row.cost.steps,
                          row.cost.particle_steps, field(row.because));
  return text;
}

std::string junit_of(Report const& report) {
  auto text =
      fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"talus verify\" {} time=\"{:.3f}\">\n",
                  counts(totals(report.results)), report.seconds);
  for (Result const& result : report.results) {
    text += fmt::format("  <testsuite name=\"{}\" {} time=\"{:.3f}\">\n", attribute(result.id),
                        counts(totals(result.findings)), result.seconds);
    for (Row const& row : result.findings.rows)
      text += fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\">{}</testcase>\n",
                          attribute(result.id), attribute(row.subject + ": " + row.measure), row.cost.seconds,
                          outcome(row));
    text += "  </testsuite>\n";
  }
  return text + "</testsuites>\n";
}

}  // namespace talus::verification
