#pragma once

#include <cmath>

#include "core/dual.hpp"
#include "core/roots.hpp"
#include "models/laws/parts/ellipse.hpp"

namespace talus::law {

/// The two moduli that a return map knows [Pa].
struct Modulus {
  double K, G;
};

/// The stress before plastic flow, with the plastic volumetric strain and the strength before the step.
template <Scalar T>
struct CamClayTrial {
  T p, q, eps_V, p_c;
};

/// The stress after it.
template <Scalar T>
struct FlowedStress {
  T p, q;
};

/// Viscous Cam-Clay in one coupled solve: flow normal to the dynamic ellipse, the one of slope mu = q/S through the
/// stress.
///
///   q = mu S,   mu = mu(gamma, P),   gamma = (q_tr - q)/(G dt)                       flow law of Rate         (1)
///   p_tr - p = K dlambda mu^2 D,   q_tr - q = 2 G dlambda q,   D = 2 p - (1 - beta) p_c = 2 x                 (2)
///   p_c = p_c(eps_V,n + (p - p_tr)/K)                                                hardening                (3)
///
/// so that de_V^P/dt = gamma mu ((1 - beta) p_c - 2 p)/(2 S): volume and shear follow the same rate, and transients
/// converge with dt. One unknown, p: (1) with S and P of p gives mu(p), (2) solved for q gives q_n, and q_n = mu S is
///
///   q_n(p) = q_tr x/(x + kappa (p_tr - p)),   kappa = G/(K mu^2)                                              (4)
///   r(p) = sqrt((q_n/mu)^2 + x^2) - a = 0,   a = (1 + beta)/2 p_c                                             (5)
///
/// With mu = M this is CamClayMap, whose bracket holds here too: r < 0 at the apex, and r > 0 at p_tr, where q_n = q_tr
/// lies above mu S. (5) stays regular at cap and tip, where S vanishes and mu does not. dt -> infinity gives mu = M,
/// the rate-independent map; dt -> 0 leaves the trial stress where the flow law can carry it. The plastic work is
/// dlambda ((1 - beta) p p_c + 2 beta p_c^2) mu^2 >= 0, since p >= -beta p_c.
///
/// Near cap and tip S follows from p with half its digits only; there it is solved for at the p found:
///
///   mu(S) S = q_n(mu(S))                                                                                      (6)
///
/// Where the strength falls faster than the stress there may be several roots, as in CamClayMap.
/// Cost: derivatives by a dual number; a plastic step takes about four times that of the two stages (265 against 63 ns
/// a particle in the plane).
/// Source: derived here; M replaced by mu(I) in the flow rule of Blatny, Gray & Gaume (2024),
/// doi:10.1017/jfm.2024.643.
template <class Hardening, class Rate>
struct ConsistentMap {
  static constexpr double tolerance = 1e-12;  ///< of p, in units of the strength before the step; met by far

  Ellipse const& surface;
  Hardening const& hardening;
  Rate const& rate;
  Modulus m;

  /// What (1), (3) and (4) say of a pressure.
  template <Scalar T>
  struct At {
    EllipsePoint<T> point;
    T x, mu, q_n;
  };

  template <Scalar T, class Condition>
  [[nodiscard]] FlowedStress<T> operator()(CamClayTrial<T> const& tr, T dt, Condition plastic) const {
    T const side = select<T>(tr.p < surface.centre(tr.p_c), -1.0, 1.0);
    auto const residual = [&](T p) -> WithDerivative<T> {
      using D = Dual<1, T>;
      auto const at = evaluate(dual(tr), D::variable(p, 0), D(side), D(dt));
      D const w = at.q_n / at.mu, r = sqrt(D(w * w + at.x * at.x)) - surface.half_width(at.point.p_c);  // (5)
      // a slope that is no number makes the search halve its bracket
      return {r.value, select<T>(is_finite(r.derivative(0)), r.derivative(0), 0.0)};
    };
    T const inner = select<T>(plastic, surface.centre(tr.p_c), tr.p);
    T const start = inner + T(0.5) * (tr.p - inner);
    T const p = bracketed_newton<T>(residual, inner, tr.p, start, T(1e-3 * tolerance) * tr.p_c).x;

    // the smaller dS/dp: of p, or of (6)
    auto const at = evaluate(tr, p, side, dt);
    T const S = at.point.S, kappa = T(m.G / m.K) / (at.mu * at.mu), sum = at.x + kappa * side * (tr.p - p);
    auto const by_rule = S * S * (sum + kappa * at.x) < at.x * at.x * sum;
    EllipsePoint<T> point = at.point;
    point.S = select<T>(by_rule, from_flow_rule(tr, at, T(side * (tr.p - p)), dt, plastic && by_rule), S);
    point.P = select<T>(by_rule, with_shear(at.point, point.S).P, point.P);
    return {point.p, min(tr.q, T(rate.friction_of_step(tr.q, point, m.G, dt) * point.S))};
  }

 private:
  template <Scalar T>
  [[nodiscard]] static CamClayTrial<Dual<1, T>> dual(CamClayTrial<T> const& tr) {
    return {tr.p, tr.q, tr.eps_V, tr.p_c};
  }
  template <Scalar T>
  [[nodiscard]] At<T> evaluate(CamClayTrial<T> const& tr, T p, T side, T dt) const {
    T const p_c = hardening.strength(T(tr.eps_V + T(1 / m.K) * (p - tr.p)), m.K);  // (3)
    EllipsePoint<T> const point = surface.at(p, p_c);
    T const x = max(T(0.0), T(side * (p - surface.centre(p_c))));
    T const mu = rate.friction_of_step(tr.q, point, m.G, dt);  // (1)
    return {point, x, mu, flow_rule(tr.q, x, T(side * (tr.p - p)), mu)};
  }
  /// (4), where `way` is |p_tr - p|.
  template <Scalar T>
  [[nodiscard]] T flow_rule(T q_tr, T x, T way, T mu) const {
    return q_tr * x / (x + T(m.G / m.K) / (mu * mu) * way + T(1e-300));
  }
  /// The point with another S; at the tip, where p + beta p_c cancels, P = S^2/(p_c - p) goes with it.
  template <Scalar T, Scalar U>
  [[nodiscard]] EllipsePoint<U> with_shear(EllipsePoint<T> const& at, U S) const {
    T const to_cap = at.p_c - at.p;
    U const P = select<U>(U(at.P) < U(to_cap), S * S / (U(to_cap) + U(1e-300)), U(at.P));
    return {U(at.p), U(at.p_c), P, S};
  }
  /// S of (6): mu S rises with S, and q_n falls, so that there is one.
  template <Scalar T, class Condition>
  [[nodiscard]] T from_flow_rule(CamClayTrial<T> const& tr, At<T> const& at, T way, T dt, Condition wanted) const {
    auto const miss = [&](T S) -> WithDerivative<T> {
      using D = Dual<1, T>;
      EllipsePoint<D> const point = with_shear(at.point, D::variable(S, 0));
      D const mu = rate.friction_of_step(D(tr.q), point, m.G, D(dt));
      D const off = mu * point.S - flow_rule(D(tr.q), D(at.x), D(way), mu);
      return {off.value, off.derivative(0)};
    };
    T const most = at.point.S + T(2 * std::sqrt(tolerance)) * at.point.p_c;
    T const below = select<T>(wanted, 0.0, at.point.S), above = select<T>(wanted, most, at.point.S);
    T const start = min(above, max(below, min(T(at.q_n / at.mu), at.point.S)));
    return bracketed_newton<T>(miss, below, above, start, T(1e-200)).x;
  }
};

}  // namespace talus::law
