#pragma once
/// Random points, directions and frames, the same in every run.

#include <random>

#include "core/tensor.hpp"

namespace talus::test {

inline std::mt19937_64 generator;

inline double between(double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(generator);
}
template <int D>
Point<D> random_point(double low, double high) {
  Point<D> x;
  for (int i = 0; i < D; ++i) x[i] = between(low, high);
  return x;
}
template <int D>
Point<D> random_direction() {
  for (;;) {
    Point<D> const x = random_point<D>(-1, 1);
    if (x.norm() > 0.1 && x.norm() <= 1) return x.normalized();
  }
}
/// Columns of length 1 at right angles: a rotation, maybe with a reflection.
template <int D>
Eigen::Matrix<double, D, D> random_frame() {
  Eigen::Matrix<double, D, D> Q;
  for (int i = 0; i < D; ++i) {
    do {
      Q.col(i) = random_direction<D>();
      for (int twice = 0; twice < 2; ++twice)
        for (int j = 0; j < i; ++j) Q.col(i) -= Q.col(j).dot(Q.col(i)) * Q.col(j);
    } while (Q.col(i).norm() < 0.1);
    Q.col(i).normalize();
  }
  return Q;
}

}  // namespace talus::test
