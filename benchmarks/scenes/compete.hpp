#pragma once
/// A simulation as something that is timed.

#include <algorithm>
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

/// Warms a simulation up by some steps and measures its sorts: what a `begin` and the step after it take more than a usual
/// step. `begin` sorts and reads every mass and velocity besides, and the step before it scattered in vain for that after
/// it, so that this is an upper bound.
template <int D>
[[nodiscard]] SortCost measure_sort(Simulation<D>& simulation, Clock clock, int steps = 12) {
  auto const timed = [&](auto const& work) {
    double const begin = seconds(clock);
    work();
    return seconds(clock) - begin;
  };
  std::vector<double> usual, sorted;
  double drift = 0;
  for (int round = 0; round < 3; ++round) {
    for (int k = 0; k < steps / 3; ++k) {
      double const before = simulation.drift();
      bool sorts = false;
      double const time = timed([&] { sorts = advance(simulation); });
      if (sorts) continue;
      usual.push_back(time);
      drift += simulation.drift() - before;
    }
    sorted.push_back(timed([&] {
      simulation.begin();
      advance(simulation);
    }));
  }
  double const cost = std::max(0.0, quantile(sorted, 0.5) - (usual.empty() ? 0 : quantile(usual, 0.5)));
  return {cost, drift > 0 ? drift_limit * static_cast<double>(usual.size()) / drift
                          : std::numeric_limits<double>::infinity()};
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
