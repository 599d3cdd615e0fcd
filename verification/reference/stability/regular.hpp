#pragma once
/// The longest stable step of a regular lattice of elastic particles that fills space (von Neumann's analysis).
///
/// In every cell, n^D particles of equal mass lie in rows along the axes, `offset` beyond the places (k + 1/2)/n of a
/// row. A Bloch wave a exp(i theta . i) of the nodes i comes back from the particles as a multiple of itself. With
/// W_p = sum_i N_ip exp(i theta . i) and so on for N (x_i - x_p) and grad N, and means over the particles of a cell,
///
///   S = <|W|^2>,   s = <|sum N (x_i - x_p) exp|^2>/D_p,   K = <lambda g* g^T + G (|g|^2 I + g g*^T)>,  g = sum grad N exp   (1)
///
/// and K's eigenvalues kappa stand for c^2 Q of verification/reference/lattice_modes.hpp (4), whose 3 x 3 matrix says what
/// becomes of each polarisation. The mode that bears the shortest step counts.
///
/// Lengths in cells, density 1, E = 1: a step is given as dt sqrt(E/rho)/h.
///
/// Derived here.

#include <array>

#include "verification/reference/lattice_modes.hpp"

namespace talus::reference {

struct RegularLattice {
  int dimension = 2;
  int per_axis = 2;                ///< n
  std::array<double, 3> offset{};  ///< in cells
  double nu = 0.3;
  int wavelength = 8;  ///< cells after which all waves repeat
};

/// The longest dt sqrt(E/rho)/h at which no Bloch wave grows.
[[nodiscard]] double longest_step(RegularLattice const& lattice, Transfer const& transfer);

}  // namespace talus::reference
