#pragma once

#include <string_view>
#include <tuple>

#include "core/config/parameters.hpp"
#include "core/contact.hpp"

namespace talus::wall {

/// v = w on all of the wall, not only at nodes: v(x') - w = -(v(x) - w) for the image x' of x (core/mirror.hpp).
///
/// For a half-space across an axis, on a row of nodes, that moves along itself or not at all.
struct MirroredStick {
  static constexpr std::string_view name = "mirrored_stick",
                                    title = "No slip at the wall itself: the grid's velocity is odd across it";

  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };

  [[nodiscard]] static constexpr ContactRule rule(Parameters const&) { return {.sticks = true, .mirrors = true}; }
};

}  // namespace talus::wall
