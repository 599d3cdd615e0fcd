#pragma once

#include <tuple>

#include "core/config/parameters.hpp"
#include "core/tensor.hpp"

namespace talus::law {

/// The two moduli of an isotropic elastic solid.
///
///   G = E / (2 (1 + nu)),   lambda = nu E / ((1 + nu) (1 - 2 nu)),   K = lambda + 2 G / d_s
///
/// lambda, G, K [Pa]: Lamé's first, shear and bulk modulus. K depends on the number d_s of normal strains of the shape.
struct Moduli {
  struct Parameters {
    double E = 1e6, nu = 0.3;
    static constexpr auto table() {
      return std::tuple{
          parameter(&Parameters::E, "young_modulus", "E", "Pa", "Young's modulus", positive),
          parameter(&Parameters::nu, "poisson_ratio", "nu", "1", "Poisson's ratio", open(-1, 0.5)),
      };
    }
  };

  double lambda, G;

  explicit Moduli(Parameters const& p)
      : lambda(p.nu * p.E / ((1 + p.nu) * (1 - 2 * p.nu))), G(p.E / (2 * (1 + p.nu))) {}

  /// K [Pa].
  template <class Shape>
  [[nodiscard]] double bulk() const {
    return lambda + 2 * G / Shape::normals;
  }
  /// d_s lambda + 2 G [Pa]: what the time step needs.
  template <class Shape>
  [[nodiscard]] double volumetric_modulus() const {
    return Shape::normals * bulk<Shape>();
  }
};

}  // namespace talus::law
