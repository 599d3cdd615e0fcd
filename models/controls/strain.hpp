#pragma once

#include <string_view>
#include <tuple>

#include "core/material_point.hpp"

namespace talus::control {

/// The integral of the velocity gradient over the segment is prescribed: the same strain whatever the duration.
struct Strain {
  static constexpr std::string_view name = "strain", title = "Given change over the segment, at a constant rate";
  struct Parameters {
    double by = 0;
    static constexpr auto table() {
      return std::tuple{parameter(&Parameters::by, "by", "dt L", "1",
                                  "integral of the velocity gradient, positive in extension; 0: no motion")};
    }
  };
  [[nodiscard]] static Control control(Parameters const& p, double duration) { return {.rate = p.by / duration}; }
};

}  // namespace talus::control
