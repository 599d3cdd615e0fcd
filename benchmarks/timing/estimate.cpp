#include "benchmarks/timing/estimate.hpp"

#include <algorithm>
#include <cmath>

namespace talus::bench {

double quantile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  double const place = q * static_cast<double>(values.size() - 1);
  auto const below = static_cast<std::size_t>(place), above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], place - static_cast<double>(below));
}

Estimate estimate(std::vector<double> const& values) {
  if (values.empty()) return {};
  double const median = quantile(values, 0.5);
  double const half_range = 0.5 * (quantile(values, 0.75) - quantile(values, 0.25));
  return {median, median != 0 ? 100 * half_range / std::abs(median) : 0, static_cast<int>(values.size())};
}

}  // namespace talus::bench
