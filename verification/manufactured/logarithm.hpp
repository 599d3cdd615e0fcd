#pragma once
/// Small matrices over any scalar, and the logarithm of a symmetric positive one: smooth everywhere, so that it may be
/// differentiated where principal values coincide.
///
///   ln b = 2^m ln b^(1/2^m),   ln c = 2 (Z + Z^3/3 + Z^5/5 + ...),   Z = (c - I)(c + I)^-1               (1)
///
/// Square roots: Denman & Beavers (1976), doi:10.1016/0096-3003(76)90020-5; (1): Higham (2008), Functions of Matrices,
/// ch. 11, doi:10.1137/1.9780898717778 (neither re-read). For principal values within 1/40 and 40.

#include "core/tensor.hpp"

namespace talus::manufactured {

template <class T, int D>
Matrix<T, D> product(Matrix<T, D> const& a, Matrix<T, D> const& b) {
  Matrix<T, D> c;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      for (int k = 0; k < D; ++k) c(i, j) = c(i, j) + a(i, k) * b(k, j);
  return c;
}

template <class T, int D>
Matrix<T, D> transposed(Matrix<T, D> const& a) {
  Matrix<T, D> c;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) c(i, j) = a(j, i);
  return c;
}

/// s a + r b.
template <class T, int D>
Matrix<T, D> combined(double s, Matrix<T, D> const& a, double r, Matrix<T, D> const& b) {
  Matrix<T, D> c;
  for (std::size_t k = 0; k < c.entries.size(); ++k) c.entries[k] = T(s) * a.entries[k] + T(r) * b.entries[k];
  return c;
}

template <class T, int D>
Matrix<T, D> identity() {
  Matrix<T, D> c;
  for (int i = 0; i < D; ++i) c(i, i) = T(1.0);
  return c;
}

/// By cofactors.
template <class T, int D>
Matrix<T, D> inverse(Matrix<T, D> const& a) {
  Matrix<T, D> c;
  if constexpr (D == 2) {
    T const det = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
    c(0, 0) = a(1, 1) / det;
    c(1, 1) = a(0, 0) / det;
    c(0, 1) = -a(0, 1) / det;
    c(1, 0) = -a(1, 0) / det;
  } else {
    auto const cofactor = [&](int i, int j) {
      int const p = (i + 1) % 3, q = (i + 2) % 3, r = (j + 1) % 3, s = (j + 2) % 3;
      return T(a(p, r) * a(q, s) - a(p, s) * a(q, r));
    };
    T const det = a(0, 0) * cofactor(0, 0) + a(0, 1) * cofactor(0, 1) + a(0, 2) * cofactor(0, 2);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) c(j, i) = cofactor(i, j) / det;
  }
  return c;
}

template <class T, int D>
Matrix<T, D> square_root(Matrix<T, D> const& a) {
  Matrix<T, D> root = a, reciprocal = identity<T, D>();
  for (int k = 0; k < 10; ++k) {
    Matrix<T, D> const next = combined(0.5, root, 0.5, inverse(reciprocal));
    reciprocal = combined(0.5, reciprocal, 0.5, inverse(root));
    root = next;
  }
  return root;
}

/// (1).
template <class T, int D>
Matrix<T, D> logarithm(Matrix<T, D> a) {
  constexpr int halvings = 4, terms = 10;
  for (int k = 0; k < halvings; ++k) a = square_root(a);
  auto const I = identity<T, D>();
  auto const Z = product(combined(1, a, -1, I), inverse(combined(1, a, 1, I))), square = product(Z, Z);
  Matrix<T, D> sum = combined(1.0 / (2 * terms + 1), I, 0, I);
  for (int k = terms - 1; k >= 0; --k) sum = combined(1, product(square, sum), 1.0 / (2 * k + 1), I);
  return combined(2 << halvings, product(Z, sum), 0, I);
}

}  // namespace talus::manufactured
