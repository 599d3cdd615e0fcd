#pragma once
/// The elastic law of the baseline, from the deformation gradient.

#include <Eigen/SVD>
#include <stdexcept>

namespace talus::naive {

/// Of the material: density at rest [kg/m^3], Lamé's first modulus and the shear modulus [Pa].
struct Material {
  double density, lambda, G;
};

/// Kirchhoff stress [Pa] that is linear in the logarithmic strain; in two dimensions nothing lives across the plane.
///
///   F = U Sigma V^T,   eps = log Sigma,   tau = U (lambda tr(eps) I + 2 G eps) U^T
///
/// Throws std::runtime_error where F is not finite.
/// Source: Hencky (1928), Z. tech. Phys. 9, 215-220; by the singular values as in Klar et al. (2016),
/// doi:10.1145/2897824.2925906 (neither re-read).
template <int D>
[[nodiscard]] Eigen::Matrix<double, D, D> hencky_stress(Eigen::Matrix<double, D, D> const& F,
                                                        Material const& material) {
  Eigen::JacobiSVD<Eigen::Matrix<double, D, D>> const svd(F, Eigen::ComputeFullU);
  if (svd.info() != Eigen::Success) throw std::runtime_error("a deformation gradient is not finite");
  auto const& U = svd.matrixU();
  Eigen::Matrix<double, D, 1> const eps = svd.singularValues().array().log();
  Eigen::Matrix<double, D, 1> const tau = (2 * material.G * eps).array() + material.lambda * eps.sum();
  return U * tau.asDiagonal() * U.transpose();
}

}  // namespace talus::naive
