#pragma once
/// Several competitors that are timed in turns, so that what disturbs the machine disturbs them alike.

#include <functional>
#include <string>
#include <vector>

#include "benchmarks/timing/clock.hpp"
#include "benchmarks/timing/estimate.hpp"

namespace talus::bench {

/// Something that goes on in steps.
struct Competitor {
  std::string name;
  /// One step. Returns whether it also did a rare piece of work (a sort), which then does not count: it is measured
  /// apart and added as `extra`.
  std::function<bool()> step;
  /// Runs before each of its slices, untimed; may be empty.
  std::function<void()> prepare = {};
  double extra = 0;  ///< cost of the rare work, spread over all steps [s]
};

/// Seconds a step of one competitor, `extra` included, one number a round.
using Course = std::vector<double>;

/// How long a slice lasts at least [s], and how many rounds there are.
struct Rounds {
  int count = 15;
  double slice = 0.1;
  Clock clock = Clock::thread;
};

/// Every round times a slice of each competitor, in the order given and back again in turns; a slice is as many steps
/// as last long enough, at least one. Before the first round each competitor runs a slice untimed.
[[nodiscard]] std::vector<Course> take_turns(std::vector<Competitor> const& competitors, Rounds const& rounds);

/// a/b, round by round.
[[nodiscard]] Estimate ratio(Course const& a, Course const& b);

}  // namespace talus::bench
