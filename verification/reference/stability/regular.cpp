#include "verification/reference/stability/regular.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

#include "verification/reference/linear_algebra.hpp"
#include "verification/reference/stability/bisection.hpp"

namespace talus::reference {

namespace {

using Complex = std::complex<double>;

/// Along one axis: sums over the nodes of weight, weight times lever, and slope, times exp(i theta i).
struct AlongAxis {
  Complex weight, lever, slope;

  AlongAxis(int degree, double x, double theta) {
    for (int i = -5; i <= 5; ++i) {
      Complex const wave = std::polar(1.0, theta * i);
      weight += cardinal_spline(degree, x - i) * wave;
      lever += cardinal_spline(degree, x - i) * (i - x) * wave;
      slope += cardinal_spline_slope(degree, x - i) * wave;
    }
  }
};

/// Number k of a list with n values along each axis, by its places along the axes.
std::array<int, 3> places_of(int k, int n) {
  return {k % n, k / n % n, k / (n * n)};
}

int power(int n, int exponent) {
  return exponent == 0 ? 1 : n * power(n, exponent - 1);
}

/// S, s and the largest eigenvalue of K.
struct Wave {
  double S = 0, s = 0, kappa = 0;
};

Wave wave(RegularLattice const& lattice, int degree, std::array<int, 3> const& number) {
  int const D = lattice.dimension, n = lattice.per_axis, count = power(n, D);
  double const lambda = lattice.nu / ((1 + lattice.nu) * (1 - 2 * lattice.nu)), G = 0.5 / (1 + lattice.nu);
  Eigen::MatrixXcd K = Eigen::MatrixXcd::Zero(D, D);
  Wave sum;
  for (int p = 0; p < count; ++p) {
    std::vector<AlongAxis> axes;
    for (std::size_t d = 0; d < static_cast<std::size_t>(D); ++d)
      axes.emplace_back(degree, (places_of(p, n)[d] + 0.5) / n + lattice.offset[d],
                        2 * std::numbers::pi * number[d] / lattice.wavelength);
    Complex weight = 1;
    for (auto const& axis : axes) weight *= axis.weight;
    Eigen::VectorXcd g(D);
    for (int d = 0; d < D; ++d) {
      Complex lever = 1;
      g[d] = 1;
      for (int other = 0; other < D; ++other) {
        AlongAxis const& axis = axes[static_cast<std::size_t>(other)];
        lever *= other == d ? axis.lever : axis.weight;
        g[d] *= other == d ? axis.slope : axis.weight;
      }
      sum.s += std::norm(lever) * 12 / (degree + 1) / count;
    }
    sum.S += std::norm(weight) / count;
    Eigen::MatrixXcd const outer = g.conjugate() * g.transpose();
    K += (lambda * outer + G * (g.squaredNorm() * Eigen::MatrixXcd::Identity(D, D) + outer.transpose())) / count;
  }
  Eigen::MatrixXd in_real_numbers(2 * D, 2 * D);  // each eigenvalue twice
  in_real_numbers << K.real(), -K.imag(), K.imag(), K.real();
  sum.kappa = eigenvalues_of(in_real_numbers).real().maxCoeff();
  return sum;
}

/// Largest modulus of the eigenvalues of lattice_modes.hpp (4), k = dt^2 kappa.
double growth(Wave const& wave, Transfer const& transfer, double k) {
  double const s = transfer.affine ? wave.s : 0;
  Eigen::RowVector3d const u(1, s, -1);
  Eigen::RowVector3d const v = transfer.alpha * Eigen::RowVector3d(1, 0, -wave.S) + (1 - transfer.alpha) * wave.S * u;
  Eigen::RowVector3d const straining = transfer.maps_back ? Eigen::RowVector3d(v + s * u) : u;
  Eigen::Matrix3d step;
  step << v, u, Eigen::RowVector3d(0, 0, 1) + k * straining;
  return eigenvalues_of(step).cwiseAbs().maxCoeff();
}

}  // namespace

double longest_step(RegularLattice const& lattice, Transfer const& transfer) {
  double shortest = std::numeric_limits<double>::infinity();
  for (int k = 1; k < power(lattice.wavelength, lattice.dimension); ++k) {
    Wave const one = wave(lattice, transfer.degree, places_of(k, lattice.wavelength));
    if (one.kappa < 1e-9) continue;  // no node feels such a wave
    double const most =
        largest_where_true([&](double square) { return growth(one, transfer, square) <= 1 + 1e-6; }, 1e-3, 1e3, 1e-6);
    shortest = std::min(shortest, std::sqrt(most / one.kappa));
  }
  return shortest;
}

}  // namespace talus::reference
