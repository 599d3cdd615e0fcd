#pragma once

#include <string_view>
#include <tuple>

#include "core/config/parameters.hpp"
#include "core/contact.hpp"

namespace talus::wall {

/// A plane of symmetry: v_n - w_n is odd across the wall and v_t even (core/mirror.hpp).
///
/// For a half-space across an axis, on a row of nodes, that moves along itself or not at all.
struct MirroredSlip {
  static constexpr std::string_view name = "mirrored_slip",
                                    title =
                                        "Free slip at the wall itself, no separation: the wall is a plane of symmetry";

  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };

  [[nodiscard]] static constexpr ContactRule rule(Parameters const&) { return {.separates = false, .mirrors = true}; }
};

}  // namespace talus::wall
