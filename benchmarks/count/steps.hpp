#pragma once
/// Steps that valgrind counts, and steps that it does not.

#include <limits>

#include "core/simulation.hpp"

namespace talus::bench {

template <int D>
void take_steps(Simulation<D>& simulation, int steps) {
  for (int k = 0; k < steps; ++k) simulation.advance(std::numeric_limits<double>::infinity());
}

/// The function that callgrind knows by its name: what is called from here counts.
template <int D>
[[gnu::noinline]] void counted_steps(Simulation<D>& simulation, int steps) {
  take_steps(simulation, steps);
}

}  // namespace talus::bench
