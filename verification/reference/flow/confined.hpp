#pragma once
/// Steady flows between walls, incompressible and at critical state: sheared by a plate, down a chute, between
/// cylinders, down a channel. p, q: fluid.hpp; Q sqrt(omega p) is the rate by which shear rates are measured.

#include "verification/reference/flow/fluid.hpp"
#include "verification/reference/flow/shear_flow.hpp"

namespace talus::reference::flow {

/// Between plates under a pressure [Pa], without gravity: gamma = speed/gap, q the same everywhere.
struct PlaneShear {
  Fluid fluid;
  double pressure, speed, gap;  ///< [Pa], [m/s], [m]

  [[nodiscard]] double shear_stress() const;          ///< fluid.hpp, (3) [Pa]
  [[nodiscard]] double shear_stress_by_root() const;  ///< of fluid.hpp, (2), in q
};

/// Below a plate that is drawn along a bed, x [m] down from the plate:  p = load + rho g x,  q = T. It flows where
/// T > omega mu_1 p. With z = sqrt(omega p), from z_0 at the plate to z_1 = sqrt(T/mu_1),
///
///   u_plate = Q/(omega rho g) [F]_{z_0}^{z_1},
///   F = -(2 mu_1/(3 mu_2)) z^3 + (2 T (mu_2 - mu_1)/mu_2^2) (z + (z_2/2) ln((z - z_2)/(z + z_2))),
///   z_2 = sqrt(T/mu_2)                                                                                           (1)
///
/// The closer T comes to omega mu_2 load, the less of the flow is in reach of a Gauss rule: KINSOL's way is for less.
/// Derived.
struct PlateOnBed {
  Fluid fluid;
  double load;  ///< [Pa]

  [[nodiscard]] double depth(double T) const;  ///< of the flow [m]
  [[nodiscard]] double speed(double T) const;  ///< (1) [m/s]; omega mu_1 load < T < omega mu_2 load
  [[nodiscard]] ShearFlow flow(double T) const;
  /// T [Pa] of a speed of the plate, as a root of (1), and of the quadrature of `flow`.
  [[nodiscard]] double shear_stress(double speed) const;
  [[nodiscard]] double shear_stress_by_quadrature(double speed) const;
};

/// Down a vertical chute between walls at x = +-half_width [m] under a lateral pressure p:  q = rho g |x|, and with
/// s = rho g x/(omega p), s_W at the wall, A = Q sqrt(omega p) omega p/(rho g)
///
///   u = A ((mu_2 - mu_1) ln((mu_2 - s)/(mu_2 - s_W)) - (s_W - s)),   s > mu_1;   plug where s < mu_1              (2)
///
/// Pre: mu_1 < s_W < mu_2. Derived; cf. GDR MiDi (2004), doi:10.1140/epje/i2003-10153-0.
struct VerticalChute {
  Fluid fluid;
  double pressure, half_width;

  [[nodiscard]] double plug() const;  ///< half its width [m]
  [[nodiscard]] double speed(double x) const;
  [[nodiscard]] ShearFlow flow() const;
};

/// Between cylinders, the inner one turning, under a uniform p: q r^2 is constant. With s = q/(omega p), s_i at R_i,
///
///   u/r = (Q sqrt(omega p)/2) (-(mu_1/mu_2) ln(s/mu_1) - (1 - mu_1/mu_2) ln((mu_2 - s)/(mu_2 - mu_1)))            (3)
///
/// out to r = R_i sqrt(s_i/mu_1), beyond which it rests and which is to lie within the outer cylinder. Derived.
struct AnnularCouette {
  Fluid fluid;
  double pressure, inner_radius;

  [[nodiscard]] double reach(double s_i) const;                    ///< [m]
  [[nodiscard]] double angular_speed(double s_i, double r) const;  ///< (3) [1/s]
  [[nodiscard]] ShearFlow flow(double s_i) const;                  ///< of u/r, whose rate is gamma/r
  [[nodiscard]] double wall_ratio(double angular_speed) const;     ///< s_i of that at R_i
};

/// Down a channel of that width, as a mean across it; z [m] down from the surface. Friction of both walls makes
///
///   q = p (tan(slope) - mu_w z/width),   p = rho g cos(slope) z                                                   (4)
///
/// so that it flows to z_f = width (tan(slope) - omega mu_1)/mu_w; z_c = width (omega mu_2 - tan(slope))/mu_w > 0:
///
///   u = 2 Q sqrt(omega rho g cos(slope)) [F] from w = sqrt(z) to sqrt(z_f),
///   F = (z_f + z_c)(w - sqrt(z_c) atan(w/sqrt(z_c))) - w^3/3                                                     (5)
///
/// Source: Taberlet et al. (2003), doi:10.1103/PhysRevLett.91.264301; Jop, Forterre & Pouliquen (2005),
/// doi:10.1017/S0022112005005987, for (4); (5) derived.
struct ChannelFlow {
  Fluid fluid;
  double slope, width, wall_friction;  ///< [rad], [m], [1]

  [[nodiscard]] double depth() const;  ///< z_f
  [[nodiscard]] double speed(double z) const;
  [[nodiscard]] ShearFlow flow() const;
};

}  // namespace talus::reference::flow
