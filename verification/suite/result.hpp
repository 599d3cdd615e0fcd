#pragma once
/// What came out of running a case, with what the report says of the case itself.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "verification/suite/case.hpp"
#include "verification/suite/findings.hpp"

namespace talus::verification {

/// A case that ran, or that an earlier run tells of.
struct Result {
  std::string id, title, truth, source;
  int tier = 0;
  Findings findings = {};
  double seconds = 0, processor_seconds = 0;  ///< wall time; time of all its threads [s]
  std::int64_t peak_memory = 0;               ///< [bytes]
};

/// The facts of a case, and no findings.
[[nodiscard]] Result result_of(Case const& facts);

/// How many rows have each verdict, by the number of the verdict.
using Totals = std::array<std::size_t, 6>;
[[nodiscard]] Totals totals(Findings const& findings);
[[nodiscard]] Totals totals(std::vector<Result> const& results);
[[nodiscard]] inline std::size_t count(Totals const& all, Verdict verdict) {
  return all[static_cast<std::size_t>(verdict)];
}

/// Whether it leaves the suite green.
[[nodiscard]] bool is_green(Verdict verdict);
[[nodiscard]] bool is_green(Totals const& all);

/// "pass", "fail", ...: as in documents.
[[nodiscard]] std::string_view word_of(Verdict verdict);
/// The other way. Throws InputError.
[[nodiscard]] Verdict verdict_named(std::string_view word);

/// "1.98 [1.9, 2.05]", "≥ 1.85": what was found with its uncertainty, and what was asked; empty where nothing is told.
[[nodiscard]] std::string interval_text(Interval const& uncertainty);
[[nodiscard]] std::string allowed_text(Interval const& allowed);
/// A number with its unit, which is left out where it is 1: "1.25e-05 m".
[[nodiscard]] std::string value_text(double value, std::string_view unit);
/// "4.1 s", "2:03", "1:02:03".
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace talus::verification
