#include "verification/reference/linear_algebra.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace talus::reference {

Eigen::VectorXcd eigenvalues_of(Eigen::MatrixXd const& A) {
  return A.eigenvalues();
}

Eigen::VectorXd least_squares(Eigen::MatrixXd const& A, Eigen::VectorXd const& b) {
  return A.colPivHouseholderQr().solve(b);
}

Eigen::MatrixXd logarithm(Eigen::MatrixXd const& A) {
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> const solver(A);
  Eigen::MatrixXd const& axes = solver.eigenvectors();
  return axes * solver.eigenvalues().array().log().matrix().asDiagonal() * axes.transpose();
}

}  // namespace talus::reference
