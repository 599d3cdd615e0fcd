#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "core/scalar.hpp"

namespace talus::kernel {

/// Linear B-spline (hat function): the classical material point method, kept for comparison.
///
///   N(u) = 1 - |u|,  |u| < 1                        (1)
///
/// The slope jumps at the nodes, so a particle that crosses a cell face makes the internal force jump. The second
/// moment f (1 - f) h^2 vanishes at the nodes: there is no affine transfer with this kernel (inertia 0).
///
/// A particle close to a face gives the node beyond it almost no mass but the full force. Internal forces therefore act
/// on no less than mass_floor, at the price of momentum where a node holds less than that (at a free surface).
///
/// Source: Sulsky, Chen & Schreyer (1994), doi:10.1016/0045-7825(94)90112-0 (not re-read; (1) is elementary).
struct Linear {
  static constexpr std::string_view name = "linear", title = "Linear B-spline (classical MPM)",
                                    source = "Sulsky, Chen & Schreyer (1994), doi:10.1016/0045-7825(94)90112-0";
  static constexpr int degree = 1, width = 2;
  static constexpr double inertia = 0;
  static constexpr double mass_floor = 0.1;
  static constexpr double sharpness = 1 / mass_floor + 1 / (1 - mass_floor);  ///< at f = mass_floor; 1/f has no bound
  static constexpr double base_shift = 0;                                     ///< base = floor(xi), f in [0, 1]

  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };

  /// N of the nodes base, base + 1 for f = xi - base.
  template <Scalar T>
  static void weights(T f, std::array<T, width>& w) {
    w[0] = T(1.0) - f;  // (1)
    w[1] = f;
  }
  /// dN/dxi of the same nodes; inside the cell f belongs to, also at its faces.
  template <Scalar T>
  static void slopes(T /*f*/, std::array<T, width>& g) {
    g[0] = T(-1.0);
    g[1] = T(1.0);
  }
};

}  // namespace talus::kernel
