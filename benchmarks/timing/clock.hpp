#pragma once
/// The two clocks of the benchmarks.

namespace talus::bench {

/// Thread: what the calling thread has computed, whoever else the machine serves; for work on one thread. Wall: time as
/// it passes, for work on several.
enum class Clock { thread, wall };

/// [s], from an arbitrary beginning.
[[nodiscard]] double seconds(Clock clock);

}  // namespace talus::bench
