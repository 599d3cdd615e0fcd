#pragma once
/// The elastic logarithmic strain, and what one step of motion makes of it.
///
///   eps = 1/2 ln b,   b_tr = (I + H) b (I + H)^T,   H = dt L                                             (1)
///   B = b - I = expm1(2 eps)                                                                             (2)
///   eps_tr = 1/2 log1p(X),   X = B + H + H^T + H B + B H^T + H H^T + H B H^T                             (3)
///
/// Neither b nor F is ever formed, so that strains of 1e-12 keep all their digits. Both functions are their Taylor
/// polynomials, summed in the ring {I, Y, Y^2} by the Cayley-Hamilton theorem: no principal values, no division, no
/// special case of equal stretches, and derivatives that exist at F = I. Where ||Y|| > 0.1, in the lanes where it is,
/// the function is taken of the principal values instead.
///
/// Accuracy (in double, norm of the error over the norm of the result; s: length of the interval that holds 0 and the
/// principal strains of eps and eps_tr): 6e-16 by the polynomials, 2e-15 beyond them up to s = 1, 1e-14 at s = 2, and
/// e^(2 s) 1e-16 from there on, for then rounding of the largest entry of b blurs its smallest principal value. The
/// result is finite for |eps| < 170 and finite H as long as b stays below 1e150: a principal strain is never below
/// -18.4 = 1/2 ln 2^-53. Digits are gone at s = 18; a caller refuses a state long before (s = 9 leaves 1e-9).
/// A caller also sees to det(I + H) > 0: b does not tell a reflection.
/// Source: update (1): Simo & Meschke (1993), Comput. Mech. 11, 253-278, doi:10.1007/BF00371865; functions of matrices:
/// Higham (2008), Functions of Matrices, ch. 1, doi:10.1137/1.9780898717778.

#include "core/spectral.hpp"

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

/// sum_k c_k Y^k in the plane: Y^2 = tr(Y) Y - det(Y) I.
template <class T, std::size_t n>
[[gnu::always_inline]] inline Symmetric<T, shape::Plane> polynomial(Symmetric<T, shape::Plane> const& y,
                                                                    std::array<double, n> const& c) {
  T const trace = y(0, 0) + y(1, 1), det = y(0, 0) * y(1, 1) - y(0, 1) * y(0, 1);
  T of_1 = T(c[n - 2]), of_y = T(c[n - 1]);
  for (std::size_t k = n - 1; k-- > 0;) {
    T const lead = of_y;
    of_y = trace * lead + of_1;
    of_1 = T(k > 0 ? c[k - 1] : 0.0) - det * lead;
  }
  return {{of_1 + of_y * y(0, 0), of_1 + of_y * y(1, 1), of_y * y(0, 1)}};
}

/// sum_k c_k Y^k in space: Y^3 = I1 Y^2 - I2 Y + I3 I.
template <class T, std::size_t n>
[[gnu::always_inline]] inline Symmetric<T, shape::Solid> polynomial(Symmetric<T, shape::Solid> const& y,
                                                                    std::array<double, n> const& c) {
  T const xx = y(0, 0), yy = y(1, 1), zz = y(2, 2), xy = y(0, 1), xz = y(0, 2), yz = y(1, 2);
  T const minor_x = yy * zz - yz * yz, minor_y = xx * zz - xz * xz, minor_z = xx * yy - xy * xy;
  T const i1 = xx + yy + zz, i2 = minor_x + minor_y + minor_z;
  T const i3 = xx * minor_x + xy * (yz * xz - xy * zz) + xz * (xy * yz - xz * yy);
  T of_1 = T(c[n - 3]), of_y = T(c[n - 2]), of_yy = T(c[n - 1]);
  for (std::size_t k = n - 2; k-- > 0;) {
    T const lead = of_yy;
    of_yy = i1 * lead + of_y;
    of_y = of_1 - i2 * lead;
    of_1 = i3 * lead + T(k > 0 ? c[k - 1] : 0.0);
  }
  Symmetric<T, shape::Solid> r;
  r(0, 0) = of_1 + of_y * xx + of_yy * (xx * xx + xy * xy + xz * xz);
  r(1, 1) = of_1 + of_y * yy + of_yy * (xy * xy + yy * yy + yz * yz);
  r(2, 2) = of_1 + of_y * zz + of_yy * (xz * xz + yz * yz + zz * zz);
  r(0, 1) = of_y * xy + of_yy * (xy * (xx + yy) + xz * yz);
  r(0, 2) = of_y * xz + of_yy * (xz * (xx + zz) + xy * yz);
  r(1, 2) = of_y * yz + of_yy * (yz * (yy + zz) + xy * xz);
  return r;
}

inline constexpr auto expm1_of = [](auto const& x) { return expm1(x); };

/// log1p, but not below ln 2^-53 = -36.7: what rounding made of a positive 1 + x stays finite.
inline constexpr auto log1p_of = [](auto const& x) {
  using T = std::remove_cvref_t<decltype(x)>;
  return log1p(max(x, T(-1 + 0.5 * std::numeric_limits<double>::epsilon())));
};

template <class T, class F>
[[gnu::noinline]] T by_principal_values(T y, F f) {
  return f(y);
}
template <class T, class Shape, class F>
[[gnu::noinline]] Symmetric<T, Shape> by_principal_values(Symmetric<T, Shape> y, F f) {
  return isotropic_function(y, f);
}

/// f(y) by its polynomial, lane by lane by the principal values where y is too large.
template <class T, std::size_t n, class F>
[[gnu::always_inline]] inline T analytic(T const& y, std::array<double, n> const& terms, F f) {
  T r = polynomial(y, terms);
  auto const large = abs(y) > T(polynomial_limit);
  if (any(large)) [[unlikely]]
    r = select<T>(large, by_principal_values(y, f), r);
  return r;
}
template <class T, class Shape, std::size_t n, class F>
[[gnu::always_inline]] inline Symmetric<T, Shape> analytic(Symmetric<T, Shape> const& y,
                                                           std::array<double, n> const& terms, F f) {
  Symmetric<T, Shape> r = polynomial(y, terms);
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
    return across_plane<T>(expm1_twice(in_plane(eps)),
                           detail::analytic(T(T(2.0) * eps[2]), detail::expm1_terms, detail::expm1_of));
  } else {
    return detail::analytic(T(2.0) * eps, detail::expm1_terms, detail::expm1_of);
  }
}

/// 1/2 log1p(x) [1]: the logarithmic strain of b = I + x, of its entry across the plane too.
template <class T, class Shape>
[[nodiscard, gnu::always_inline]] inline Symmetric<T, Shape> log_strain(Symmetric<T, Shape> const& x) {
  if constexpr (Shape::normals > Shape::plane) {
    return across_plane<T>(log_strain(in_plane(x)),
                           T(0.5) * detail::analytic(x[2], detail::log1p_terms, detail::log1p_of));
  } else {
    return T(0.5) * detail::analytic(x, detail::log1p_terms, detail::log1p_of);
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
