#pragma once

#include <string_view>
#include <tuple>

#include "core/config/parameters.hpp"
#include "models/transfers/blend.hpp"
#include "models/transfers/mode.hpp"

namespace talus::transfer {

/// Affine fluid-implicit particle: affine mode, velocities incremented.
///
/// alpha = 1 is pure AFLIP, 0 is APIC. Angular momentum is not kept exactly, unlike with APIC.
///
/// Source: Fei, Guo, Wu, Huang & Gao (2021), doi:10.1145/3450626.3459678 (abstract read).
struct Aflip : Affine, Increment {
  static constexpr std::string_view name = "aflip", title = "Affine fluid-implicit particle (AFLIP), blended with APIC",
                                    source = "Fei, Guo, Wu, Huang & Gao (2021), doi:10.1145/3450626.3459678";
  struct Parameters {
    double alpha = 0.95;
    static constexpr auto table() {
      return std::tuple{parameter(&Parameters::alpha, "alpha", "alpha", "1",
                                  "share of the increment: 1 is pure AFLIP, 0 is APIC", closed(0, 1))};
    }
  };
  explicit Aflip(Parameters const& p) : Increment{p.alpha} {}
};

}  // namespace talus::transfer
