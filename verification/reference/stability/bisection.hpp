#pragma once
/// Where a condition on a positive number ceases to hold.

#include <cmath>

namespace talus::reference {

/// The largest number for which `holds`, to a relative accuracy. Pre: it holds below one number between `low` and `high`
/// and not above it. With nothing in between that holds: low.
template <class Condition>
[[nodiscard]] double largest_where_true(Condition const& holds, double low = 1e-4, double high = 1e2,
                                        double accuracy = 1e-7) {
  while (high > low * (1 + accuracy)) {
    double const middle = std::sqrt(low * high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace talus::reference
