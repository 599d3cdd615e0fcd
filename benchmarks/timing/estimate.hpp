#pragma once
/// A number out of repeated measurements, and how far they differ.

#include <vector>

namespace talus::bench {

/// Median, half of the interquartile range in percent of it, and how many measurements there were. A number that was
/// counted has one repeat and no spread.
struct Estimate {
  double median = 0, spread = 0;
  int repeats = 0;
};

/// Quantile of some values, linear between them; q in [0, 1]. Pre: there are values.
[[nodiscard]] double quantile(std::vector<double> values, double q);

[[nodiscard]] Estimate estimate(std::vector<double> const& values);

/// A number that no measurement blurs.
[[nodiscard]] inline Estimate exactly(double value) {
  return {value, 0, 1};
}

/// The estimate in another unit.
[[nodiscard]] inline Estimate scaled(Estimate estimate, double factor) {
  estimate.median *= factor;
  return estimate;
}

}  // namespace talus::bench
