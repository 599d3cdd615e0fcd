#pragma once
/// The steady layer down a slope with its change of volume: thickness, solid fraction and speed of a given mass.

#include <vector>

#include "verification/reference/flow/fluid.hpp"

namespace talus::reference::flow {

/// A layer of thickness h_0 [m] and density rho_0 where unstrained, at critical state on a slope [rad]. Y [m]: height
/// in the unstrained layer; y [m]: height. The layer moves along the slope and in height only, so that J = dy/dY, and
/// Kirchhoff stress is J times Cauchy stress. Equilibrium holds for Cauchy stress:
///
///   -sigma_yy = N,   sigma_xy = N tan(slope),   N = rho_0 g cos(slope) (h_0 - Y)                                   (1)
///
/// The law holds for Kirchhoff stress, with p its pressure in the plane, q its largest shear stress in it,
/// p_c = 2 p/(1 - beta) = p_c0 exp(-xi eps_V^P) and J = exp(eps_V^P - p/K):
///
///   J = (p_c0 (1 - beta)/(2 p))^(1/xi) exp(-p/K),   rho = rho_0/J,   phi = phi_0/J                                 (2)
///
/// Small elastic shear, q << G:  p = J N,  q = p tan(slope). With a = 1/xi, c = (p_c0 (1 - beta)/2)^a, w = rho_0 g
/// cos(slope) and gamma = A sqrt(p) that is
///
///   N = p^(1 + a) exp(p/K)/c,   p_b = (1 + a) K W0((c w h_0)^(1/(1 + a))/((1 + a) K))  at the base                 (3)
///   w (h - y) = (1 + a) p + p^2/(2 K)                                                                              (4)
///   w (u_h - u) = A ((2/3)(1 + a) p^(3/2) + (2/5) p^(5/2)/K)                                                       (5)
///
/// Finite elastic shear: in steady simple shear the principal axes of b^e do not turn, and with s = q/G
///
///   J N = p + q tanh(s),   J N tan(slope) = q/cosh(s),   gamma = (du/dy)/cosh(s)                                   (6)
///   p = G s (1/(tan(slope) cosh(s)) - tanh(s)),   q = G s,   N = G s/(tan(slope) cosh(s) J(p))                     (7)
///
/// so that s is a coordinate of the layer. Derived. Nothing here stands for the few layers of grains, or of cells, next
/// to the surface, where p -> 0 and J grows as p^(-a).
struct CompressibleLayer {
  Fluid fluid;
  double slope, h_0;

  [[nodiscard]] double weight() const { return fluid.density * gravity * std::cos(slope); }  ///< w [Pa/m]
  [[nodiscard]] double normal_stress(double Y) const { return weight() * (h_0 - Y); }        ///< N [Pa]
  [[nodiscard]] double stretch(double p) const;                                              ///< J, (2)
  [[nodiscard]] double pressure(double N) const;  ///< (3) at the normal stress N [Pa]
};

/// One place of it.
struct CompressibleState {
  double y, u;           ///< [m], [m/s]
  double p, q, stretch;  ///< Kirchhoff [Pa]; J [1]
  [[nodiscard]] double ratio() const { return q / p; }
};

/// Places in the order in which they were asked for, and the layer as a whole. Means are over mass, as of particles of
/// equal mass; the mean of phi is over the height.
struct CompressibleProfile {
  std::vector<CompressibleState> at;
  double h, surface_speed;        ///< [m], [m/s]
  double mean_speed, mean_ratio;  ///< [m/s]; of q/p [1]
  double solid_fraction;          ///< phi_0 h_0/h [1]
};

/// At heights Y [m] of the unstrained layer, 0 <= Y < h_0: (3) to (5).
[[nodiscard]] CompressibleProfile small_shear_profile(CompressibleLayer const&, std::vector<double> const& Y);
/// (6), (7), integrated over s by GSL.
[[nodiscard]] CompressibleProfile profile_by_quadrature(CompressibleLayer const&, std::vector<double> const& Y);
/// (6) with (2) as equations in p, q and gamma at the points of a Gauss rule in Y by KINSOL, and their sums; the law as
/// q(gamma).
[[nodiscard]] CompressibleProfile profile_by_kinsol(CompressibleLayer const&, std::vector<double> const& Y);
/// (6), (7), as differential equations in s by CVODE.
[[nodiscard]] CompressibleProfile profile_by_cvode(CompressibleLayer const&, std::vector<double> const& Y);

}  // namespace talus::reference::flow
