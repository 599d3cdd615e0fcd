#pragma once

#include <string_view>
#include <tuple>

#include "core/config/parameters.hpp"
#include "models/transfers/blend.hpp"
#include "models/transfers/mode.hpp"

namespace talus::transfer {

/// Fluid-implicit particle: constant mode, velocities incremented; the transfer of the classical material point method.
///
/// alpha = 1 is pure FLIP: nothing is smoothed, and velocities that no node sees stay with the particles as noise.
/// alpha < 1 blends PIC in; 0 is PIC.
///
/// Source: Brackbill & Ruppel (1986), doi:10.1016/0021-9991(86)90211-1; the blend with PIC: Zhu & Bridson (2005),
/// doi:10.1145/1073204.1073298 (neither re-read).
struct Flip : Constant, Increment {
  static constexpr std::string_view name = "flip", title = "Fluid-implicit particle (FLIP), blended with PIC",
                                    source =
                                        "Brackbill & Ruppel (1986), doi:10.1016/0021-9991(86)90211-1; "
                                        "Zhu & Bridson (2005), doi:10.1145/1073204.1073298";
  struct Parameters {
    double alpha = 1;
    static constexpr auto table() {
      return std::tuple{parameter(&Parameters::alpha, "alpha", "alpha", "1",
                                  "share of the increment: 1 is pure FLIP, 0 is PIC", closed(0, 1))};
    }
  };
  explicit Flip(Parameters const& p) : Increment{p.alpha} {}
};

}  // namespace talus::transfer
