#pragma once

#include <string_view>
#include <tuple>

#include "core/material_point.hpp"

namespace talus::control {

/// The stress goes to a value, linearly in time.
struct Stress {
  static constexpr std::string_view name = "stress", title = "Stress, led to a value linearly in time";
  struct Parameters {
    double to = 0;
    static constexpr auto table() {
      return std::tuple{
          parameter(&Parameters::to, "to", "tau", "Pa", "Kirchhoff stress at the end of the segment, tension positive")
              .required()};
    }
  };
  [[nodiscard]] static Control control(Parameters const& p, double /*duration*/) {
    return {.of_stress = true, .target = p.to};
  }
};

}  // namespace talus::control
