#pragma once

#include <string_view>
#include <tuple>

#include "models/transfers/blend.hpp"
#include "models/transfers/mode.hpp"

namespace talus::transfer {

/// Particle in cell: constant mode, velocities replaced.
///
/// Every step smooths the velocity by the kernel twice, which damps a wave of number k by about (p + 1)/12 (k h)^2 a
/// step (p: degree): of order 1 in h at a fixed Courant number, and worse the smaller the step. For comparison.
///
/// Source: Harlow (1964); in the words of Zhu & Bridson (2005), doi:10.1145/1073204.1073298 (neither re-read).
struct Pic : Constant, Replace {
  static constexpr std::string_view name = "pic", title = "Particle in cell (PIC)",
                                    source = "Harlow (1964); Zhu & Bridson (2005), doi:10.1145/1073204.1073298";
  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };
  explicit Pic(Parameters const& /*p*/) {}
};

}  // namespace talus::transfer
