#pragma once

#include <algorithm>
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
          parameter(&Parameters::E, "young_modulus", "E", "Pa", "Young's modulus", positive).usual(10, 1e13),
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
  /// d_s lambda + 2 G [Pa]: of a change of volume.
  template <class Shape>
  [[nodiscard]] double volumetric_modulus() const {
    return Shape::normals * bulk<Shape>();
  }
  /// max(d lambda, 0) + 2 G [Pa]: the stiffest answer to a motion in d dimensions, to a change of volume where nu > 0 and
  /// to shear where nu < 0.
  [[nodiscard]] double stiffest_modulus(int dimension) const { return std::max(dimension * lambda, 0.0) + 2 * G; }
  /// lambda + 2 G [Pa]: of waves of compression.
  [[nodiscard]] double wave_modulus() const { return lambda + 2 * G; }
};

}  // namespace talus::law
