#pragma once
/// A function of a symmetric matrix, by its eigenvalues.

#include <Eigen/Eigenvalues>

namespace talus::support {

inline Eigen::Matrix3d symmetric_function(Eigen::Matrix3d const& symmetric, double (*f)(double)) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> const solver(symmetric);
  Eigen::Matrix3d const& axes = solver.eigenvectors();
  return axes * solver.eigenvalues().unaryExpr(f).asDiagonal() * axes.transpose();
}
/// By the same solver, for Eigen's takes the compiler seconds for each size: with a third axis of its own, of like size.
inline Eigen::Matrix2d symmetric_function(Eigen::Matrix2d const& symmetric, double (*f)(double)) {
  Eigen::Matrix3d wider = Eigen::Matrix3d::Zero();
  wider.topLeftCorner<2, 2>() = symmetric;
  wider(2, 2) = symmetric(0, 0);
  return symmetric_function(wider, f).topLeftCorner<2, 2>();
}

}  // namespace talus::support
