#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "core/scalar.hpp"

namespace talus::kernel {

/// Quadratic B-spline.
///
///   N(u) = 3/4 - u^2,            |u| < 1/2          (1)
///   N(u) = (3/2 - |u|)^2 / 2,    1/2 <= |u| < 3/2   (2)
///
/// Once continuously differentiable; second moment D_p = h^2/4 wherever the particle is. The differences below are
/// exact in floating point for f in [1/2, 3/2], so every weight keeps its full relative accuracy down to the edge.
///
/// Source: Steffen, Kirby & Berzins (2008), doi:10.1002/nme.2360 (abstract read; (1), (2) are the cardinal B-spline).
struct Quadratic {
  static constexpr std::string_view name = "quadratic", title = "Quadratic B-spline",
                                    source = "Steffen, Kirby & Berzins (2008), doi:10.1002/nme.2360";
  static constexpr int degree = 2, width = 3;
  static constexpr double inertia = 0.25;
  static constexpr double sharpness = 6, mass_floor = 0;  ///< at the cell's middle, where a third node comes in: 3 x 2
  static constexpr double base_shift = 0.5;               ///< base = floor(xi - 1/2), f in [1/2, 3/2]

  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };

  /// N of the nodes base, base + 1, base + 2 for f = xi - base.
  template <Scalar T>
  static void weights(T f, std::array<T, width>& w) {
    T const left = T(1.5) - f, middle = f - T(1.0), right = f - T(0.5);
    w[0] = T(0.5) * left * left;       // (2)
    w[1] = T(0.75) - middle * middle;  // (1)
    w[2] = T(0.5) * right * right;     // (2)
  }
  /// dN/dxi of the same nodes.
  template <Scalar T>
  static void slopes(T f, std::array<T, width>& g) {
    g[0] = f - T(1.5);
    g[1] = T(-2.0) * (f - T(1.0));
    g[2] = f - T(0.5);
  }
};

}  // namespace talus::kernel
