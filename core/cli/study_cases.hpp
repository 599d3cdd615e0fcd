#pragma once
/// The cases of a study, and what is wrong with them.

#include <string>
#include <vector>

#include "core/cli/program.hpp"

namespace talus::cli {

/// One combination of the axes' values.
struct StudyCase {
  std::vector<nlohmann::json> values;
  std::string label;  ///< "slope_deg=22 beta=0.1"
  Document document;
};

/// Combinations that a study may have: to judge them takes about ten seconds.
inline constexpr std::size_t most_cases = 10'000;

/// Every combination, the last axis fastest. Throws InputError where an axis leads nowhere in the base case, or where
/// there are too many.
[[nodiscard]] std::vector<StudyCase> cases_of(StudyPlan const& plan);

/// The expectations that a study has of a case.
[[nodiscard]] std::vector<ExpectedValue> expected_at(StudyPlan const& plan, StudyCase const& study_case);

/// What is wrong with the cases, and expectations that belong to none of them; one line each.
[[nodiscard]] std::vector<std::string> study_mistakes(StudyPlan const& plan, std::vector<StudyCase> const& cases);

}  // namespace talus::cli
