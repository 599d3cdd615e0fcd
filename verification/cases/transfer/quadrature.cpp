/// How far a lattice of particles under uniform stress is from equilibrium on the grid, along one axis.
///
/// A node feels sigma sum_p V_p N'(x_p), which is 0 for a continuum. With n particles a cell, n whole, it is 0 wherever
/// the lattice lies. With n half of an odd number it is, where the lattice lies worst,
///
///   eps_q = 1/n  (linear),   1/(2 n^2)  (quadratic),   1/(8 n^3)  (cubic)                                (1)
///
/// times sigma. That is why particles that have moved apart leave an error in the stress that no finer grid removes.
///
/// (1): with spacing s = h/n the trapezoidal sum of N' differs from its integral by its jumps in the (p - 1)th
/// derivative, s^p B_p(y)/p! for a jump at distance y s beyond a particle, B_p Bernoulli's polynomial. The (p + 2) knots'
/// jumps are those of a (p + 1)th difference, 2^p in all where n is half of an odd number and neighbours' y differ by
/// 1/2. Derived here.

#include <cmath>

#include "models/kernels/cubic.hpp"
#include "models/kernels/linear.hpp"
#include "models/kernels/quadratic.hpp"
#include "verification/suite/cases.hpp"

namespace talus::verification::transfer_quadrature {

namespace {

/// sum_p V_p N'(x_p) of the node in the middle; particles at (k + offset)/n, lengths in cells.
template <class Kernel>
double unbalance(double n, double offset) {
  constexpr int node = 8;
  double sum = 0;
  for (int k = 0; (k + offset) / n < 2 * node; ++k) {
    double const x = (k + offset) / n;
    auto const base = static_cast<int>(std::floor(x - Kernel::base_shift));
    if (node < base || node >= base + Kernel::width) continue;
    std::array<double, static_cast<std::size_t>(Kernel::width)> slopes;
    Kernel::slopes(x - base, slopes);
    sum += slopes[static_cast<std::size_t>(node - base)] / n;
  }
  return std::abs(sum);
}

template <class Kernel>
double worst(double n) {
  constexpr int offsets = 64;
  double most = 0;
  for (int k = 0; k < offsets; ++k) most = std::max(most, unbalance<Kernel>(n, double(k) / offsets));
  return most;
}

template <class Kernel>
void check_kernel(Findings& findings, double factor) {
  std::string const name(Kernel::name);
  double off = 0, whole = 0;
  for (double const n : {1.5, 2.5, 3.5, 4.5, 7.5}) {
    double const law = factor / std::pow(n, Kernel::degree);
    off = std::max(off, std::abs(worst<Kernel>(n) - law));
  }
  for (double const n : {1.0, 2.0, 3.0, 4.0, 8.0}) whole = std::max(whole, worst<Kernel>(n));
  findings.check(name, "largest distance from (1), n = 1.5 ... 7.5", off, at_most(1e-12), "(1) is exact");
  findings.check(name, "force under uniform stress, n = 1 ... 8", whole, at_most(1e-12), "a commensurate lattice");
}

void run(Findings& findings) {
  check_kernel<kernel::Linear>(findings, 1);
  check_kernel<kernel::Quadratic>(findings, 1. / 2);
  check_kernel<kernel::Cubic>(findings, 1. / 8);
}

}  // namespace

Case const the_case{"transfer/quadrature",
                    "A lattice of particles under uniform stress",
                    "1/n, 1/(2 n^2), 1/(8 n^3) for half-integer n; 0 for whole n",
                    "derived in the case's file",
                    0,
                    5,
                    run};

}  // namespace talus::verification::transfer_quadrature
