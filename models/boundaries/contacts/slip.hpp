#pragma once

#include <string_view>
#include <tuple>

#include "core/config/parameters.hpp"
#include "core/contact.hpp"

namespace talus::wall {

/// v_n = w_n, whether it comes or goes; v_t is free.
struct Slip {
  static constexpr std::string_view name = "slip", title = "Free slip along the wall, no separation from it";

  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };

  [[nodiscard]] static constexpr ContactRule rule(Parameters const&) { return {.separates = false}; }
};

}  // namespace talus::wall
