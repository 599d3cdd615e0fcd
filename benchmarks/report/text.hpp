#pragma once
/// Results for people, on a terminal.

#include <string>

#include "benchmarks/report/result.hpp"

namespace talus::bench {

/// Every table of a benchmark, in columns of text.
[[nodiscard]] std::string text_of(Measured const&);

/// What a row should reach, as ">= 10, stretch 14"; empty without a bar.
[[nodiscard]] std::string bar_text(Row const&);

/// "pass", "stretch" or "FAIL"; empty without a bar.
[[nodiscard]] std::string verdict_text(Row const&);

/// Whether every row that has a bar meets it.
[[nodiscard]] bool all_met(Result const&);

}  // namespace talus::bench
