#pragma once

#include "core/scalar.hpp"

namespace talus::law {

/// Least slope of an ellipse; a material with less friction is a fluid that keeps this much. The way from a trial
/// stress to a flatter ellipse is a boundary layer, in which a search by steps of p would stop too early.
inline constexpr double least_slope = 1e-4;

/// A stress on or above the yield ellipse: its pressure and strength, and the two measures that the flow law asks for.
///
///   P = p + beta p_c,   S = sqrt((p_c - p) P),   q_y = M S     [Pa]
template <Scalar T>
struct EllipsePoint {
  T p, p_c, P, S;
};

/// Yield surface of modified Cam-Clay with cohesion.
///
///   y(p, q) = q^2 - M^2 (p_c - p) (p + beta p_c)                                   (1)
///           = q^2 + M^2 x^2 - M^2 a^2,   x = p - (1 - beta)/2 p_c,   a = (1 + beta)/2 p_c
///
/// M: slope of the critical-state line without cohesion; beta in [0, 1): tensile over compressive strength p_c [Pa].
/// Apex (critical state) at x = 0, cap at x = a, tip at x = -a.
/// Source: Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643; Roscoe & Burland (1968) for beta = 0.
struct Ellipse {
  double M, beta;

  template <Scalar T>
  [[nodiscard]] T centre(T p_c) const {
    return T(0.5 * (1 - beta)) * p_c;
  }
  template <Scalar T>
  [[nodiscard]] T half_width(T p_c) const {
    return T(0.5 * (1 + beta)) * p_c;
  }
  /// y of (1) [Pa^2].
  template <Scalar T>
  [[nodiscard]] T excess(T p, T q, T p_c) const {
    return q * q - T(M * M) * (p_c - p) * (p + T(beta) * p_c);
  }
  /// y divided by the sum of its two radii: about the distance from the surface [Pa].
  template <Scalar T>
  [[nodiscard]] T distance(T p, T q, T p_c) const {
    T const x = p - centre(p_c);
    return excess(p, q, p_c) / (sqrt(T(q * q + T(M * M) * x * x)) + T(M) * half_width(p_c));
  }
  /// The point of the surface at pressure p; p itself is kept between tip and cap.
  template <Scalar T>
  [[nodiscard]] EllipsePoint<T> at(T p, T p_c) const {
    T const inside = max(T(T(-beta) * p_c), min(p, p_c));
    T const P = max(T(0.0), T(inside + T(beta) * p_c));
    return {inside, p_c, P, sqrt(T((p_c - inside) * P))};
  }
};

}  // namespace talus::law
