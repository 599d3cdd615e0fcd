#pragma once
/// A case of the suite, as facts; the registry of all cases.

#include <span>
#include <string_view>

#include "verification/suite/findings.hpp"

namespace talus::verification {

/// A case lies in verification/cases/<id>.cpp, where it is `the_case` of a namespace of its own; the build lists them.
///
/// tier 0: seconds, at every change; 1: minutes, before a change lands; 2: the report.
/// budget [s]: wall time on one core after which the case is stopped and counts as an error.
/// `run` throws where something is wrong that is no finding; that, too, is an error and no FAIL.
struct Case {
  std::string_view id;      ///< "manufactured/bar"
  std::string_view title;   ///< one line
  std::string_view truth;   ///< what the solver is compared with
  std::string_view source;  ///< author, year, doi of the problem or its solution
  int tier;
  double budget;
  void (*run)(Findings&);
};

/// All cases, in the order of the report.
[[nodiscard]] std::span<Case const* const> cases();

}  // namespace talus::verification
