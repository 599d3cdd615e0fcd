#pragma once

#include <cmath>

#include "core/roots.hpp"
#include "models/laws/parts/ellipse.hpp"
#include "models/laws/parts/hardening.hpp"

namespace talus::law {

/// Where the return map ends, and how often its equation was asked.
template <Scalar T>
struct MappedStress {
  EllipsePoint<T> at;
  int iterations;
  bool converged;
};

/// Of p, in units of the strength.
inline constexpr double map_tolerance = 1e-12;

/// The point of the surface at p where the flow rule says q = q_tr x/sum. Near cap and tip S follows from p with half
/// its digits, and from the flow rule with all of them: that of the smaller dS/dp is taken. At the tip P follows from S.
template <Scalar T>
[[nodiscard]] EllipsePoint<T> point_by_flow(Ellipse const& surface, T p, T p_c, T q_tr, T x, T sum, double kappa) {
  EllipsePoint<T> at = surface.at(p, p_c);
  T const by_flow = min(T(T(1 / surface.M) * q_tr * x / sum), T(at.S + T(2 * std::sqrt(map_tolerance)) * p_c));
  at.S = select<T>(at.S * at.S * (sum + T(kappa) * x) < x * x * sum, by_flow, at.S);
  auto const tip = at.P < T(1e-6) * p_c;  // where P cancels
  if (any(tip)) [[unlikely]]
    at.P = select<T>(tip, at.S * at.S / (p_c - at.p), at.P);
  return at;
}

/// The rate-independent return map of modified Cam-Clay: associated flow onto an ellipse that hardens, in one unknown.
///
///   eps_V = eps_V,n + (p - p_tr)/K,   p_c = p_c(eps_V),   x = p - (1 - beta)/2 p_c,   a = (1 + beta)/2 p_c
///   (p_tr - p)/(2 K M^2 x) = (q_tr - q)/(2 G q)                 normality, both sides the plastic multiplier   (1)
///   q(p) = q_tr x / (x + kappa (p_tr - p)),   kappa = G/(K M^2)                            (1) solved for q    (2)
///   r(p) = sqrt(q(p)^2 + M^2 x^2) - M a = 0                                                                    (3)
///
/// Bracket: with side = sign(x_tr), r > 0 at p_tr, and r < 0 wherever side x <= 0, as at x_n = 0: if p_tr is above the
/// apex pressure the strength can only grow on the way to the surface, if below only shrink, so that the apex never
/// leaves the bracket. The search cannot fail, and what it returns lies on the surface whatever happened. Where the
/// strength falls faster than the stress, as with a hyperbolic sine at p_c << K, there may be several roots: it snaps.
///
/// Start: with p_c frozen both coordinates shrink as 1/(1 + multiplier), and the inverse radius is all but linear in
/// the multiplier: one Newton step for it. Everything is homogeneous in the stresses, so they need no scaling.
///
/// Cost: one strength, three divisions and one root an evaluation; by Halley's iteration about two evaluations where a
/// step is small, four where the trial stress is far out.
///
/// Source: flow rule and hardening as in Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643; start after Moré &
/// Sorensen (1983), doi:10.1137/0904038; (2), (3) derived here.
template <class Hardening>
struct CamClayMap {
  static constexpr bool associated = true;
  static constexpr double tolerance = map_tolerance;  ///< of p and p_c, to three decades of the strength

  Ellipse const& surface;
  Hardening const& hardening;
  double K, G;

