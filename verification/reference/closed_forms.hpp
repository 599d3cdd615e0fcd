#pragma once
/// Paths of a material point that have a solution in closed form. Symbols and signs as in materials.hpp.

#include "verification/reference/materials.hpp"

namespace talus::reference {

/// Isotropic compression on the cap of Cam-Clay with exponential hardening, p = p_c:
///
///   eps_v = p/K + ln(p/p_c0)/xi   =>   p = (K/xi) W0((xi p_c0/K) exp(xi eps_v))                                    (1)
///
/// eps_v [1]: compaction -ln J since p = 0 and eps_V^P = 0, at least p_c0/K. Derived.
[[nodiscard]] double isotropic_compression(double K, ExponentialStrength const&, double eps_v);

struct PressureAndShear {
  double p, q;
};
/// Critical state of Cam-Clay with exponential hardening under shear at constant volume, from p_i with eps_V^P = 0:
/// p/K - eps_V^P = p_i/K and p_c = 2 p/(1 - beta) give
///
///   p = (K/xi) W0((1 - beta) xi p_c0/(2 K) exp(xi p_i/K)),   q = M p (1 + beta)/(1 - beta).                        (2)
///
/// Holds for the consistent viscous laws as well, with their friction in place of M. Derived.
[[nodiscard]] PressureAndShear constant_volume_critical_state(double K, Ellipse const&, ExponentialStrength const&,
                                                              double p_i);

/// mu(I) at critical state, 2 p = (1 - beta) p_c, under coaxial shear at the rate `shear_rate` [1/s] and constant
/// volume, so that p, S and P stay. x = q/S starts at mu_1 at t = 0; a = Q sqrt(P):
///
///   x_inf = mu(I) = (shear_rate mu_2 + a mu_1)/(shear_rate + a)
///   G (shear_rate - a (x - mu_1)/(mu_2 - x)) = S x'
///   t = S/(G (shear_rate + a)) [(x - mu_1) - (mu_2 - x_inf) ln((x_inf - x)/(x_inf - mu_1))]                       (3)
///   x_inf - x = (mu_2 - x_inf) W0(u exp(u - k t)),  u = (x_inf - mu_1)/(mu_2 - x_inf),
///   k = G (shear_rate + a)/(S (mu_2 - x_inf))                                                                   (4)
///
/// Derived.
struct MuIStartUp {
  MuI law;
  double G, S, P, shear_rate;

  [[nodiscard]] double limit() const;             ///< x_inf
  [[nodiscard]] double time(double x) const;      ///< (3) [s], mu_1 <= x < x_inf
  [[nodiscard]] double friction(double t) const;  ///< (4)
};

/// mu = q/p at critical state as a function of I = d gamma sqrt(rho_s/p), omega = (1 + beta)/(1 - beta):
///
///   mu = omega (mu_1 + (mu_2 - mu_1)/(sqrt(omega) I_0/I + 1)).                                                     (5)
///
/// beta = 0: Jop, Forterre & Pouliquen (2006), doi:10.1038/nature04801; else derived from Blatny, Gray & Gaume (2024).
[[nodiscard]] double critical_friction(MuI const&, double beta, double p, double shear_rate);

/// von Mises under coaxial shear at the rate `shear_rate`, from q_0 >= q_y:  q' = G (shear_rate - (q - q_y)/eta),
///
///   q = q_inf + (q_0 - q_inf) exp(-G t/eta),   q_inf = q_y + eta shear_rate.                                       (6)
///
/// eta [Pa s] = q_y t_v: Perzyna with s = 1; G t_v: Duvaut-Lions. shear_rate 0: relaxation.
[[nodiscard]] double linear_viscous_stress(double G, double q_y, double eta, double q_0, double shear_rate, double t);

/// Steady simple shear l_xy of a mu(I) material with beta = 0 under tau_yy = -sigma_n, at finite strain: b^e' = 0 with
/// q/G the difference of the two elastic strains in the plane gives
///
///   p = sigma_n - q tanh(q/G),   |tau_xy| = q/cosh(q/G),   gamma = |l_xy|/cosh(q/G),   q = mu(I) p,               (7)
///   p_c = 2 p,   eps_V^P = ln(p_c0/p_c)/xi;
///
/// for q << G that is p = sigma_n, |tau_xy| = mu(I) sigma_n. Derived.
struct DirectShear {
  double p, q, tau_xy, gamma, eps_V;
};
[[nodiscard]] DirectShear steady_direct_shear(double G, MuI const&, ExponentialStrength const&, double sigma_n,
                                              double shear_rate);

}  // namespace talus::reference
