#pragma once
/// A solid in which a wave stands along every axis.
///
///   x_i = X_i + u_i,   u_i = A_i sin(k X_i) sin(w t + phi_i)                                             (1)
///   F = diag(F_i),   F_i = 1 + k A_i cos(k X_i) sin(w t + phi_i)                                         (2)
///   b_i = u_i [-w^2 + k^2 (lambda (1 - ln J) + 2 G (1 - ln F_i))/(rho_0 F_i^2)]       Hencky             (3)
///   b_i = u_i [-w^2 + k^2 (lambda (1 - ln J) + G (1 + F_i^2))/(rho_0 F_i^2)]          neo-Hookean        (4)
///
/// (3), (4): rho_0 b = rho_0 a - Div P with dF_i/dX_i = -k^2 u_i. Where one A_i alone is not zero, this is the bar.
///
/// Source: (1) Wallstedt & Guilkey (2008), doi:10.1016/j.jcp.2008.07.019; the bar: Steffen, Wallstedt, Guilkey, Kirby &
/// Berzins (2008), doi:10.3970/cmes.2008.031.107; (3) and (4) are derived here.

#include "core/tensor.hpp"
#include "verification/exact/elastic.hpp"

namespace talus::exact {

template <int D>
struct AxisAligned {
  static constexpr int dimension = D;
  Point<D> amplitude = Point<D>::Zero();  ///< A_i [m]
  double wave_number = 0;                 ///< k [1/m]
  double frequency = 0;                   ///< w [1/s]
  Point<D> phase = Point<D>::Zero();      ///< phi_i [1]

  /// (1).
  template <Scalar T>
  [[nodiscard]] Vector<T, D> position(Vector<T, D> const& X, T const& t) const {
    using std::sin;
    Vector<T, D> x = X;
    for (int i = 0; i < D; ++i) {
      auto const own = static_cast<std::size_t>(i);
      x[own] += T(amplitude[i]) * sin(T(wave_number * X[own])) * sin(T(frequency * t + T(phase[i])));
    }
    return x;
  }

  /// (3), (4) [m/s^2].
  [[nodiscard]] Point<D> body_force(Elastic const& solid, Point<D> const& X, double t) const {
    Point<D> u, F;
    for (int i = 0; i < D; ++i) {
      double const now = amplitude[i] * std::sin(frequency * t + phase[i]);
      u[i] = std::sin(wave_number * X[i]) * now;
      F[i] = 1 + wave_number * std::cos(wave_number * X[i]) * now;
    }
    double const ln_J = std::log(F.prod()), k2 = wave_number * wave_number;
    Point<D> b;
    for (int i = 0; i < D; ++i) {
      double const shear = solid.law == ElasticLaw::hencky ? 2 - 2 * std::log(F[i]) : 1 + F[i] * F[i];
      double const modulus = (solid.lambda * (1 - ln_J) + solid.G * shear) / (F[i] * F[i]);
      b[i] = u[i] * (k2 * modulus / solid.density - frequency * frequency);
    }
    return b;
  }
};

}  // namespace talus::exact
