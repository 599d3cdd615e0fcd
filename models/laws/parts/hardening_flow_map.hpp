#pragma once

#include <cmath>

#include "models/laws/parts/cam_clay_map.hpp"

namespace talus::law {

/// The return map of modified Cam-Clay with the flow rule of published computations, which differentiates the yield
/// function along the hardening as well. For exponential hardening.
///
///   D(p) = dy/dp + (dy/dp_c)(dp_c/dp)
///        = M^2 [2 p - (1 - beta) p_c + ((1 - beta) p - 2 beta p_c) s],   s = xi p_c / K           (1)
///   X = D/(2 M^2),   q(p) = q_tr X / (X + kappa (p_tr - p)),   kappa = G/(K M^2)                  (2)
///   r(p) = sqrt(q(p)^2 + M^2 x^2) - M a = 0,   x, a as in the associated map                      (3)
///
/// Not associated: volume stays where X = 0, that is at p_c = (2 + s) p and q/p = M sqrt(1 + s) for beta = 0, so that
/// friction grows with pressure (by 5 % at 1 kPa, E = 1 MPa, xi = 50). For comparison with runs that were made with it.
/// The term in beta has the sign of those runs; the derivative of y has the other one.
/// Source: what the reference solver of Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, computes in its version
/// of 2023, inferred from stresses that it returned (tests/models/laws_hardening_flow.cpp); (2), (3) derived here.
template <class Hardening>
struct HardeningFlowMap {
  static constexpr bool associated = false;
  Ellipse const& surface;
  Hardening const& hardening;
  double K, G;

  /// As CamClayMap: from a trial stress above the surface of strength p_c_n; lanes that are not `plastic` mean nothing.
  template <Scalar T, class Condition>
  [[nodiscard]] MappedStress<T> operator()(T p_tr, T q_tr, T eps_V_n, T p_c_n, Condition plastic) const {
    double const M = surface.M, M2 = M * M, kappa = G / (K * M2), beta = surface.beta;
    auto const eps_V = [&](T p) { return T(eps_V_n + T(1 / K) * (p - p_tr)); };
    auto const strength = [&](T p) { return hardening.strength(eps_V(p), K); };
    auto const flow = [&](T p, T p_c) {  // X of (2)
      T const s = T(-1 / K) * hardening.slope(p_c, K);
      return T(p - surface.centre(p_c) + T(0.5) * s * (T(1 - beta) * p - T(2 * beta) * p_c));
    };
    T const X_tr = flow(p_tr, p_c_n), side = select<T>(X_tr < T(0.0), -1.0, 1.0);
    auto const moves = abs(X_tr) > T(1e-15) * (abs(p_tr) + p_c_n);  // else the volume stays: p = p_tr
    auto const residual = [&](T p) -> WithDerivative<T> {
      T const p_c = strength(p), dp_c = T(1 / K) * hardening.slope(p_c, K), s = -dp_c;
      T const X = max(T(0.0), T(side * flow(p, p_c))), x = p - surface.centre(p_c);
      T const dX =
          side *
          (T(1.0) - surface.centre(dp_c) +
           T(0.5) * s * (T(1 - beta) - T(2 * beta) * dp_c + (T(1 - beta) * p - T(2 * beta) * p_c) * (dp_c / p_c)));
      T const drop = T(kappa) * side * (p_tr - p), inverse = T(1.0) / (X + drop);
      T const q = q_tr * X * inverse, dq = q_tr * (dX * drop + T(kappa) * side * X) * inverse * inverse;
      T const radius = select<T>(X > T(0.0), sqrt(T(q * q + T(M2) * x * x)), 0.0);
      T const dx = T(1.0) - surface.centre(dp_c);
      T const slope = (q * dq + T(M2) * x * dx) / max(radius, T(1e-300)) - T(M) * surface.half_width(dp_c);
      // (3); where X <= 0 there is no slope, and the search halves its bracket
      return {radius - T(M) * surface.half_width(p_c), select<T>(X > T(0.0), slope, 0.0)};
    };
    // X < 0 at p = 0, X > 0 at the other end whatever the strength: the root lies between p_tr and one of them.
    T const far = T(std::max(1.0, 2 * beta / (1 - beta))) * p_c_n;
    T const inner = select<T>(plastic && moves, select<T>(side > T(0.0), 0.0, far), p_tr);
    T const apex = surface.centre(p_c_n);
    T const start = select<T>(plastic && moves, apex + T(0.5) * (p_tr - apex), p_tr);
    auto const root = bracketed_newton<T>(residual, inner, p_tr, start, T(map_tolerance) * p_c_n);

    T const p_c = strength_of_state(hardening, eps_V(root.x), K);
    T const X = max(T(0.0), T(side * flow(root.x, p_c))), sum = X + T(kappa) * side * (p_tr - root.x);
    return {point_by_flow(surface, root.x, p_c, q_tr, X, sum, kappa), root.iterations, root.converged};
  }
};

}  // namespace talus::law