  /// From the trial stress (p_tr, q_tr) above the surface of strength p_c_n = p_c(eps_V_n). Lanes that are
  /// not `plastic` are done at once, and their result means nothing.
  template <Scalar T, class Condition>
  [[nodiscard]] MappedStress<T> operator()(T p_tr, T q_tr, T eps_V_n, T p_c_n, Condition plastic) const {
    T const x_tr = p_tr - surface.centre(p_c_n);
    T const side = select<T>(x_tr < T(0.0), -1.0, 1.0);
    auto const eps_V = [&](T p) { return T(eps_V_n + T(1 / K) * (p - p_tr)); };
    auto const strength = [&](T p) { return hardening.strength(eps_V(p), K); };
    auto const outward = [&](T p, T p_c) { return max(T(0.0), T(side * (p - surface.centre(p_c)))); };

    double const M = surface.M, M2 = M * M, kappa = G / (K * M2);
    // r, r' and r'' times the radius; of r'' what p_c'' gives is left out
    auto const residual = [&](T p) -> WithCurvature<T> {
      T const p_c = strength(p), dp_c = T(1 / K) * hardening.slope(p_c, K);
      T const x = outward(p, p_c), dx = side * (T(1.0) - surface.centre(dp_c));
      T const drop = T(kappa) * side * (p_tr - p), inverse = T(1.0) / (x + drop);
      T const q = q_tr * x * inverse;  // (2)
      T const dq = q_tr * (dx * drop + T(kappa) * side * x) * inverse * inverse;
      T const square = q * q + T(M2) * x * x, half_slope = q * dq + T(M2) * x * dx, radius = sqrt(square);
      T const r = radius * (radius - T(M) * surface.half_width(p_c));  // (3)
      T const dr = half_slope - T(M) * radius * surface.half_width(dp_c);
      T const ddr = dq * dq + T(M2) * dx * dx - T(2.0) * q * dq * (dx - T(kappa) * side) * inverse;
      return {r, dr, ddr - half_slope * half_slope / square};
    };

    T const inner = select<T>(plastic, surface.centre(p_c_n), p_tr);
    auto root = bracketed_newton<T>(residual, inner, p_tr, start(x_tr, q_tr, p_c_n, inner, p_tr), T(tolerance) * p_c_n);
    T p_c = strength_of_state(hardening, eps_V(root.x), K);
    auto const coarse = plastic && (p_c < T(1e-3) * p_c_n || hardening.slope(p_c_n, K) < T(-K));
    if (any(coarse)) [[unlikely]] {
      root = refined<T>(residual, strength, coarse, inner, p_tr, root);
      p_c = strength_of_state(hardening, eps_V(root.x), K);
    }
    T const x = outward(root.x, p_c), sum = x + T(kappa) * side * (p_tr - root.x);
    return {point_by_flow(surface, root.x, p_c, q_tr, x, sum, kappa), root.iterations, root.converged};
  }

 private:
  /// The search goes on where the strength fell by decades, or follows the pressure steeply: in units of what is left,
  /// and of what p_c asks of p.
  template <Scalar T, class F, class S, class Condition>
  [[nodiscard, gnu::noinline]] Root<T> refined(F const& residual, S const& strength, Condition again, T inner, T p_tr,
                                               Root<T> root) const {
    while (any(again)) {
      T const p_c = strength(root.x), steepness = max(T(1.0), T(T(-1 / K) * hardening.slope(p_c, K)));
      T const below = select<T>(again, inner, root.x), above = select<T>(again, p_tr, root.x);
      int const evaluations = root.iterations;
      root = bracketed_newton<T>(residual, below, above, root.x, T(tolerance) * p_c / steepness);
      root.iterations += evaluations;
      again = again && strength(root.x) < T(1e-3) * p_c;
    }
    return root;
  }

  /// Pressure after one Newton step for 1/radius in u = 2 K M^2 dlambda, from u = 0, with frozen strength.
  template <Scalar T>
  [[nodiscard]] T start(T x_tr, T q_tr, T p_c_n, T inner, T p_tr) const {
    double const M2 = surface.M * surface.M, kappa = G / (K * M2);
    T const Mx2 = T(M2) * x_tr * x_tr, q2 = q_tr * q_tr;
    T const radius = sqrt(T(Mx2 + q2)), wanted = T(surface.M) * surface.half_width(p_c_n);
    // u = above/below
    T const above = max(T(0.0), T((radius - wanted) * (Mx2 + q2))), below = wanted * (Mx2 + T(kappa) * q2);
    return inner + (p_tr - inner) * (below / (below + above + T(1e-300)));  // both vanish in idle lanes
  }
};

}  // namespace talus::law
