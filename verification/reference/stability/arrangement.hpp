#pragma once
/// The longest stable step of a few elastic particles in free space, by the eigenvalues of the step as a matrix.
///
/// The step is linear in the particles' velocities v_p, their affine velocities C_p and what their velocity gradients
/// sum up to, e_p, while displacements are small against a cell:
///
///   v_i   = sum_p m_p N_ip (v_p + C_p (x_i - x_p)) / m_i,   m_i = sum_p m_p N_ip                                   (1)
///   v_i'  = v_i - dt sum_p V_p tau(e_p) grad N_ip / m_i                                                            (2)
///   v_p'  = alpha (v_p - sum_i N_ip v_i) + sum_i N_ip v_i',   C_p' = sum_i N_ip v_i' (x_i - x_p)^T / D             (3)
///   e_p'  = e_p + dt sum_i v_i' grad N_ip                                                                          (4)
///   tau   = lambda tr(e) I + G (e + e^T)
///
/// Lengths in cells h, masses and volumes of particles alike, density 1, E = 1: a step is given as dt sqrt(E/rho)/h.
/// The columns of the matrix are what (1) to (4) make of unit states.
///
/// Derived here.

#include <Eigen/Core>
#include <vector>

#include "verification/reference/lattice_modes.hpp"

namespace talus::reference {

/// Particles by their places in cells, along 1, 2 or 3 axes.
struct Arrangement {
  std::vector<Eigen::VectorXd> places;
  std::vector<double> masses;
  double nu = 0.3;
};

/// The matrix of (1) to (4).
[[nodiscard]] Eigen::MatrixXd step_matrix(Arrangement const& particles, Transfer const& transfer, double dt);

/// The largest modulus of its eigenvalues.
[[nodiscard]] double growth_of_a_step(Arrangement const& particles, Transfer const& transfer, double dt);

/// The eigenvalue 1 of what no node sees is defective: rounding makes that much of it.
inline constexpr double defect = 1e-6;

/// The longest dt sqrt(E/rho)/h with no eigenvalue beyond 1 + defect, by bisection.
[[nodiscard]] double longest_step(Arrangement const& particles, Transfer const& transfer);

/// The place in a cell, from a node on, at which sum_i N'_i^2/N_i is largest along an axis.
[[nodiscard]] double sharpest_place(int degree);

}  // namespace talus::reference
