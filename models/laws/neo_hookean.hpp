#pragma once

#include <string_view>

#include "core/law.hpp"
#include "core/log_strain.hpp"
#include "models/laws/parts/elastic.hpp"
#include "models/laws/parts/moduli.hpp"

namespace talus::law {

/// Compressible neo-Hookean hyperelasticity in the logarithmic strain.
///
///   Psi = G/2 (tr b - d_s) - G ln J + lambda/2 (ln J)^2,   b - I = exp(2 eps) - I,   ln J = tr(eps)     (1)
///   tau = G (b - I) + lambda ln J I                                                                     (2)
///
/// eps [1]: elastic Hencky strain, tension positive. tau [Pa]: Kirchhoff stress. Psi [J/m^3]: per reference volume.
/// In reduced plane strain b is the 2x2 tensor of the plane. With lambda < 0 (nu < 0) Psi is not convex at large
/// strain.
///
/// There is no plastic law with it: in (2) pressure and shear stress both depend on volume and deviator, and the deviators
/// of tau and eps are not in proportion, so that a return map would be a solve for three principal strains. The strains
/// that grains, soils and snow carry elastically are of 1e-2 and less, where (2) is the Hencky law to their square: a
/// product would cost more and say the same.
///
/// Source: Simo & Pister (1984), doi:10.1016/0045-7825(84)90062-8.
struct NeoHookeanElasticity : Moduli {
  using Moduli::Moduli;

  template <Scalar T, class Shape>
  [[nodiscard]] Symmetric<T, Shape> stress(Symmetric<T, Shape> const& eps) const {
    return T(G) * expm1_twice(eps) + isotropic<Shape>(T(lambda * trace(eps)));
  }

  template <Scalar T, class Shape>
  [[nodiscard]] T energy(Symmetric<T, Shape> const& eps) const {
    T const ln_J = trace(eps);
    return T(0.5 * G) * (trace(expm1_twice(eps)) - T(2.0) * ln_J) + T(0.5 * lambda) * ln_J * ln_J;
  }
};

/// Elastic solid after (1), (2) of NeoHookeanElasticity.
struct NeoHookean : Elastic<NeoHookeanElasticity> {
  static constexpr std::string_view name = "neo_hookean", title = "Elastic, compressible neo-Hookean",
                                    source = "Simo & Pister (1984), doi:10.1016/0045-7825(84)90062-8";
  using Elastic::Elastic;
};
static_assert(Law<NeoHookean>);

}  // namespace talus::law
