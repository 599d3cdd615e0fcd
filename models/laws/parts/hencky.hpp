#pragma once

#include <cmath>

#include "core/tensor.hpp"
#include "models/laws/parts/moduli.hpp"

namespace talus::law {

/// What a stress that one divides by is kept from 0 with [Pa].
inline constexpr double least_stress = 1e-300;

/// A strain in the quantities that isotropic yield surfaces speak of.
template <Scalar T, class Shape>
struct StressSplit {
  T p, q;                        ///< pressure, positive in compression, and shear stress [Pa]
  Symmetric<T, Shape> deviator;  ///< of the strain [1]
};

/// Hyperelasticity that is linear in the logarithmic strain.
///
///   Psi = lambda/2 tr(eps)^2 + G eps : eps,   tau = lambda tr(eps) I + 2 G eps     (1)
///   p = -K tr(eps),   q = sqrt(2) G ||dev eps||                                    (2)
///
/// eps [1]: elastic Hencky strain, tension positive. tau [Pa]: Kirchhoff stress. Psi [J/m^3]: per reference volume.
/// Source: Hencky (1928), Z. tech. Phys. 9, 215-220; form (1) as in Anand (1979), doi:10.1115/1.3424532.
struct HenckyElasticity : Moduli {
  using Moduli::Moduli;

  template <Scalar T, class Shape>
  [[nodiscard]] Symmetric<T, Shape> stress(Symmetric<T, Shape> const& eps) const {
    return T(2 * G) * eps + isotropic<Shape>(T(lambda * trace(eps)));
  }

  template <Scalar T, class Shape>
  [[nodiscard]] T energy(Symmetric<T, Shape> const& eps) const {
    T const volume = trace(eps);
    return T(0.5 * lambda) * volume * volume + T(G) * contract(eps, eps);
  }

  /// (2).
  template <Scalar T, class Shape>
  [[nodiscard]] StressSplit<T, Shape> split(Symmetric<T, Shape> const& eps) const {
    auto const dev = deviator(eps);
    return {-bulk<Shape>() * trace(eps), std::sqrt(2.0) * G * norm(dev), dev};
  }

  /// The strain with pressure p and with `keep` times a deviator: the inverse of `split`.
  template <Scalar T, class Shape>
  [[nodiscard]] Symmetric<T, Shape> strain(T p, T keep, Symmetric<T, Shape> const& dev) const {
    return keep * dev + isotropic<Shape>(T(p * T(-1.0 / volumetric_modulus<Shape>())));
  }
};

}  // namespace talus::law
