#pragma once

#include <string_view>
#include <tuple>

#include "models/transfers/blend.hpp"
#include "models/transfers/mode.hpp"

namespace talus::transfer {

/// Affine particle in cell: affine mode, velocities replaced.
///
/// Keeps the noise filter of PIC and passes linear velocity fields, and with them angular momentum, without loss.
///
/// Source: Jiang, Schroeder, Selle, Teran & Stomakhin (2015), doi:10.1145/2766996 (abstract read).
struct Apic : Affine, Replace {
  static constexpr std::string_view name = "apic", title = "Affine particle in cell (APIC)",
                                    source = "Jiang, Schroeder, Selle, Teran & Stomakhin (2015), doi:10.1145/2766996";
  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };
  explicit Apic(Parameters const& /*p*/) {}
};

}  // namespace talus::transfer
