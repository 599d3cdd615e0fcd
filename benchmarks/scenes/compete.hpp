#pragma once
/// A simulation as something that is timed.

#include <limits>
#include <string>
#include <vector>

#include "benchmarks/timing/paired.hpp"
#include "core/parallel.hpp"
#include "core/simulation.hpp"

namespace talus::bench {

/// What sorting costs a simulation.
struct SortCost {
  double seconds = 0;        ///< of one sort
  double steps_between = 0;  ///< from one to the next, at the speed of the moment
  [[nodiscard]] double per_step() const { return seconds / steps_between; }
};

/// Takes a step. Returns whether it began with a sort.
template <int D>
bool advance(Simulation<D>& simulation) {
  long const before = simulation.sorts();
  simulation.advance(std::numeric_limits<double>::infinity());
  return simulation.sorts() != before;
}

/// Warms a simulation up by some steps and measures its sorts. One `begin` is timed in place of a sort: it sorts,
/// makes the grid anew, and reads every mass and velocity besides, so that this is an upper bound.
template <int D>
[[nodiscard]] SortCost measure_sort(Simulation<D>& simulation, Clock clock, int steps = 12) {
  std::vector<double> times;
  double drift = 0;
  int counted = 0;
  for (int round = 0; round < 3; ++round) {
    for (int k = 0; k < steps / 3; ++k) {
      double const before = simulation.drift();
      if (advance(simulation)) continue;
      drift += simulation.drift() - before;
      ++counted;
    }
    double const begin = seconds(clock);
    simulation.begin();
    times.push_back(seconds(clock) - begin);
  }
  return {quantile(times, 0.5), drift > 0 ? drift_limit * counted / drift : std::numeric_limits<double>::infinity()};
}

/// The simulation on so many threads; pays for its sorts. Warms it up.
template <int D>
[[nodiscard]] Competitor competitor(std::string name, Simulation<D>& simulation, Clock clock = Clock::thread,
                                    int threads = 1) {
  set_thread_count(threads);
  simulation.begin();  // makes room for the threads
  SortCost const sort = measure_sort(simulation, clock);
  return {std::move(name), [&simulation] { return advance(simulation); }, [threads] { set_thread_count(threads); },
          sort.per_step()};
}

}  // namespace talus::bench
