#pragma once
/// The elastic logarithmic strain, and what one step of motion makes of it.
///
///   eps = 1/2 ln b,   b_tr = (I + H) b (I + H)^T,   H = dt L                                             (1)
///   B = b - I = expm1(2 eps)                                                                             (2)
///   eps_tr = 1/2 log1p(X),   X = B + H + H^T + H B + B H^T + H H^T + H B H^T                             (3)
///
/// Neither b nor F is ever formed, so that strains of 1e-12 keep all their digits. Both functions are their Taylor
/// series (core/log_strain_series.hpp), without principal values. Where ||Y|| > 0.1, in the lanes where it is, the
/// function is taken of the principal values instead.
///
/// Accuracy (in double, norm of the error over the norm of the result; s: length of the interval that holds 0 and the
/// principal strains of eps and eps_tr): 6e-16 by the polynomials, 2e-15 beyond them up to s = 1, 1e-14 at s = 2, and
/// e^(2 s) 1e-16 from there on, for then rounding of the largest entry of b blurs its smallest principal value. The
/// result is finite for |eps| < 170 and finite H as long as b stays below 1e150: a principal strain is never below
/// -18.4 = 1/2 ln 2^-53. Digits are gone at s = 18; a caller refuses a state long before (s = 9 leaves 1e-9).
/// A caller also sees to det(I + H) > 0: b does not tell a reflection.
/// Source: update (1): Simo & Meschke (1993), Comput. Mech. 11, 253-278, doi:10.1007/BF00371865; functions of matrices:
/// Higham (2008), Functions of Matrices, ch. 1, doi:10.1137/1.9780898717778.

#include "core/log_strain_series.hpp"
#include "core/spectral.hpp"

namespace talus {

namespace detail {

inline constexpr struct Expm1 {
  template <class T>
  [[nodiscard]] T operator()(T const& x) const {
    return expm1(x);
  }
} expm1_of;

/// 1/2 log1p, but not below 1/2 ln 2^-53 = -18.4: what rounding made of a positive 1 + x stays finite.
inline constexpr struct HalfLog1p {
  template <class T>
  [[nodiscard]] T operator()(T const& x) const {
    return T(0.5) * log1p(max(x, T(-1 + 0.5 * std::numeric_limits<double>::epsilon())));
  }
} half_log1p_of;

template <class T, class F>
[[gnu::noinline]] T by_principal_values(T y, F f) {
  return f(y);
}
template <class T, class Shape, class F>
[[gnu::noinline]] Symmetric<T, Shape> by_principal_values(Symmetric<T, Shape> y, F f) {
  return isotropic_function(y, f);
}
// of the packs of a step: compiled in core/log_strain.cpp
template <class Shape>
using Strains = Symmetric<Lanes, Shape>;
extern template Strains<shape::Plane> by_principal_values(Strains<shape::Plane>, Expm1);
extern template Strains<shape::Plane> by_principal_values(Strains<shape::Plane>, HalfLog1p);
extern template Strains<shape::Solid> by_principal_values(Strains<shape::Solid>, Expm1);
extern template Strains<shape::Solid> by_principal_values(Strains<shape::Solid>, HalfLog1p);

/// The value for small y, in the lanes where y is not small f(y) by the principal values.
template <class T, class F>
[[gnu::always_inline]] inline T unless_large(T const& y, T const& small, F f) {
  auto const large = abs(y) > T(polynomial_limit);
  if (any(large)) [[unlikely]]
    return select<T>(large, by_principal_values(y, f), small);
  return small;
}
template <class T, class Shape, class F>
[[gnu::always_inline]] inline Symmetric<T, Shape> unless_large(Symmetric<T, Shape> const& y,
                                                               Symmetric<T, Shape> const& small, F f) {
  Symmetric<T, Shape> r = small;
  auto const large = contract(y, y) > T(polynomial_limit * polynomial_limit);
  if (any(large)) [[unlikely]] {
    Symmetric<T, Shape> const exact = by_principal_values(y, f);
    for (int e = 0; e < r.size; ++e) r[e] = select<T>(large, exact[e], r[e]);
  }
  return r;
}

}  // namespace detail

/// b - I = expm1(2 eps) [1] of (2), its entry across the plane too.
template <class T, class Shape>
[[nodiscard, gnu::always_inline]] inline Symmetric<T, Shape> expm1_twice(Symmetric<T, Shape> const& eps) {
  if constexpr (Shape::normals > Shape::plane) {
    return across_plane<T>(
        expm1_twice(in_plane(eps)),
        detail::unless_large(T(T(2.0) * eps[2]), detail::small_expm1(T(T(2.0) * eps[2])), detail::expm1_of));
  } else {
    Symmetric<T, Shape> const y = T(2.0) * eps;
    return detail::unless_large(y, detail::small_expm1(y), detail::expm1_of);
  }
}

/// 1/2 log1p(x) [1]: the logarithmic strain of b = I + x, of its entry across the plane too.
template <class T, class Shape>
[[nodiscard, gnu::always_inline]] inline Symmetric<T, Shape> log_strain(Symmetric<T, Shape> const& x) {
  if constexpr (Shape::normals > Shape::plane) {
    return across_plane<T>(log_strain(in_plane(x)),
                           detail::unless_large(x[2], detail::half_small_log1p(x[2]), detail::half_log1p_of));
  } else {
    return detail::unless_large(x, detail::half_small_log1p(x), detail::half_log1p_of);
  }
}

/// eps_tr [1] of (3), with H = dt L [1]: dt times the velocity gradient. In plane strain the entry across the plane
/// stays.
template <class T, class Shape>
[[nodiscard, gnu::always_inline]] inline Symmetric<T, Shape> trial_strain(Symmetric<T, Shape> const& eps,
                                                                          Matrix<T, Shape::plane> const& H) {
  if constexpr (Shape::normals > Shape::plane) {
    return across_plane<T>(trial_strain(in_plane(eps), H), eps[2]);
  } else {
    constexpr int D = Shape::plane;
    Symmetric<T, Shape> const B = expm1_twice(eps);
    Matrix<T, D> G;  // H b
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        G(i, j) = H(i, j);
        for (int k = 0; k < D; ++k) G(i, j) = G(i, j) + H(i, k) * B(k, j);
      }
    Symmetric<T, Shape> X;
    for (int i = 0; i < D; ++i)
      for (int j = i; j < D; ++j) {
        X(i, j) = B(i, j) + (G(i, j) + G(j, i));
        for (int k = 0; k < D; ++k) X(i, j) = X(i, j) + G(i, k) * H(j, k);
      }
    return log_strain(X);
  }
}

}  // namespace talus
