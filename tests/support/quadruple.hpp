#pragma once
/// The exponential and the logarithm of small matrices in quadruple precision (113 bits), without principal values: the
/// judge of what core/ computes in double. exp: Taylor after halving; log: repeated square roots, then Mercator's
/// series.

#include <cmath>
#include <utility>

#include "core/tensor.hpp"

namespace talus::quadruple {

__extension__ typedef __float128 Number;
template <int D>
using Square = Matrix<Number, D>;

template <int D>
Square<D> identity() {
  Square<D> r;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) r(i, j) = i == j ? 1 : 0;
  return r;
}
template <int D>
Square<D> product(Square<D> const& a, Square<D> const& b) {
  Square<D> r;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      r(i, j) = 0;
      for (int k = 0; k < D; ++k) r(i, j) += a(i, k) * b(k, j);
    }
  return r;
}
template <int D>
Square<D> transpose(Square<D> const& a) {
  Square<D> r;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) r(i, j) = a(j, i);
  return r;
}
/// x a + y b.
template <int D>
Square<D> combine(Number x, Square<D> a, Number y, Square<D> const& b) {
  for (std::size_t k = 0; k < a.entries.size(); ++k) a.entries[k] = x * a.entries[k] + y * b.entries[k];
  return a;
}
template <int D>
double norm(Square<D> const& a) {
  Number sum = 0;
  for (Number const x : a.entries) sum += x * x;
  return std::sqrt(static_cast<double>(sum));
}

/// Gauss-Jordan elimination with row exchange.
template <int D>
Square<D> inverse(Square<D> a) {
  Square<D> r = identity<D>();
  for (int c = 0; c < D; ++c) {
    int pivot = c;
    for (int i = c; i < D; ++i)
      if (std::abs(static_cast<double>(a(i, c))) > std::abs(static_cast<double>(a(pivot, c)))) pivot = i;
    for (int j = 0; j < D; ++j) {
      std::swap(a(c, j), a(pivot, j));
      std::swap(r(c, j), r(pivot, j));
    }
    Number const scale = 1 / a(c, c);
    for (int j = 0; j < D; ++j) {
      a(c, j) *= scale;
      r(c, j) *= scale;
    }
    for (int i = 0; i < D; ++i) {
      if (i == c) continue;
      Number const factor = a(i, c);
      for (int j = 0; j < D; ++j) {
        a(i, j) -= factor * a(c, j);
        r(i, j) -= factor * r(c, j);
      }
    }
  }
  return r;
}

template <int D>
Square<D> exp(Square<D> y) {
  int halvings = 0;
  for (; norm(y) > 0.01; ++halvings) y = combine<D>(0.5, y, 0, y);
  Square<D> r = identity<D>();
  for (int k = 20; k > 0; --k) r = combine<D>(1, identity<D>(), Number(1) / k, product(y, r));
  for (; halvings > 0; --halvings) r = product(r, r);
  return r;
}

/// Principal square root by the iteration of Denman & Beavers (1976).
template <int D>
Square<D> sqrt(Square<D> const& a) {
  Square<D> y = a, z = identity<D>();
  for (double change = 1; change > 1e-25 * norm(y);) {
    Square<D> const next = combine<D>(0.5, y, 0.5, inverse(z));
    z = combine<D>(0.5, z, 0.5, inverse(y));
    change = norm(combine<D>(1, next, -1, y));
    y = next;
  }
  return y;
}

template <int D>
Square<D> log(Square<D> a) {
  Number factor = 1;
  Square<D> x = combine<D>(1, a, -1, identity<D>());
  for (; norm(x) > 0.01; factor *= 2) {
    a = sqrt(a);
    x = combine<D>(1, a, -1, identity<D>());
  }
  Square<D> r = combine<D>(0, x, 0, x);
  for (int k = 20; k > 0; --k)
    r = product(x, combine<D>(1, r, (k % 2 == 1 ? Number(1) : Number(-1)) / k, identity<D>()));
  return combine<D>(factor, r, 0, r);
}

/// 1/2 ln((I + H) exp(2 eps) (I + H)^T) in the plane of the motion.
template <class Shape>
Square<Shape::plane> trial_strain(Symmetric<double, Shape> const& eps, Matrix<double, Shape::plane> const& H) {
  constexpr int D = Shape::plane;
  Square<D> E, F;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      E(i, j) = 2 * static_cast<Number>(eps(i, j));
      F(i, j) = static_cast<Number>(H(i, j)) + (i == j ? 1 : 0);
    }
  Square<D> const r = log(product(product(F, exp(E)), transpose(F)));
  return combine<D>(0.5, r, 0, r);
}

/// ||got - exact||/||exact|| in the plane of the motion.
template <class Shape>
double error(Symmetric<double, Shape> const& got, Square<Shape::plane> const& exact) {
  Square<Shape::plane> difference = exact;
  for (int i = 0; i < Shape::plane; ++i)
    for (int j = 0; j < Shape::plane; ++j) difference(i, j) -= static_cast<Number>(got(i, j));
  return norm(difference) / norm(exact);
}

}  // namespace talus::quadruple
