#pragma once
/// Principal values and directions of symmetric tensors, and functions of such tensors, for numbers, packs and duals.

#include "core/dual.hpp"
#include "core/tensor.hpp"

namespace talus {

/// Principal values, in no particular order, and the unit vectors that belong to them: column k of `directions`.
template <class T, class Shape>
struct Principal {
  Vector<T, Shape::normals> values;
  Matrix<T, Shape::normals> directions;
};

/// The in-plane block of a tensor in plane strain.
template <class T>
Symmetric<T, shape::Plane> in_plane(Symmetric<T, shape::PlaneStrain> const& a) {
  return {{a(0, 0), a(1, 1), a(0, 1)}};
}

/// The tensor of plane strain with this in-plane block and this entry across the plane.
template <class T>
Symmetric<T, shape::PlaneStrain> across_plane(Symmetric<T, shape::Plane> const& block, T zz) {
  return {{block(0, 0), block(1, 1), zz, block(0, 1)}};
}

namespace detail {

/// One rotation by the angle that makes a(p, q) vanish:
///   t = tan(angle) = sgn(d) h / (|d| + sqrt(d^2 + h^2)),  d = a_qq - a_pp,  h = 2 a_pq.
/// |t| <= 1 whatever the scale; t = 0 where h = 0.
template <int p, int q, class T, class Shape>
[[gnu::always_inline]] inline void rotate(Symmetric<T, Shape>& a, Matrix<T, Shape::normals>& v) {
  T const d = a(q, q) - a(p, p), h = T(2.0) * a(p, q);
  T const root = max(T(sqrt(T(d * d + h * h))), T(abs(h)));
  T const denominator = abs(d) + root + T(std::numeric_limits<double>::min());
  T const t = select<T>(d < T(0.0), -h, h) / denominator;
  T const c = T(1.0) / sqrt(T(T(1.0) + t * t)), s = t * c;
  T const shift = t * a(p, q);
  a(p, p) = a(p, p) - shift;
  a(q, q) = a(q, q) + shift;
  a(p, q) = T(0.0);
  if constexpr (Shape::shears == 3) {
    constexpr int r = 3 - p - q;
    T const rp = a(r, p), rq = a(r, q);
    a(r, p) = c * rp - s * rq;
    a(r, q) = s * rp + c * rq;
  }
  for (int i = 0; i < Shape::plane; ++i) {
    T const ip = v(i, p), iq = v(i, q);
    v(i, p) = c * ip - s * iq;
    v(i, q) = s * ip + c * iq;
  }
}

}  // namespace detail

/// Principal values and directions by cyclic Jacobi rotations: one in the plane, four sweeps of three in space.
///
/// No branch on data, so that packs take it as one number does; equal values are no special case. Error of values and
/// of the rebuilt tensor: a few units in the last place of the norm of a, at any size of a from 1e-150 to 1e150. Of
/// dual numbers: derivatives are finite only where the values are distinct; see `isotropic_function`. Source: Golub &
/// Van Loan (2013), Matrix Computations, 4th ed., section 8.5.
template <class T, class Shape>
[[nodiscard, gnu::always_inline]] inline Principal<T, Shape> principal(Symmetric<T, Shape> a) {
  constexpr int sweeps = 4;
  Principal<T, Shape> r;
  for (int i = 0; i < Shape::normals; ++i)
    for (int j = 0; j < Shape::normals; ++j) r.directions(i, j) = T(i == j ? 1.0 : 0.0);
  if constexpr (Shape::plane == 2) {
    detail::rotate<0, 1>(a, r.directions);
  } else {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      detail::rotate<0, 1>(a, r.directions);
      detail::rotate<0, 2>(a, r.directions);
      detail::rotate<1, 2>(a, r.directions);
    }
  }
  for (int k = 0; k < Shape::normals; ++k) r.values[static_cast<std::size_t>(k)] = a[k];
  return r;
}

/// sum_k f_k n_k n_k^T.
template <class T, class Shape>
[[gnu::always_inline]] inline Symmetric<T, Shape> rebuild(Vector<T, Shape::normals> const& f,
                                                          Matrix<T, Shape::normals> const& n) {
  Symmetric<T, Shape> r;
  for (int i = 0; i < Shape::plane; ++i)
    for (int j = i; j < Shape::plane; ++j) {
      r(i, j) = T(0.0);
      for (int k = 0; k < Shape::plane; ++k) r(i, j) = r(i, j) + f[static_cast<std::size_t>(k)] * (n(i, k) * n(j, k));
    }
  if constexpr (Shape::normals > Shape::plane) r[2] = f[2];
  return r;
}

