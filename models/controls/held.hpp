#pragma once

#include <string_view>
#include <tuple>

#include "core/material_point.hpp"

namespace talus::control {

/// The stress stays what it is at the start of the segment.
struct Held {
  static constexpr std::string_view name = "held", title = "Stress held at its value";
  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };
  [[nodiscard]] static Control control(Parameters const& /*p*/, double /*duration*/) { return {.of_stress = true}; }
};

}  // namespace talus::control
