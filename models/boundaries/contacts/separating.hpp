#pragma once

#include <string_view>
#include <tuple>

#include "core/config/parameters.hpp"
#include "core/contact.hpp"

namespace talus::wall {

/// v_n >= w_n; v_t is free. The wall pushes and never pulls.
struct Separating {
  static constexpr std::string_view name = "separating", title = "Free slip along the wall, free separation from it";

  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };

  [[nodiscard]] static constexpr ContactRule rule(Parameters const&) { return {}; }
};

}  // namespace talus::wall
