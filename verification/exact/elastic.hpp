#pragma once
/// The elastic solids whose body forces are known in closed form.

#include <cmath>

namespace talus::exact {

/// hencky:       tau = lambda tr(eps) I + 2 G eps,      eps = 1/2 ln b
/// neo_hookean:  tau = lambda ln(J) I + G (b - I)
enum class ElasticLaw { hencky, neo_hookean };

/// An elastic solid in plane strain or in space. lambda, G [Pa]: Lame's constants.
struct Elastic {
  ElasticLaw law = ElasticLaw::hencky;
  double lambda = 0, G = 0;
  double density = 0;  ///< rho_0 [kg/m^3]

  /// Of Young's modulus E [Pa] and Poisson's ratio nu [1].
  static Elastic of(ElasticLaw law, double E, double nu, double density) {
    return {law, E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu)), density};
  }
  /// Speed of longitudinal waves in the undeformed solid [m/s].
  [[nodiscard]] double wave_speed() const { return std::sqrt((lambda + 2 * G) / density); }

  /// First Piola-Kirchhoff stress P_i [Pa] along an axis of which stretch f_i is a principal one; ln_J = sum_k ln f_k.
  [[nodiscard]] double principal_stress(double ln_J, double f) const {
    return law == ElasticLaw::hencky ? (lambda * ln_J + 2 * G * std::log(f)) / f : lambda * ln_J / f + G * (f - 1 / f);
  }
  /// Its rate dP_i/ds [Pa/m] where df_i/ds = slope_f and d(ln J)/ds = slope_ln_J.
  [[nodiscard]] double principal_slope(double ln_J, double slope_ln_J, double f, double slope_f) const {
    double const volumetric = lambda * slope_ln_J / f - lambda * ln_J * slope_f / (f * f);
    return law == ElasticLaw::hencky ? volumetric + 2 * G * (1 - std::log(f)) * slope_f / (f * f)
                                     : volumetric + G * (1 + 1 / (f * f)) * slope_f;
  }
};

}  // namespace talus::exact
