#pragma once

#include <string_view>
#include <tuple>

#include "core/config/parameters.hpp"
#include "core/contact.hpp"

namespace talus::wall {

/// As `Coulomb`, with the coefficient that the material has where it touches: for a mu(I) law its current mu.
struct MaterialFriction {
  static constexpr std::string_view name = "material_friction",
                                    title = "Coulomb friction as in the material that touches";

  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };

  [[nodiscard]] static constexpr ContactRule rule(Parameters const&) { return {.material_friction = true}; }
};

}  // namespace talus::wall
