#pragma once
/// From the coordinates of a document to a point of the space in which a scene lives.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/config/parameters.hpp"
#include "core/errors.hpp"
#include "core/tensor.hpp"

namespace talus {

/// The first D coordinates; what is missing is 0. Throws InputError where one is not finite.
template <int D>
[[nodiscard]] Point<D> to_point(Coordinates const& coordinates) {
  Point<D> x = Point<D>::Zero();
  auto const given = std::min(coordinates.size(), static_cast<std::size_t>(D));
  for (std::size_t axis = 0; axis < given; ++axis) {
    if (!std::isfinite(coordinates[axis])) throw InputError("a coordinate is not a finite number");
    x[static_cast<int>(axis)] = coordinates[axis];
  }
  return x;
}

}  // namespace talus
