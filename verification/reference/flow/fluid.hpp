#pragma once
/// A granular fluid: mu(I) friction on the ellipse of Cam-Clay, as a relation of stress and shear rate in simple shear.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/reference/materials.hpp"

namespace talus::reference::flow {

constexpr double gravity = 9.81;  // [m/s^2]
[[nodiscard]] inline double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}
[[nodiscard]] inline double tangent(double degrees) {
  return std::tan(radians(degrees));
}

/// q [Pa]: shear stress, p [Pa]: pressure, p_c [Pa]: compressive strength, gamma [1/s]: shear rate, all >= 0; Kirchhoff
/// where that differs from Cauchy. With S = sqrt((p_c - p)(p + beta p_c)), P = p + beta p_c, I = d gamma sqrt(rho_s/p),
///
///   q = S (mu_1 + (mu_2 - mu_1)/(Q sqrt(P)/gamma + 1)),   Q = I_0/(d sqrt(rho_s))                                 (1)
///   gamma = Q sqrt(P) (q - mu_1 S)_+/(mu_2 S - q)                                                                 (2)
///
/// At critical state, 2 p = (1 - beta) p_c, S = P = omega p with omega = (1 + beta)/(1 - beta), so that
///
///   q/p = omega (mu_1 + (mu_2 - mu_1)/(sqrt(omega) I_0/I + 1))                                                    (3)
///   I = sqrt(omega) I_0 (q/p - omega mu_1)/(omega mu_2 - q/p)                                                     (4)
///
/// Source: GDR MiDi (2004), doi:10.1140/epje/i2003-10153-0, for I; Jop, Forterre & Pouliquen (2006),
/// doi:10.1038/nature04801, for (3) with omega = 1; Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, for the
/// ellipse; (2) to (4) with cohesion derived.
struct Fluid {
  MuI friction;
  double beta;                    ///< cohesion: tensile over compressive strength [1]
  ExponentialStrength hardening;  ///< p_c = p_c0 exp(-xi eps_V^P)
  Elasticity elastic;
  double density;  ///< rho_0 [kg/m^3] of the bulk, unstrained

  [[nodiscard]] double omega() const { return (1 + beta) / (1 - beta); }
  /// rho_0/rho_s [1].
  [[nodiscard]] double solid_fraction() const { return density / friction.rho_s; }
  [[nodiscard]] double critical_strength(double p) const { return 2 * p / (1 - beta); }

  /// (3), of q/p; (4).
  [[nodiscard]] double ratio(double I) const {
    return omega() * (friction.mu_1 + (friction.mu_2 - friction.mu_1) * I / (std::sqrt(omega()) * friction.I_0 + I));
  }
  [[nodiscard]] double inertial_number(double ratio) const {
    double const w = omega();
    return std::sqrt(w) * friction.I_0 * (ratio - w * friction.mu_1) / (w * friction.mu_2 - ratio);
  }

  [[nodiscard]] double size(double p, double p_c) const { return std::sqrt((p_c - p) * (p + beta * p_c)); }  ///< S
  /// (1).
  [[nodiscard]] double stress(double gamma, double p, double p_c) const {
    double const rate = friction.Q() * std::sqrt(p + beta * p_c);
    return size(p, p_c) * (friction.mu_1 + (friction.mu_2 - friction.mu_1) * gamma / (rate + gamma));
  }
  /// (2): infinite or negative where q >= mu_2 S, which no shear rate carries.
  [[nodiscard]] double rate(double q, double p, double p_c) const {
    double const S = size(p, p_c), above = q - friction.mu_1 * S;
    return above <= 0 ? 0 : friction.Q() * std::sqrt(p + beta * p_c) * above / (friction.mu_2 * S - q);
  }
  /// (2) at critical state.
  [[nodiscard]] double rate(double q, double p) const {
    double const S = omega() * p, above = q - friction.mu_1 * S;
    return above <= 0 ? 0 : friction.Q() * std::sqrt(S) * above / (friction.mu_2 * S - q);
  }
};

/// Glass beads of 2.5 mm, static angle 20.9 degrees, with that limiting angle [degrees] and cohesion; E = 1 MPa,
/// nu = 0.3, everything in the plane. Source: Blatny, Gray & Gaume (2024), with 32.76 and 40 degrees.
[[nodiscard]] inline Fluid glass_beads(double limiting_angle, double beta) {
  return {{tangent(20.9), tangent(limiting_angle), 0.279, 2.5e-3, 2500}, beta, {100, 50}, {1e6, 0.3, 2}, 1550};
}

}  // namespace talus::reference::flow
