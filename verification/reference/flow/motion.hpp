#pragma once
/// A layer that starts, stops or changes its speed down a slope: the elasto-viscoplastic column by the method of lines.

#include <string>
#include <vector>

#include "verification/reference/flow/fluid.hpp"
#include "verification/reference/flow/gsl.hpp"

namespace talus::reference::flow {

/// A layer that moves along the slope only, apart from its change of height. Y [m]: height in the unstrained layer, of
/// thickness h_0 and density rho_0; w = rho_0 g cos(slope); u [m/s]; tau [Pa]: Kirchhoff shear stress.
///
///   u_t = g sin(slope) + (tau/J)_Y/rho_0,   u = 0 at Y = 0,   tau = 0 at Y = h_0                                   (1)
///   tau_t = G (u_Y/J - g_p),   g_p = sgn(tau) gamma(|tau|, p, p_c)                                                (2)
///
/// gamma: fluid.hpp, (2). The pressure is that of rest in height: p = J w (h_0 - Y). Three ways of volume:
///
/// incompressible    J = 1 and 2 p = (1 - beta) p_c: the reduction of the model to one dimension that is mostly used
/// critical          2 p = (1 - beta) p_c,  J = (p_c0/p_c)^(1/xi) exp(-p/K): as the steady compressible layer
/// hardening         J = exp(eps - p/K),  p_c = p_c0 exp(-xi eps),  eps = eps_V^P with
///
///   eps_t = |g_p| (|tau|/S) ((1 - beta) p_c - 2 p)/(2 S)                                                          (3)
///
/// (3) is associated flow of the consistent law; the published two-stage map ends at the same state.
/// Pre: mu_1 < mu_2. Left out: inertia and waves across the layer; tau and p to second order in |tau|/G. Stress starts
/// with tau = 0, or as that of the initial shear rate; p_c starts as `strength_ratio` times that of critical state,
/// which is to be above p.
/// Source: Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, for the model; the reduction derived.
struct Motion {
  enum class Volume { incompressible, critical, hardening };

  Fluid fluid;
  double slope, h_0;  ///< [rad], [m]
  Volume volume;
  Function speed;  ///< u of Y at t = 0
  bool sheared;    ///< whether tau starts as that of the initial shear rate, else 0
  double strength_ratio = 1;
};

/// At a time t [s]: u at the nodes Y = h_0 (1 - (1 - k/n)^2), k = 0 ... n, with their heights y; the rest half way
/// between nodes k and k + 1, in k.
struct Snapshot {
  double t;
  std::vector<double> Y, y, u;
  std::vector<double> tau, p, p_c, stretch;

  [[nodiscard]] double surface_speed() const { return u.back(); }
  [[nodiscard]] double mean_speed() const;  ///< over mass: Simpson's rule, n even
};

/// n cells, second order in 1/n; relative tolerance in time. CVODE: (1) to (3) as rates. IDA: with g_p as an unknown of
/// its own, whose equation is the law without a division,
///
///   |g_p| (mu_2 S - |tau|) = Q sqrt(P) (|tau| - mu_1 S)_+                                                          (4)
[[nodiscard]] std::vector<Snapshot> motion_by_cvode(Motion const&, int n, std::vector<double> const& times,
                                                    double tolerance);
[[nodiscard]] std::vector<Snapshot> motion_by_ida(Motion const&, int n, std::vector<double> const& times,
                                                  double tolerance);

/// The limit G -> infinity, without (2) and with nothing of the code above: tau = q(u_Y, p, p_c), fluid.hpp, (1), in
///
///   u_t = g sin(slope) + tau_Y/rho_0.                                                                              (5)
///
/// tau, p, p_c, stretch are left out. Pre: incompressible, u > 0 at the surface, and u_Y > 0 throughout: there is no
/// plug, where (5) leaves tau open.
[[nodiscard]] std::vector<Snapshot> rigid_motion(Motion const&, int n, std::vector<double> const& times,
                                                 double tolerance);

/// By n, 2 n and 4 n cells: u and y at the nodes of n, extrapolated from the two finer ones at second order; and how
/// far, at most over all nodes and times, u lies from that of 4 n, and from u extrapolated from n and 2 n [m/s].
struct ExtrapolatedMotion {
  std::vector<Snapshot> at;  ///< of n cells; tau, p, p_c, stretch are left out
  double correction, error;
};
[[nodiscard]] ExtrapolatedMotion extrapolated_motion(Motion const&, int n, std::vector<double> const& times,
                                                     double tolerance);

}  // namespace talus::reference::flow