/// f(a) = sum_k f(a_k) n_k n_k^T of a function f of one number, as exact as f is on numbers of the size of a.
///
/// \param f callable over any Scalar.
template <class T, class Shape, class F>
[[nodiscard, gnu::always_inline]] inline Symmetric<T, Shape> isotropic_function(Symmetric<T, Shape> const& a,
                                                                                F const& f) {
  if constexpr (Shape::normals > Shape::plane) {
    return across_plane<T>(isotropic_function(in_plane(a), f), f(a[2]));
  } else {
    Principal<T, Shape> const of_a = principal(a);
    Vector<T, Shape::normals> values;
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = f(of_a.values[k]);
    return rebuild<T, Shape>(values, of_a.directions);
  }
}

namespace detail {

/// m a m^T.
template <class T, class Shape>
Symmetric<T, Shape> turned(Matrix<T, Shape::plane> const& m, Symmetric<T, Shape> const& a) {
  constexpr int D = Shape::plane;
  Symmetric<T, Shape> r;
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j) {
      r(i, j) = T(0.0);
      for (int k = 0; k < D; ++k)
        for (int l = 0; l < D; ++l) r(i, j) = r(i, j) + m(i, k) * a(k, l) * m(j, l);
    }
  return r;
}

template <class T, int D>
Matrix<T, D> transpose(Matrix<T, D> const& m) {
  Matrix<T, D> r;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) r(i, j) = m(j, i);
  return r;
}

/// f[a, b] = (f(b) - f(a)) / (b - a); the mean of f' (Simpson's rule, error below 1e-12) where b is closer than 1e-3.
template <class T, class F>
T divided_difference(F const& f, T a, T b) {
  auto const at = [&f](T x) -> Dual<1, T> { return f(Dual<1, T>::variable(x, 0)); };
  Dual<1, T> const f_a = at(a), f_b = at(b), f_m = at(T(0.5) * (a + b));
  T const mean = (f_a.derivative(0) + T(4.0) * f_m.derivative(0) + f_b.derivative(0)) * T(1.0 / 6.0);
  auto const close = abs(T(b - a)) < T(1e-3);
  return select<T>(close, mean, (f_b.value - f_a.value) / select<T>(close, 1.0, b - a));
}

}  // namespace detail

/// f(a) of a tensor of dual numbers. Its derivatives are finite at equal principal values too:
///   n_i . df(a) n_j = f[a_i, a_j] n_i . da n_j,   f[x, y] = (f(y) - f(x)) / (y - x),  f[x, x] = f'(x).
/// Source: Higham (2008), Functions of Matrices, theorem 3.11 (of Daleckii and Krein), doi:10.1137/1.9780898717778.
template <int N, class T, class Shape, class F>
requires(Shape::normals == Shape::plane)
    [[nodiscard]] Symmetric<Dual<N, T>, Shape> isotropic_function(Symmetric<Dual<N, T>, Shape> const& a, F const& f) {
  Symmetric<T, Shape> value, ratio, change;
  for (int e = 0; e < value.size; ++e) value[e] = a[e].value;
  Principal<T, Shape> const of_a = principal(value);
  for (int i = 0; i < Shape::plane; ++i)
    for (int j = i; j < Shape::plane; ++j)
      ratio(i, j) = detail::divided_difference<T>(f, of_a.values[static_cast<std::size_t>(i)],
                                                  of_a.values[static_cast<std::size_t>(j)]);
  value = isotropic_function(value, f);
  Symmetric<Dual<N, T>, Shape> r;
  for (int e = 0; e < value.size; ++e) r[e].value = value[e];
  for (std::size_t k = 0; k < N; ++k) {
    for (int e = 0; e < value.size; ++e) change[e] = a[e].gradient[k];
    change = detail::turned(detail::transpose(of_a.directions), change);
    for (int e = 0; e < value.size; ++e) change[e] = ratio[e] * change[e];
    change = detail::turned(of_a.directions, change);
    for (int e = 0; e < value.size; ++e) r[e].gradient[k] = change[e];
  }
  return r;
}

}  // namespace talus
