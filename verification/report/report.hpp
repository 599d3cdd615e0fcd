#pragma once
/// All that a report tells, and the forms in which it does.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "verification/suite/comparison.hpp"
#include "verification/suite/result.hpp"

namespace talus::verification {

/// A run of the suite.
struct Report {
  std::vector<Result> results;
  nlohmann::json provenance;
  double seconds = 0;  ///< wall time of all of it
  int jobs = 1;
  std::optional<Comparison> against = {};
};

/// The whole of it: results.json. With a comparison it bears the member "against".
[[nodiscard]] nlohmann::json document_of(Report const& report);

/// A line a case, and below it the rows that are not green; with `all`, every row. Then what has changed, and totals.
/// `colour`: verdicts in colours of a terminal.
[[nodiscard]] std::string text_of(Report const& report, bool all, bool colour);

/// "12 rows: 10 passed, 1 failed, 1 noted; 2 cases in 3.1 s".
[[nodiscard]] std::string totals_text(Report const& report);

/// A table of cases, then a section with a table of rows each, for docs/verification.md. Times have two digits.
[[nodiscard]] std::string markdown_of(Report const& report);

/// A line a row, numbers in full. RFC 4180.
[[nodiscard]] std::string csv_of(Report const& report);

/// A suite a case, a test a row: failed and floored are failures, error is an error, omitted is skipped.
[[nodiscard]] std::string junit_of(Report const& report);

/// One file that needs no other and no network: the page's template (verification/report/page/) around results.json.
[[nodiscard]] std::string page_of(Report const& report);

/// Writes results.json, results.csv, junit.xml, report.html and report.md into a folder that is there. Throws FileError.
void write_folder(std::string const& folder, Report const& report);

}  // namespace talus::verification
