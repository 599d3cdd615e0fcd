#pragma once
/// Small vectors, matrices and symmetric tensors over any scalar, and the split into volume and deviator.
///
/// Signs (docs/conventions.md): stress and strain are positive in tension; the pressure p is positive in compression.

#include <Eigen/Core>
#include <array>

#include "core/scalar.hpp"

namespace talus {

/// A point or a direction in D dimensions, in doubles: geometry outside the kernels.
template <int D>
using Point = Eigen::Matrix<double, D, 1>;

template <class T, int D>
using Vector = std::array<T, static_cast<std::size_t>(D)>;

/// A D by D matrix, row by row: m(i, j).
template <class T, int D>
struct Matrix {
  std::array<T, static_cast<std::size_t>(D* D)> entries{};
  T& operator()(int i, int j) { return entries[static_cast<std::size_t>(i * D + j)]; }
  T const& operator()(int i, int j) const { return entries[static_cast<std::size_t>(i * D + j)]; }
};

/// The shapes that a symmetric tensor takes: `normals` entries on the diagonal come first (xx, yy, zz), then `shears`
/// (xy | xy, xz, yz). `normals` is the space dimension d_s of the invariants, `plane` the dimension of the motion.
namespace shape {
struct Plane {  ///< everything lives in the plane: d_s = 2 (reduced plane strain)
  static constexpr int normals = 2, shears = 1, plane = 2;
};
struct PlaneStrain {  ///< motion in the plane, strain and stress also across it: d_s = 3
  static constexpr int normals = 3, shears = 1, plane = 2;
};
struct Solid {  ///< three dimensions
  static constexpr int normals = 3, shears = 3, plane = 3;
};
}  // namespace shape

/// Symmetric tensor of a shape: xx, yy[, zz], xy[, xz, yz].
template <class T, class Shape>
struct Symmetric {
  static constexpr int normals = Shape::normals, shears = Shape::shears, size = normals + shears;
  std::array<T, static_cast<std::size_t>(size)> entries{};

  T& operator[](int k) { return entries[static_cast<std::size_t>(k)]; }
  T const& operator[](int k) const { return entries[static_cast<std::size_t>(k)]; }

  /// Position of the entry (i, j) among `entries`.
  static constexpr int index(int i, int j) { return i == j ? i : normals + i + j - 1; }
  [[nodiscard]] T const& operator()(int i, int j) const { return (*this)[index(i, j)]; }
  T& operator()(int i, int j) { return (*this)[index(i, j)]; }

  friend Symmetric operator+(Symmetric a, Symmetric const& b) {
    for (int k = 0; k < size; ++k) a[k] = a[k] + b[k];
    return a;
  }
  friend Symmetric operator-(Symmetric a, Symmetric const& b) {
    for (int k = 0; k < size; ++k) a[k] = a[k] - b[k];
    return a;
  }
  friend Symmetric operator*(T s, Symmetric a) {
    for (int k = 0; k < size; ++k) a[k] = s * a[k];
    return a;
  }
};

/// s I.
template <class Shape, class T>
Symmetric<T, Shape> isotropic(T s) {
  Symmetric<T, Shape> r;
  for (int k = 0; k < Shape::normals; ++k) r[k] = s;
  for (int k = Shape::normals; k < r.size; ++k) r[k] = T(0.0);
  return r;
}

template <class T, class Shape>
T trace(Symmetric<T, Shape> const& a) {
  T sum = a[0];
  for (int k = 1; k < Shape::normals; ++k) sum = sum + a[k];
  return sum;
}

/// a : b.
template <class T, class Shape>
T contract(Symmetric<T, Shape> const& a, Symmetric<T, Shape> const& b) {
  T normal = a[0] * b[0];
  for (int k = 1; k < Shape::normals; ++k) normal = normal + a[k] * b[k];
  T shear = a[Shape::normals] * b[Shape::normals];
  for (int k = Shape::normals + 1; k < a.size; ++k) shear = shear + a[k] * b[k];
  return normal + T(2.0) * shear;
}

/// a - tr(a)/d_s I.
template <class T, class Shape>
Symmetric<T, Shape> deviator(Symmetric<T, Shape> const& a) {
  return a - isotropic<Shape>(T(trace(a) * T(1.0 / Shape::normals)));
}

/// ||a|| = sqrt(a : a).
template <class T, class Shape>
T norm(Symmetric<T, Shape> const& a) {
  return sqrt(contract(a, a));
}

/// Pressure p = -tr(tau)/d_s [Pa], positive in compression.
template <class T, class Shape>
T pressure(Symmetric<T, Shape> const& tau) {
  return trace(tau) * T(-1.0 / Shape::normals);
}

/// Shear stress q = ||dev tau||/sqrt(2) [Pa]: |tau_xy| in simple shear.
template <class T, class Shape>
T shear_stress(Symmetric<T, Shape> const& tau) {
  auto const s = deviator(tau);
  return sqrt(T(0.5) * contract(s, s));
}

}  // namespace talus
