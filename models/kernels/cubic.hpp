#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "core/scalar.hpp"

namespace talus::kernel {

/// Cubic B-spline.
///
///   N(u) = 2/3 - u^2 (2 - |u|) / 2,   |u| < 1       (1)
///   N(u) = (2 - |u|)^3 / 6,           1 <= |u| < 2  (2)
///
/// Twice continuously differentiable; second moment D_p = h^2/3 wherever the particle is.
///
/// Source: Steffen, Kirby & Berzins (2008), doi:10.1002/nme.2360 (abstract read; (1), (2) are the cardinal B-spline).
struct Cubic {
  static constexpr std::string_view name = "cubic", title = "Cubic B-spline",
                                    source = "Steffen, Kirby & Berzins (2008), doi:10.1002/nme.2360";
  static constexpr int degree = 3, width = 4;
  static constexpr double inertia = 1.0 / 3.0;
  static constexpr double sharpness = 3.137, mass_floor = 0;  ///< 3.13682 at f = 1.2755 and 1.7245, rounded up
  static constexpr double base_shift = 1;                     ///< base = floor(xi) - 1, f in [1, 2]

  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };

  /// N of the nodes base, ..., base + 3 for f = xi - base.
  template <Scalar T>
  static void weights(T f, std::array<T, width>& w) {
    T const right = f - T(1.0), left = T(2.0) - f;  // distances to the nodes base + 1 and base + 2, both in [0, 1]
    T const right2 = right * right, left2 = left * left;
    w[0] = T(1.0 / 6.0) * left2 * left;                        // (2)
    w[1] = T(2.0 / 3.0) - right2 * (T(1.0) - T(0.5) * right);  // (1)
    w[3] = T(1.0 / 6.0) * right2 * right;                      // (2)
    w[2] = T(1.0) - (w[0] + w[1] + w[3]);                      // (1): no rounding of 1/6 may be left that sums up
  }
  /// dN/dxi of the same nodes.
  template <Scalar T>
  static void slopes(T f, std::array<T, width>& g) {
    T const right = f - T(1.0), left = T(2.0) - f;
    g[0] = T(-0.5) * left * left;
    g[1] = right * (T(1.5) * right - T(2.0));
    g[2] = left * (T(2.0) - T(1.5) * left);
    g[3] = T(0.5) * right * right;
  }
};

}  // namespace talus::kernel
