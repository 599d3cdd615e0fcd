#pragma once
/// One step of each law from its trial stress, by bisection alone: slow, and right to the digits of the number.

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "verification/reference/materials.hpp"

namespace talus::reference {

/// Fifty decimal digits.
using Digits = boost::multiprecision::cpp_bin_float_50;

/// Before a step: trial stress and the plastic volumetric strain at its start. After: stress and strain at its end.
/// p, q [Pa] and eps_V [1] as in Elasticity and Hardening.
template <class T>
struct StressOf {
  T p, q, eps_V;
};

/// Whether p_c follows eps_V^P during the step, or keeps its value of the start of the step until the stress is found.
inline constexpr bool implicit_hardening = true, explicit_hardening = false;

struct CamClay {
  Elasticity elastic;
  Ellipse surface;
  Hardening hardening;
  bool is_implicit;
};

/// Every map returns a trial stress that is not above the surface as it is. Instantiated for double,
/// long double and Digits.
///
/// Rate independent, associated. With p_c(p) the strength at eps_V + (p - p_tr)/K, or the one of the start,
///
///   D(p) = 2 p - (1 - beta) p_c(p),   q(p) = q_tr/(1 + 2 G L),   L = (p_tr - p)/(K M^2 D(p)),                      (1)
///   q(p)^2 = M^2 (p_c - p)(p + beta p_c)   between the root of D and p_tr;   eps_V += (p - p_tr)/K.               (2)
///
/// Source: backward Euler on the laws of Roscoe & Burland (1968), Blatny, Gray & Gaume (2024),
/// doi:10.1017/jfm.2024.643; (1) derived.
template <class T>
[[nodiscard]] StressOf<T> cam_clay_projection(CamClay const&, StressOf<T> const& trial);

/// Two stages: p and eps_V of the projection, then the shear stress alone is viscous. With q = q_tr - G dt gamma, and
/// S, P at the projected pressure and the p_c of the search (explicit: that of the start of the step),
///
///   mu(I):    (L - z)(O - z) = R z,  0 <= z <= min(O, L);  q = mu_1 S + z,  O = q_tr - mu_1 S,                    (3)
///             L = (mu_2 - mu_1) S,  R = G dt Q sqrt(P);  the slope of the ellipse is mu_1
///   Perzyna:  q = q_y (1 + t_v gamma)^s,  q_y = M S                                                               (4)
///
/// and by Duvaut-Lions both plastic increments are those of the projection times 1/(1 + t_v/dt).                  (5)
template <class T>
[[nodiscard]] StressOf<T> cam_clay_two_stage(CamClay const&, MuI const&, StressOf<T> const& trial, double dt);
template <class T>
[[nodiscard]] StressOf<T> cam_clay_two_stage(CamClay const&, Perzyna const&, StressOf<T> const& trial, double dt);
template <class T>
[[nodiscard]] StressOf<T> cam_clay_duvaut_lions(CamClay const&, DuvautLions const&, StressOf<T> const& trial,
                                                double dt);

/// Backward Euler on the laws of rate_laws.hpp: flow is normal to the dynamic ellipse through the stress,
///
///   (p_tr - p) S^2 = K/(2 G) (q_tr - q) q D(p),   q = q(S(p), P(p)) of (3) or (4).                                 (6)
template <class T>
[[nodiscard]] StressOf<T> cam_clay_consistent(CamClay const&, MuI const&, StressOf<T> const& trial, double dt);
template <class T>
[[nodiscard]] StressOf<T> cam_clay_consistent(CamClay const&, Perzyna const&, StressOf<T> const& trial, double dt);

/// Drucker-Prager (von Mises for M = 0) at constant p: q = q_y = M p_tr + c, or (4), or
///
///   Duvaut-Lions:  q = q_y + (q_tr - q_y) t_v/(t_v + dt).                                                         (7)
///
/// Where q_y < 0 the stress goes to the tip p = -c/M, q = 0, whatever the viscosity, and eps_V += (p - p_tr)/K.
template <class T>
[[nodiscard]] StressOf<T> cone_step(Elasticity const&, Cone const&, StressOf<T> const& trial);
template <class T>
[[nodiscard]] StressOf<T> cone_step(Elasticity const&, Cone const&, Perzyna const&, StressOf<T> const& trial,
                                    double dt);
template <class T>
[[nodiscard]] StressOf<T> cone_step(Elasticity const&, Cone const&, DuvautLions const&, StressOf<T> const& trial,
                                    double dt);

}  // namespace talus::reference
