#pragma once
/// When a run writes.

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace talus::cli {

/// Output times 0, every, 2 every, ...: something is due at the first step at or after each.
struct Schedule {
  double every;
  std::int64_t done = 0;  ///< outputs so far
  [[nodiscard]] bool due(double time) const { return time >= static_cast<double>(done) * every * (1 - 1e-14); }
  void mark(double time) {
    double const passed = std::floor(time / every * (1 + 1e-14));
    done = static_cast<std::int64_t>(std::min(passed, 9e18)) + 1;  // more do not fit
  }
};

}  // namespace talus::cli
