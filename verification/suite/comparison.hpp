#pragma once
/// This run beside an earlier one, row by row.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "verification/suite/result.hpp"

namespace talus::verification {

/// A row and the one of the same case, subject and measure in the earlier run; of several of one name each meets its
/// own, in their order.
struct Change {
  std::string id, subject, measure, unit;
  double found, earlier;                            ///< NaN where there is none
  std::optional<Verdict> verdict, earlier_verdict;  ///< none: the row has vanished; the row is new

  [[nodiscard]] bool is_new() const { return !earlier_verdict; }
  [[nodiscard]] bool vanished() const { return !verdict; }
  [[nodiscard]] bool verdict_changed() const { return verdict && earlier_verdict && *verdict != *earlier_verdict; }
  /// found / earlier - 1; nothing where that is no finite number, 0 where both are the same.
  [[nodiscard]] std::optional<double> relative() const;
};

struct Comparison {
  std::string folder, version, start;  ///< of the earlier run
  std::vector<Change> changes;         ///< all rows of this run in their order, each case followed by what has vanished
  std::vector<std::string> not_run;    ///< cases of the earlier run that this one leaves out
};

/// Only cases of `results` are compared.
[[nodiscard]] Comparison compare(std::vector<Result> const& results, std::vector<Result> const& earlier);

/// Compares with the results.json in a folder. Throws FileError, InputError.
[[nodiscard]] Comparison compare_with(std::vector<Result> const& results, std::string const& folder);

/// "+1.2 %", "same", "1.2e-05 before", "new"; for the column beside a row.
[[nodiscard]] std::string change_text(Change const& change);

/// For results.json: {"folder", "version", "start", "not_run", "changes"}.
[[nodiscard]] nlohmann::json document_of(Comparison const& comparison);

}  // namespace talus::verification
