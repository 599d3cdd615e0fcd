#pragma once
/// Speed between the places where it is known.

#include <algorithm>
#include <cmath>
#include <vector>

namespace talus::reference::flow {

/// u [m/s] at a height y [m] from values at rising heights, the last of which is the surface: the cubic through the
/// four nearest places in s = (1 - y/h)^(1/2), in which the speed of a layer is smooth. Exact for Bagnold's profile.
/// Pre: at least four places.
[[nodiscard]] inline double interpolated(std::vector<double> const& heights, std::vector<double> const& u, double y) {
  double const h = heights.back();
  auto const coordinate = [h](double at) { return std::sqrt(std::max(1 - at / h, 0.0)); };
  auto const above = std::upper_bound(heights.begin(), heights.end(), y) - heights.begin();
  auto const last = static_cast<std::ptrdiff_t>(heights.size()) - 4;
  auto const first = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 2, 0, last));
  double sum = 0;
  for (std::size_t i = first; i < first + 4; ++i) {
    double weight = 1;
    for (std::size_t j = first; j < first + 4; ++j)
      if (j != i)
        weight *= (coordinate(y) - coordinate(heights[j])) / (coordinate(heights[i]) - coordinate(heights[j]));
    sum += weight * u[i];
  }
  return sum;
}

}  // namespace talus::reference::flow
