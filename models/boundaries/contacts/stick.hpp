#pragma once

#include <string_view>
#include <tuple>

#include "core/config/parameters.hpp"
#include "core/contact.hpp"

namespace talus::wall {

/// v = w, whether it comes or goes.
struct Stick {
  static constexpr std::string_view name = "stick", title = "No slip: what touches moves with the wall";

  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };

  [[nodiscard]] static constexpr ContactRule rule(Parameters const&) { return {.sticks = true}; }
};

}  // namespace talus::wall
