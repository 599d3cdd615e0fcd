#pragma once
/// How much memory the process holds.

#include <cstdint>

namespace talus::bench {

/// Hands freed memory back to the system, and forgets the highest mark so far. Returns what is held now [bytes].
std::int64_t forget_peak();

/// The most that was held since [bytes].
[[nodiscard]] std::int64_t peak_since();

}  // namespace talus::bench
