#pragma once
/// A ring that breathes with free rims.
///
///   r = R + U,   U = A sin(w t) (c_3 R^3 + c_2 R^2 + c_1 R)                                              (1)
///   c_1 = -6 a/(b d),  c_2 = 3 (a + b)/(b^2 d),  c_3 = -2/(b^2 d),  d = b - 3 a                          (2)
///   F_R = 1 + U',   F_T = 1 + U/R,   body force = U_tt - (P_R' + (P_R - P_T)/R)/rho_0 along R            (3)
///
/// a, b: inner and outer radius. U' vanishes at both, and U(b) = A sin(w t): the rims bear no traction where
/// lambda = 0.
///
/// Source: Wallstedt & Guilkey (2008), doi:10.1016/j.jcp.2008.07.019; (3) is derived here.

#include "core/tensor.hpp"
#include "verification/exact/elastic.hpp"

namespace talus::exact {

struct ExpandingRing {
  static constexpr int dimension = 2;
  double inner = 0, outer = 0;         ///< a, b [m]
  double amplitude = 0;                ///< A [m]
  double frequency = 0;                ///< w [1/s]
  Point<2> centre = Point<2>::Zero();  ///< [m]

  /// U/R without A sin(w t) at R.
  template <Scalar T>
  [[nodiscard]] T share(T const& R) const {
    double const d = outer * outer * (outer - 3 * inner);
    return T(-6 * inner * outer / d) + T(3 * (inner + outer) / d) * R + T(-2 / d) * R * R;
  }

  /// (1).
  template <Scalar T>
  [[nodiscard]] Vector<T, 2> position(Vector<T, 2> const& X, T const& t) const {
    using std::sin, std::sqrt;
    T const x = X[0] - T(centre[0]), y = X[1] - T(centre[1]);
    T const stretch = T(1.0) + T(amplitude) * sin(T(frequency * t)) * share(T(sqrt(T(x * x + y * y))));
    return {T(centre[0]) + stretch * x, T(centre[1]) + stretch * y};
  }

  /// (3) [m/s^2].
  [[nodiscard]] Point<2> body_force(Elastic const& solid, Point<2> const& X, double t) const {
    Point<2> const from = X - centre;
    double const R = from.norm(), d = outer * outer * (outer - 3 * inner), now = amplitude * std::sin(frequency * t);
    double const c1 = -6 * inner * outer / d, c2 = 3 * (inner + outer) / d, c3 = -2 / d;
    double const U = now * R * (c1 + R * (c2 + R * c3)), slope = now * (c1 + R * (2 * c2 + R * 3 * c3));
    double const radial = 1 + slope, around = 1 + U / R, ln_J = std::log(radial * around);
    double const radial_slope = now * (2 * c2 + 6 * c3 * R), around_slope = (slope - U / R) / R;
    double const slope_ln_J = radial_slope / radial + around_slope / around;
    double const P_slope = solid.principal_slope(ln_J, slope_ln_J, radial, radial_slope);
    double const jump = solid.principal_stress(ln_J, radial) - solid.principal_stress(ln_J, around);
    return (-frequency * frequency * U - (P_slope + jump / R) / solid.density) / R * from;
  }
};

}  // namespace talus::exact
