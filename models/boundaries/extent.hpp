#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "core/config/parameters.hpp"
#include "core/coordinates.hpp"
#include "core/errors.hpp"
#include "core/tensor.hpp"

namespace talus::wall {

/// Two opposite corners of a box along the axes.
struct Extent {
  Coordinates min{0, 0, 0}, max{1, 1, 1};

  static constexpr auto table() {
    return std::tuple{
        parameter(&Extent::min, "min", "x_{min}", "m", "corner with the least coordinates").per_axis().required(),
        parameter(&Extent::max, "max", "x_{max}", "m", "corner with the greatest coordinates").per_axis().required()};
  }
  static std::optional<std::string> check(Extent const& extent) {
    if (extent.min.size() != extent.max.size()) return "min and max must have as many coordinates";
    for (std::size_t axis = 0; axis < extent.min.size(); ++axis)
      if (!(extent.min[axis] < extent.max[axis])) return "min must be less than max along every axis";
    return std::nullopt;
  }

  /// Both corners [m]. Throws InputError where min is not below max along each axis.
  template <int D>
  [[nodiscard]] std::pair<Point<D>, Point<D>> corners() const {
    std::pair<Point<D>, Point<D>> const pair{to_point<D>(min), to_point<D>(max)};
    if (!(pair.first.array() < pair.second.array()).all())
      throw InputError("min must be less than max along every axis");
    return pair;
  }
};

}  // namespace talus::wall
