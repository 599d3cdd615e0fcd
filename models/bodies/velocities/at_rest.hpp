#pragma once

#include <string_view>
#include <tuple>

#include "core/tensor.hpp"

namespace talus::body {

/// No motion: v = 0.
struct AtRest {
  static constexpr std::string_view name = "at_rest", title = "At rest", source = "elementary kinematics";
  static constexpr bool supports(int D) { return D == 2 || D == 3; }

  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };

  template <int D>
  struct In {
    static constexpr int dimension = D;
    explicit In(Parameters const& /*p*/) {}
    /// [m/s]
    [[nodiscard]] Point<D> velocity(Point<D> const& /*x*/) const { return Point<D>::Zero(); }
    /// dv_i/dx_j [1/s]
    [[nodiscard]] Matrix<double, D> gradient(Point<D> const& /*x*/) const { return {}; }
  };
};

}  // namespace talus::body
