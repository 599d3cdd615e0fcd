#pragma once
/// exp and log of small symmetric tensors, as series; core/log_strain.hpp tells where they are used and how exact they
/// are. No principal values, no special case of equal stretches, and derivatives that exist at F = I.
///
/// A tensor is split into a I + D, D traceless. In the plane D^2 is a multiple of I, so that only functions of numbers
/// remain; in space D^3 = j2 D + j3 I (Cayley and Hamilton), and polynomials are summed in the ring {I, D, D^2}. That
/// takes a third less than Horner's rule for Y itself, and half of its dependent steps.
/// Source: Higham (2008), Functions of Matrices, ch. 1, doi:10.1137/1.9780898717778.

#include <array>
#include <cstddef>

#include "core/tensor.hpp"

namespace talus {

/// Largest norm ||Y|| of a tensor whose exponential or logarithm is summed as a polynomial. Beyond it the principal
/// values are used.
inline constexpr double polynomial_limit = 0.1;

namespace detail {

/// 1/k!, k = 1 ... 11: the relative remainder at ||Y|| = 0.1 is 1e-11/12!, far below one unit in the last place.
inline constexpr std::array<double, 11> expm1_terms = [] {
  std::array<double, 11> c{};
  double factorial = 1;
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = 1 / (factorial *= static_cast<double>(k + 1));
  return c;
}();

/// (-1)^(k+1)/k, k = 1 ... 16: the relative remainder at ||Y|| = 0.1 is 1e-16/17.
inline constexpr std::array<double, 16> log1p_terms = [] {
  std::array<double, 16> c{};
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = (k % 2 == 0 ? 1.0 : -1.0) / static_cast<double>(k + 1);
  return c;
}();

/// sum_k c_k y^k, k = 1 ... n.
template <class T, std::size_t n>
[[gnu::always_inline]] inline T polynomial(T const& y, std::array<double, n> const& c) {
  T r = T(c[n - 1]);
  for (std::size_t k = n - 1; k-- > 0;) r = r * y + T(c[k]);
  return r * y;
}

/// 1/(2k + j)!, k = 0 ... 5: sinh(s)/s in powers of s^2 for j = 1, (cosh(s) - 1)/s^2 for j = 2.
template <std::size_t j>
inline constexpr std::array<double, 6> cosh_terms = [] {
  std::array<double, 6> c{};
  double factorial = j;
  for (std::size_t k = 0; k < c.size(); ++k) {
    c[k] = 1 / factorial;
    factorial *= static_cast<double>((2 * k + j + 1) * (2 * k + j + 2));
  }
  return c;
}();

/// 1/(2k + 1), k = 0 ... 8: atanh(z)/z in powers of z^2.
inline constexpr std::array<double, 9> atanh_terms = [] {
  std::array<double, 9> c{};
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = 1 / static_cast<double>(2 * k + 1);
  return c;
}();

/// sum_k c_k y^k, k = 0 ... n - 1.
template <class T, std::size_t n>
[[gnu::always_inline]] inline T series(T const& y, std::array<double, n> const& c) {
  T r = T(c[n - 1]);
  for (std::size_t k = n - 1; k-- > 0;) r = r * y + T(c[k]);
  return r;
}

/// The traceless part of a tensor, and what it obeys: D^3 = j2 D + j3 I.
template <class T>
struct Traceless {
  Symmetric<T, shape::Solid> d;
  T j2, j3;
};
template <class T>
[[gnu::always_inline]] inline Traceless<T> traceless(Symmetric<T, shape::Solid> const& y, T const& mean) {
  Traceless<T> r{y, T(0.0), T(0.0)};
  for (int i = 0; i < 3; ++i) r.d(i, i) = y(i, i) - mean;
  T const xx = r.d(0, 0), yy = r.d(1, 1), zz = r.d(2, 2), xy = r.d(0, 1), xz = r.d(0, 2), yz = r.d(1, 2);
  r.j2 = T(0.5) * (xx * xx + yy * yy + zz * zz) + (xy * xy + xz * xz + yz * yz);
  r.j3 = xx * (yy * zz - yz * yz) + xy * (yz * xz - xy * zz) + xz * (xy * yz - xz * yy);
  return r;
}

/// shift I + factor (c_1 D + ... + c_n D^n), by Horner's rule in the ring {I, D, D^2}.
template <class T, std::size_t n>
[[gnu::always_inline]] inline Symmetric<T, shape::Solid> polynomial(Traceless<T> const& y,
                                                                    std::array<double, n> const& c, T const& factor,
                                                                    T const& shift) {
  T of_1 = T(c[n - 3]), of_d = T(c[n - 2]), of_dd = T(c[n - 1]);
  for (std::size_t k = n - 2; k-- > 0;) {
    T const lead = of_dd;
    of_dd = of_d;
    of_d = of_1 + y.j2 * lead;
    of_1 = k > 0 ? T(T(c[k - 1]) + y.j3 * lead) : T(y.j3 * lead);
  }
  of_1 = shift + factor * of_1, of_d = factor * of_d, of_dd = factor * of_dd;
  T const xx = y.d(0, 0), yy = y.d(1, 1), zz = y.d(2, 2), xy = y.d(0, 1), xz = y.d(0, 2), yz = y.d(1, 2);
  Symmetric<T, shape::Solid> r;
  r(0, 0) = of_1 + of_d * xx + of_dd * (xx * xx + xy * xy + xz * xz);
  r(1, 1) = of_1 + of_d * yy + of_dd * (xy * xy + yy * yy + yz * yz);
  r(2, 2) = of_1 + of_d * zz + of_dd * (xz * xz + yz * yz + zz * zz);
  r(0, 1) = of_d * xy + of_dd * (xy * (xx + yy) + xz * yz);
  r(0, 2) = of_d * xz + of_dd * (xz * (xx + zz) + xy * yz);
  r(1, 2) = of_d * yz + of_dd * (yz * (yy + zz) + xy * xz);
  return r;
}

/// expm1(Y) of a small Y.
template <class T>
[[gnu::always_inline]] inline T small_expm1(T const& y) {
  return polynomial(y, expm1_terms);
}
/// In the plane: Y = a I + D, D^2 = r I;  exp(Y) = e^a (cosh sqrt(r) I + sinh sqrt(r)/sqrt(r) D).
template <class T>
[[gnu::always_inline]] inline Symmetric<T, shape::Plane> small_expm1(Symmetric<T, shape::Plane> const& y) {
  T const a = T(0.5) * (y(0, 0) + y(1, 1)), d = T(0.5) * (y(0, 0) - y(1, 1)), r = d * d + y(0, 1) * y(0, 1);
  T const grown = polynomial(a, expm1_terms), cosh1 = r * series(r, cosh_terms<2>);
  T const of_1 = grown + cosh1 + grown * cosh1, of_d = (T(1.0) + grown) * series(r, cosh_terms<1>);
  return {{of_1 + of_d * d, of_1 - of_d * d, of_d * y(0, 1)}};
}
/// In space: Y = a I + D;  exp(Y) = e^a exp(D).
template <class T>
[[gnu::always_inline]] inline Symmetric<T, shape::Solid> small_expm1(Symmetric<T, shape::Solid> const& y) {
  T const a = T(1.0 / 3.0) * trace(y), grown = polynomial(a, expm1_terms);
  return polynomial(traceless(y, a), expm1_terms, T(T(1.0) + grown), grown);
}

/// 1/2 log1p(X) of a small X.
template <class T>
[[gnu::always_inline]] inline T half_small_log1p(T const& x) {
  return T(0.5) * polynomial(x, log1p_terms);
}
/// In the plane: I + X = (1 + a) I + D, D^2 = r I, of determinant 1 + m;
///   1/2 log = 1/2 atanh(z) I + 1/2 atanh(s)/s D/(1 + a),  z = m/(2 + m),  s^2 = r/(1 + a)^2.
template <class T>
[[gnu::always_inline]] inline Symmetric<T, shape::Plane> half_small_log1p(Symmetric<T, shape::Plane> const& x) {
  T const a = T(0.5) * (x(0, 0) + x(1, 1)), d = T(0.5) * (x(0, 0) - x(1, 1)), r = d * d + x(0, 1) * x(0, 1);
  T const one_a = T(1.0) + a, m = a + a * one_a - r, two_m = T(2.0) + m;
  T const quotient = T(1.0) / (two_m * one_a);
  T const z = m * one_a * quotient, scale = two_m * quotient;
  T const of_1 = T(0.5) * z * series(T(z * z), atanh_terms);
  T const of_d = T(0.5) * scale * series(T(r * scale * scale), atanh_terms);
  return {{of_1 + of_d * d, of_1 - of_d * d, of_d * x(0, 1)}};
}
/// In space: I + X = (1 + a) (I + D/(1 + a));  log1p(a) = 2 atanh(a/(2 + a)).
template <class T>
[[gnu::always_inline]] inline Symmetric<T, shape::Solid> half_small_log1p(Symmetric<T, shape::Solid> const& x) {
  T const a = T(1.0 / 3.0) * trace(x), one_a = T(1.0) + a, two_a = T(2.0) + a;
  T const quotient = T(1.0) / (one_a * two_a), z = a * one_a * quotient;
  Symmetric<T, shape::Solid> scaled = x;
  for (int e = 0; e < scaled.size; ++e) scaled[e] = two_a * quotient * x[e];
  return polynomial(traceless(scaled, T(a * two_a * quotient)), log1p_terms, T(0.5),
                    T(z * series(T(z * z), atanh_terms)));
}

}  // namespace detail

}  // namespace talus
