#pragma once
/// Constitutive laws as rate equations: how fast material flows at a stress, under a rate of deformation.

#include <functional>

#include "verification/reference/materials.hpp"

namespace talus::reference {

/// p, q [Pa] as in Elasticity; eps_V [1]: plastic volumetric strain, positive in dilation.
struct Stress {
  double p, q, eps_V;
};

/// tr D [1/s] and s : D [Pa/s], with s = dev tau and D the symmetric part of the velocity gradient.
struct Driving {
  double volume, shear;
};

/// Plastic rate of deformation,  D^P = shear s + (volume/normals) I,  that is  gamma = 2 q shear  and
/// (eps_V^P)' = volume. Its part along s and the trace suffice because D^P is coaxial with the stress, so that
///
///   p' = -K (tr D - volume),   q' = G (s : D/q - gamma).                                                          (1)
///
/// shear [1/(Pa s)], volume [1/s]; gamma [1/s] = sqrt(2 D' : D'). Not a number where the law is not defined.
struct Flow {
  double shear, volume;
};

/// A law in rate form. A state is elastic or plastic; it changes from one to the other at an event.
struct RateLaw {
  Elasticity elastic;
  double scale;  ///< a typical stress [Pa], for the tolerances
  /// Whether stress may lie above the yield surface. If so the material unloads where `excess` falls through 0, else
  /// where `loading` does.
  bool viscous;
  std::function<double(double)> strength;       ///< p_c [Pa] of eps_V^P; q_y(p = 0) of a cone
  std::function<double(Stress const&)> excess;  ///< yield function divided by strength: 0 on the surface
  std::function<double(Stress const&, Driving const&)> loading;  ///< its rate, were the response elastic [1/s]
  std::function<Flow(Stress const&, Driving const&)> flow;       ///< of a plastic state
};

/// Modified Cam-Clay, rate independent, associated (p_c held fixed in the gradient of y):
///
///   D^P = L dy/dtau,   (eps_V^P)' = -L y_p,   gamma = 2 q L,   y_p = M^2 (2 p - (1 - beta) p_c)                   (2)
///   y' = 0:  L = (2 G s : D - K y_p tr D)/(K y_p^2 + 4 G q^2 + y_c H y_p)                                         (3)
///   y_c = dy/dp_c = -M^2 ((1 - beta) p + 2 beta p_c),   H = dp_c/deps_V^P
///
/// Source: Roscoe & Burland (1968); the ellipse of Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643; (3) derived.
[[nodiscard]] RateLaw cam_clay(Elasticity const&, Ellipse const&, Hardening const&);

/// A viscous law on the same ellipse: the stress lies on a "dynamic" ellipse of slope mu = q/S through it, and flow is
/// normal to that,
///
///   gamma = rate(mu, P),   (eps_V^P)' = gamma mu ((1 - beta) p_c - 2 p)/(2 S),                                    (4)
///   S = sqrt((p_c - p) P),   P = p + beta p_c.
///
/// Pre: S is real and positive (the stress lies between tip and cap) wherever the state is plastic; the rates keep it
/// so, and elsewhere the flow is not a number.
///
/// mu(I):    z = q - mu_1 S,  L = (mu_2 - mu_1) S:  gamma = Q sqrt(P) z/(L - z)                                     (5)
/// Perzyna:  gamma = ((mu/M)^(1/s) - 1)/t_v                                                                        (6)
[[nodiscard]] RateLaw cam_clay_mu_i(Elasticity const&, double beta, Hardening const&, MuI const&);
[[nodiscard]] RateLaw cam_clay_perzyna(Elasticity const&, Ellipse const&, Hardening const&, Perzyna const&);

/// Duvaut-Lions: both plastic rates are those to the rate-independent projection (p_m, q_m) of the stress,
///
///   gamma = (q - q_m)/(G t_v),   (eps_V^P)' = (p_m - p)/(K t_v).                                                  (7)
///
/// The projection is that of return_maps.hpp with implicit hardening.
[[nodiscard]] RateLaw cam_clay_duvaut_lions(Elasticity const&, Ellipse const&, Hardening const&, DuvautLions const&);

/// Drucker-Prager (von Mises for M = 0) without plastic change of volume, away from the tip, q_y = M p + c > 0:
///
///   rate independent  gamma = s : D/q + M K tr D/G     from y' = 0 and (1)                                        (8)
///   Perzyna           gamma = ((q/q_y)^(1/s) - 1)/t_v                                                             (9)
///   Duvaut-Lions      gamma = (q - q_y)/(G t_v)                                                                  (10)
///
/// Source: Simo & Hughes (1998), Computational Inelasticity, for (9), (10) with von Mises.
[[nodiscard]] RateLaw cone(Elasticity const&, Cone const&);
[[nodiscard]] RateLaw cone_perzyna(Elasticity const&, Cone const&, Perzyna const&);
[[nodiscard]] RateLaw cone_duvaut_lions(Elasticity const&, Cone const&, DuvautLions const&);

}  // namespace talus::reference
