#pragma once
/// Expectations against what a run gave.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/cli/program.hpp"
#include "core/io/series.hpp"

namespace talus::cli {

/// One expectation, judged. `found` is NaN where the series does not reach its time.
struct Verdict {
  std::string where;  ///< the case of a study; empty for a single run
  ExpectedValue expected;
  double found = 0;
  bool passed = false;
};

/// Judges expectations by linear interpolation of the series. Throws InputError for a measure that the series lacks.
[[nodiscard]] std::vector<Verdict> judge(std::vector<ExpectedValue> const& expected, io::Series const& series,
                                         std::string const& where);

/// The expectations that a run to `end` [s] can be judged by.
[[nodiscard]] std::vector<ExpectedValue> before_end(std::vector<ExpectedValue> expected, double end);

/// A table for people: measure, time, expected, found, deviation, tolerance, verdict.
[[nodiscard]] std::string verdict_table(std::vector<Verdict> const& verdicts);
[[nodiscard]] nlohmann::json verdict_document(std::vector<Verdict> const& verdicts);
/// What verdict_document wrote.
[[nodiscard]] std::vector<Verdict> verdicts_of(nlohmann::json const& document);

/// The ledgers as a run's summary has them.
[[nodiscard]] nlohmann::json ledger_document(std::vector<Balance> const& balances);
/// The ledgers of a run's summary as lines for people; empty where it kept none.
[[nodiscard]] std::string ledger_lines(nlohmann::json const& summary);

}  // namespace talus::cli
