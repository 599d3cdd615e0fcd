#pragma once
/// Decompositions of matrices, by GSL, which has them compiled: Eigen's take the compiler seconds in every unit. All throw
/// std::runtime_error where the matrix is empty or not finite, and where GSL finds none.

#include <Eigen/Core>

namespace talus::reference {

/// Eigenvalues of a real square matrix, in no order.
[[nodiscard]] Eigen::VectorXcd eigenvalues_of(Eigen::MatrixXd const& A);

/// The x that makes |A x - b| least; A has at least as many rows as columns. Of several x one with as few entries other
/// than 0 as A has independent columns.
[[nodiscard]] Eigen::VectorXd least_squares(Eigen::MatrixXd const& A, Eigen::VectorXd const& b);

/// Logarithm of a symmetric positive definite matrix, by its eigenvalues.
[[nodiscard]] Eigen::MatrixXd logarithm(Eigen::MatrixXd const& A);

}  // namespace talus::reference
