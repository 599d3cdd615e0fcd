#pragma once
/// What one core can do at most.

#include "benchmarks/timing/estimate.hpp"

namespace talus::bench {

/// Products and sums in double [flop/s] of a loop of fused multiply-adds in packs of four: median over some repeats, on
/// the calling thread.
[[nodiscard]] Estimate peak_flops(int repeats);

}  // namespace talus::bench
