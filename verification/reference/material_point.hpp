#pragma once
/// The rate equations of a material point under a prescribed velocity gradient.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "verification/reference/rate_laws.hpp"

namespace talus::reference {

using Matrix = Eigen::Matrix3d;

/// Hencky strain of b^e [1], tension positive, and plastic volumetric strain [1], positive in dilation.
struct State {
  Matrix eps;
  double eps_V;
};

/// A state at a time of a path, and what follows from it.
struct Row {
  double t;
  State state;
  Matrix tau;               ///< Kirchhoff stress [Pa]; in reduced plane strain zz is lambda tr(eps) and takes no part
  double p, q, p_c, gamma;  ///< [Pa], [Pa], [Pa], [1/s]
  double volume_rate;       ///< (eps_V^P)' [1/s]
  bool plastic;
};

/// What is integrated: 6 entries of h (xx, yy, zz, xy, yz, xz) and eps_V^P.
///
///   h = (b^e - I)/2,   h' = D + l h + h l^T - D^P (I + 2 h)                                                       (1)
///
/// which is b^e' = l b^e + b^e l^T - 2 D^P b^e for a coaxial D^P. Stresses are small beside the moduli: b^e itself
/// would lose four digits. eps = ln(I + 2 h)/2 by the spectral decomposition of h.
inline constexpr int coordinates = 7;
using Coordinates = std::array<double, coordinates>;

[[nodiscard]] Coordinates coordinates_of(State const&);
[[nodiscard]] State state_of(double const* y);

/// The matrix h of six numbers in the order above, and back.
[[nodiscard]] Matrix symmetric(double const* six);
void store_symmetric(Matrix const& h, double* six);

/// Size below which errors of the coordinates do not matter, to be multiplied by a relative tolerance.
[[nodiscard]] Coordinates sizes_of(RateLaw const&);

[[nodiscard]] Row row_of(RateLaw const&, double t, Matrix const& velocity_gradient, double const* y, bool plastic);

/// dy/dt; false where the law is not defined.
[[nodiscard]] bool rates(RateLaw const&, bool plastic, Matrix const& velocity_gradient, double const* y, double* dy);

/// tau' [Pa/s] of the rates dy:  tau' = lambda tr(eps') I + 2 G eps',  eps'_ab = (f(h_a) - f(h_b))/(h_a - h_b) h'_ab in
/// the axes of h, f(x) = ln(1 + 2 x)/2.
[[nodiscard]] Matrix stress_rate(RateLaw const&, double const* y, double const* dy);

/// The function whose change of sign ends a plastic or elastic phase: it rises through 0 in an elastic one, falls
/// through 0 in a plastic one.
[[nodiscard]] double event(RateLaw const&, bool plastic, Matrix const& velocity_gradient, double const* y);

/// Whether the state flows from now on, after a change of velocity gradient. Throws std::domain_error where a stress
/// lies outside of the surface of a rate-independent law.
[[nodiscard]] bool starts_plastic(RateLaw const&, bool was_plastic, Matrix const& velocity_gradient, double const* y);

}  // namespace talus::reference
