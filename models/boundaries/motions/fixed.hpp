#pragma once

#include <string_view>
#include <tuple>

#include "core/config/parameters.hpp"
#include "core/tensor.hpp"

namespace talus::wall {

/// A wall that stays where it is.
struct Fixed {
  static constexpr std::string_view name = "fixed", title = "At rest";
  static constexpr bool supports(int D) { return D == 2 || D == 3; }

  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };

  template <int D>
  class In {
   public:
    explicit In(Parameters const&) {}
    [[nodiscard]] Point<D> offset(double /*t*/) const { return Point<D>::Zero(); }
    [[nodiscard]] Point<D> velocity(double /*t*/) const { return Point<D>::Zero(); }
  };
};

}  // namespace talus::wall
