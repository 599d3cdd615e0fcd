#pragma once
/// Findings and results as JSON, there and back. Numbers keep every bit; one that is not finite becomes null with a
/// status beside it (core/io/text.hpp), within a plot's points null alone.

#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "verification/suite/result.hpp"

namespace talus::verification {

inline constexpr std::string_view results_schema = "talus/verification/1";

/// {"rows": [...], "plots": [...], "work": [...]}
[[nodiscard]] nlohmann::json document_of(Findings const& findings);
/// Throws InputError where it is no such document.
[[nodiscard]] Findings findings_of(nlohmann::json const& document);

/// The results.json of a run: `seconds` and `jobs` of all of it.
[[nodiscard]] nlohmann::json document_of(std::vector<Result> const& results, nlohmann::json const& provenance,
                                         double seconds, int jobs);
/// The results in it. Throws InputError where it is no such document.
[[nodiscard]] std::vector<Result> results_of(nlohmann::json const& document);

}  // namespace talus::verification
