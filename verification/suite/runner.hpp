#pragma once
/// Runs cases, each in a process of its own: none can take the others with it.

#include <functional>
#include <span>
#include <vector>

#include "verification/suite/case.hpp"
#include "verification/suite/result.hpp"

namespace talus::verification {

/// A case may compute for that many times its budget before it is stopped: machines differ.
inline constexpr double patience = 4;
/// And may take that many times as long by the clock: machines have other work.
inline constexpr double patience_with_waiting = 5;

struct RunOptions {
  int jobs = 1;  ///< cases at the same time; with more than one, each case has one thread
  double patience = verification::patience;
  /// Called with each result as it comes, whatever the order, and how many cases are still to come.
  std::function<void(Result const&, std::size_t left)> finished = {};
  /// Asked between all that happens: whether to stop, keeping the results that there are.
  std::function<bool()> interrupted = {};
};

/// The results, in the order of the cases. A case that throws, crashes, is stopped or finds nothing at all has one row
/// more, "ends", with the verdict error and the reason; what it found before it threw is kept. So has a case that an
/// interruption stopped or kept from beginning. What cases print goes to standard error.
/// Throws FileError where no process can be made.
[[nodiscard]] std::vector<Result> run_cases(std::span<Case const* const> cases, RunOptions const& options);

}  // namespace talus::verification
