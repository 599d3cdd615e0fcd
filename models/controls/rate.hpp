#pragma once

#include <string_view>
#include <tuple>

#include "core/material_point.hpp"

namespace talus::control {

/// The component of the velocity gradient is held at a value.
struct Rate {
  static constexpr std::string_view name = "rate", title = "Velocity gradient at a constant value";
  struct Parameters {
    double value = 0;
    static constexpr auto table() {
      return std::tuple{
          parameter(&Parameters::value, "value", "L", "1/s", "velocity gradient, positive in extension").required()};
    }
  };
  [[nodiscard]] static Control control(Parameters const& p, double /*duration*/) { return {.rate = p.value}; }
};

}  // namespace talus::control
