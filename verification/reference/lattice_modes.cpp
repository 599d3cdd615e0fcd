#include "verification/reference/lattice_modes.hpp"

#include <algorithm>
#include <cmath>

#include "verification/reference/linear_algebra.hpp"

namespace talus::reference {

double cardinal_spline(int degree, double x) {
  if (degree == 1) return std::max(0.0, 1 - std::abs(x));  // has no jump that a rounding could miss
  double const reach = 0.5 * (degree + 1);
  return ((reach + x) * cardinal_spline(degree - 1, x + 0.5) + (reach - x) * cardinal_spline(degree - 1, x - 0.5)) /
         degree;
}

double cardinal_spline_slope(int degree, double x) {
  if (degree == 1) return std::abs(x) >= 1 ? 0 : x < 0 ? 1 : -1;
  return cardinal_spline(degree - 1, x + 0.5) - cardinal_spline(degree - 1, x - 0.5);
}

LatticeMode lattice_mode(Transfer const& transfer, int particles_per_cell, double kh) {
  int const degree = transfer.degree, n = particles_per_cell;
  LatticeMode mode{0, 0, 0};
  for (int p = -3 * n; p < 3 * n; ++p) {
    double const x = (p + 0.5) / n;
    double velocity = 0, affine = 0, gradient = 0;
    for (int i = -6; i <= 6; ++i) {
      double const wave = std::cos(kh * i), weight = cardinal_spline(degree, x - i);
      velocity += weight * wave;
      affine += weight * (i - x) * wave;
      gradient += cardinal_spline_slope(degree, x - i) * wave;
    }
    mode.S += cardinal_spline(degree, x) * velocity / n;
    mode.s += cardinal_spline(degree, x) * -x * affine / n;
    mode.Q += cardinal_spline_slope(degree, x) * gradient / n;
  }
  mode.s *= transfer.affine ? 12.0 / (degree + 1) : 0;
  return mode;
}

std::complex<double> wave_factor(Transfer const& transfer, int particles_per_cell, double kh, double courant) {
  auto const [S, s, Q] = lattice_mode(transfer, particles_per_cell, kh);
  // rows v, u, dt a; u' and v' are linear in them
  Eigen::RowVector3d const u(1, s, -1);
  Eigen::RowVector3d const v = transfer.alpha * Eigen::RowVector3d(1, 0, -S) + (1 - transfer.alpha) * S * u;
  Eigen::RowVector3d const straining = transfer.maps_back ? Eigen::RowVector3d(v + s * u) : u;
  Eigen::Matrix3d step;
  step << v, u, Eigen::RowVector3d(0, 0, 1) + courant * courant * Q * straining;
  std::complex<double> found = 0;
  Eigen::VectorXcd const factors = eigenvalues_of(step);
  for (std::complex<double> const factor : factors)
    if (factor.imag() > found.imag()) found = factor;
  return found;
}

}  // namespace talus::reference
