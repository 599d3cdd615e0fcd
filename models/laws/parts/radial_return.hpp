#pragma once

#include <cmath>

#include "core/dual.hpp"
#include "core/roots.hpp"
#include "models/laws/parts/ellipse.hpp"

namespace talus::law {

/// The return along the radius, at constant pressure, onto a surface that may soften with the plastic shear strain.
///
///   e   = e_n + (q_tr - q)/(sqrt(2) G)          e: ||dev eps^P||                               (1)
///   r(q) = q - relax(q_tr, S(e)) = 0            relax: what the rate law leaves of q_tr         (2)
///
/// q in [0, q_tr], and r(q_tr) >= 0, r(-q_tr) < 0: always bracketed, also where S ends at 0. Where the strength falls
/// faster than the stress there may be several roots. `surface` gives the point of the surface at e, for any scalar.
/// Source: Simo & Hughes (1998), Computational Inelasticity, ch. 3; bracket derived here.
template <class Rate, Scalar T, class Surface, class Condition>
[[nodiscard]] T radial_return(Rate const& rate, T q_tr, T e_n, double G, T dt, Surface const& surface,
                              Condition plastic) {
  double const slip = 1 / (std::sqrt(2.0) * G);
  auto const residual = [&](T q) -> WithDerivative<T> {
    using D = Dual<1, T>;
    D const stress = D::variable(q, 0), e = D(e_n) + D(slip) * (D(q_tr) - stress);
    D const r = stress - rate.relax(D(q_tr), surface(e), G, D(dt));
    return {r.value, select<T>(is_finite(r.derivative(0)), r.derivative(0), 0.0)};
  };
  T const bound = select<T>(plastic, -q_tr, q_tr);
  T const start = select<T>(plastic, min(q_tr, rate.relax(q_tr, surface(e_n), G, dt)), q_tr);
  return max(T(0.0), bracketed_newton<T>(residual, bound, q_tr, start, T(1e-15) * q_tr).x);
}

}  // namespace talus::law
