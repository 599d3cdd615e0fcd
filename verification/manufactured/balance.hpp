#pragma once
/// What a motion x = phi(X, t) is, and the body force that makes it the solution, by automatic differentiation.
///
///   F = dphi/dX,   v = dphi/dt,   a = d^2 phi/dt^2,   L = F_t F^-1                                       (1)
///   rho_0 b = rho_0 a - Div P,   P = tau F^-T,   tau = tau(1/2 ln (F F^T))                               (2)
///
/// A motion is written once, over a scalar; nested duals give (1) and dF/dX in one evaluation. tau is the solver's own
/// law: (2) says nothing of whether the law is right, for which the closed forms of verification/exact are there.

#include <Eigen/LU>

#include "core/dual_sine.hpp"
#include "verification/manufactured/logarithm.hpp"

namespace talus::manufactured {

/// A motion says where the particle that was at X is at time t, over any scalar.
template <class M>
concept MotionOfPoints = requires(M const motion, Vector<Dual<2>, M::dimension> const& X, Dual<2> const& t) {
  { motion.position(X, t) } -> std::same_as<Vector<Dual<2>, M::dimension>>;
};

/// A particle of a motion at one time.
template <int D>
struct MovedPoint {
  Point<D> x, v, a;                  ///< [m], [m/s], [m/s^2]
  Eigen::Matrix<double, D, D> F, L;  ///< [1], [1/s]
};

/// A number and its derivatives by X and t; twice for second ones.
template <int D>
using First = Dual<D + 1>;
template <int D>
using Second = Dual<D + 1, First<D>>;

/// phi at (X, t) with its first and second derivatives.
template <MotionOfPoints M>
Vector<Second<M::dimension>, M::dimension> differentiated(M const& motion, Point<M::dimension> const& X, double t) {
  constexpr int D = M::dimension;
  auto const unknown = [](double value, int k) { return Second<D>::variable(First<D>::variable(value, k), k); };
  Vector<Second<D>, D> from;
  for (int i = 0; i < D; ++i) from[static_cast<std::size_t>(i)] = unknown(X[i], i);
  return motion.position(from, unknown(t, D));
}

/// (1).
template <MotionOfPoints M>
MovedPoint<M::dimension> moved(M const& motion, Point<M::dimension> const& X, double t) {
  constexpr int D = M::dimension;
  auto const x = differentiated(motion, X, t);
  MovedPoint<D> point;
  for (int i = 0; i < D; ++i) {
    Second<D> const& own = x[static_cast<std::size_t>(i)];
    point.x[i] = own.value.value;
    point.v[i] = own.value.derivative(D);
    point.a[i] = own.derivative(D).derivative(D);
    for (int j = 0; j < D; ++j) {
      point.F(i, j) = own.value.derivative(j);
      point.L(i, j) = own.derivative(j).derivative(D);
    }
  }
  point.L *= point.F.inverse().eval();
  return point;
}

/// The shape of strain and stress of a motion in D dimensions.
template <int D>
using ShapeOf = std::conditional_t<D == 2, shape::Plane, shape::Solid>;

/// 1/2 ln (F F^T).
template <class T, int D>
Symmetric<T, ShapeOf<D>> hencky_strain(Matrix<T, D> const& F) {
  auto const ln_b = logarithm(product(F, transposed(F)));
  Symmetric<T, ShapeOf<D>> strain;
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j) strain(i, j) = T(0.5) * ln_b(i, j);
  return strain;
}

/// Div P [N/m^3] of (2), and its terms' sum of magnitudes, which errors are measured by.
template <class Law, MotionOfPoints M>
Point<M::dimension> stress_divergence(Law const& law, M const& motion, Point<M::dimension> const& X, double t) {
  constexpr int D = M::dimension;
  auto const x = differentiated(motion, X, t);
  Matrix<First<D>, D> F, tau;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) F(i, j) = x[static_cast<std::size_t>(i)].derivative(j);
  auto const stress = law.stress(hencky_strain(F));
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) tau(i, j) = stress(i, j);
  auto const P = product(tau, transposed(inverse(F)));
  Point<D> divergence = Point<D>::Zero();
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) divergence[i] += P(i, j).derivative(j);
  return divergence;
}

/// b [m/s^2] of (2).
template <class Law, MotionOfPoints M>
Point<M::dimension> body_force(Law const& law, double density, M const& motion, Point<M::dimension> const& X,
                               double t) {
  return moved(motion, X, t).a - stress_divergence(law, motion, X, t) / density;
}

}  // namespace talus::manufactured
