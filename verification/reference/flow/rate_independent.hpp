#pragma once
/// The layer down a slope without rate dependence, q <= omega mu p, in the limit of stiff elasticity.

#include <algorithm>
#include <cmath>
#include <vector>

#include "verification/reference/flow/fluid.hpp"

namespace talus::reference::flow {

/// Of thickness h [m], on a slope [rad], from u = U y/h, y [m] up from a base that holds what lies on it.
///
///   a = g cos(slope) (tan(slope) - mu)
///
/// a < 0: what shears slows down as one, and comes to rest from the base upwards, all of it at t = U/|a|:
///
///   u = max(0, U y/h + a t),   rests below y = h |a| t/U                                                          (1)
///
/// a > 0: it speeds up as one above a slip at the base, and is never steady:
///
///   u = U y/h + a t,   y > 0                                                                                      (2)
///
/// Elastic shear adds to u what closes the change of stress at rest, of the order |a| rho (h/U) |a| h/G. Derived; the
/// problem is that of Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figure 31.
struct RateIndependentLayer {
  double slope, h, mu, U;

  [[nodiscard]] double acceleration() const { return gravity * (std::sin(slope) - mu * std::cos(slope)); }
  [[nodiscard]] double speed(double y, double t) const {
    double const u = U * y / h + acceleration() * t;
    return y > 0 ? std::max(u, 0.0) : 0;
  }
  [[nodiscard]] double end() const { return -U / acceleration(); }  ///< [s]; where a < 0
};

/// u [m/s] of the elastic, perfectly plastic layer at Y = k h/n, k = 0 ... n, at those times [s]: implicit Euler steps
/// dt, each a system in tau by KINSOL,
///
///   u = u_0 + dt (g sin(slope) + tau_Y/rho),   tau = tau_0 + G dt u_Y, cut off at +-mu p                           (3)
///
/// written as  tau = (tau - c (tau - tau_0 - G dt u_Y)) cut off,  c > 0, for which Newton's steps are those of an
/// active set. From tau = mu p. Steps do not harm (1) and (2), which are linear in t. Pre: times are multiples of dt.
[[nodiscard]] std::vector<std::vector<double>> rate_independent_steps(RateIndependentLayer const&, double density,
                                                                      double G, int n, double dt,
                                                                      std::vector<double> const& times);

}  // namespace talus::reference::flow
