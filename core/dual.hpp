#pragma once
/// Forward-mode dual numbers: a value and its exact derivatives with respect to N unknowns.
///
/// A function written over a Scalar, called with duals, returns its derivatives beside its value. Duals nest:
/// `Dual<N, Dual<N>>` gives second derivatives. Comparisons and `select` look at values alone.

#include <array>
#include <concepts>
#include <cstddef>

#include "core/scalar.hpp"

namespace talus {

/// value + gradient . e, where e_i e_j = 0.
template <int N, class T = double>
struct Dual {
  T value{};
  std::array<T, static_cast<std::size_t>(N)> gradient{};

  Dual() = default;
  Dual(double constant) : value(constant) {}  // NOLINT: a number is a dual that depends on nothing
  Dual(T constant)                            // NOLINT
      requires(!std::same_as<T, double>)
      : value(constant) {}

  /// The k-th unknown, at `value`.
  static Dual variable(T value, int k) {
    Dual r(value);
    r.gradient[static_cast<std::size_t>(k)] = T(1.0);
    return r;
  }
  /// A function of `a` that has there this value and this slope.
  static Dual chain(Dual const& a, T value, T slope) {
    Dual r(value);
    for (std::size_t k = 0; k < N; ++k) r.gradient[k] = slope * a.gradient[k];
    return r;
  }
  [[nodiscard]] T const& derivative(int k) const { return gradient[static_cast<std::size_t>(k)]; }

  friend Dual operator+(Dual a, Dual const& b) {
    a.value = a.value + b.value;
    for (std::size_t k = 0; k < N; ++k) a.gradient[k] = a.gradient[k] + b.gradient[k];
    return a;
  }
  friend Dual operator-(Dual a, Dual const& b) {
    a.value = a.value - b.value;
    for (std::size_t k = 0; k < N; ++k) a.gradient[k] = a.gradient[k] - b.gradient[k];
    return a;
  }
  friend Dual operator*(Dual const& a, Dual const& b) {
    Dual r(T(a.value * b.value));
    for (std::size_t k = 0; k < N; ++k) r.gradient[k] = a.value * b.gradient[k] + b.value * a.gradient[k];
    return r;
  }
  friend Dual operator/(Dual const& a, Dual const& b) {
    Dual r(T(a.value / b.value));
    for (std::size_t k = 0; k < N; ++k) r.gradient[k] = (a.gradient[k] - r.value * b.gradient[k]) / b.value;
    return r;
  }
  friend Dual operator-(Dual const& a) { return chain(a, -a.value, T(-1.0)); }
  Dual& operator+=(Dual const& b) { return *this = *this + b; }
  Dual& operator-=(Dual const& b) { return *this = *this - b; }
  Dual& operator*=(Dual const& b) { return *this = *this * b; }
  Dual& operator/=(Dual const& b) { return *this = *this / b; }

  friend auto operator<(Dual const& a, Dual const& b) { return a.value < b.value; }
  friend auto operator>(Dual const& a, Dual const& b) { return a.value > b.value; }
  friend auto operator<=(Dual const& a, Dual const& b) { return a.value <= b.value; }
  friend auto operator>=(Dual const& a, Dual const& b) { return a.value >= b.value; }
  friend auto operator==(Dual const& a, Dual const& b) { return a.value == b.value; }
  friend auto operator!=(Dual const& a, Dual const& b) { return a.value != b.value; }
};

/// Chooses the whole number, derivatives included, so that the derivatives of the branch not taken may be anything.
template <class Condition, int N, class T>
Dual<N, T> select_lanes(Condition condition, Dual<N, T> const& a, Dual<N, T> const& b) {
  Dual<N, T> r(select<T>(condition, a.value, b.value));
  for (std::size_t k = 0; k < N; ++k) r.gradient[k] = select<T>(condition, a.gradient[k], b.gradient[k]);
  return r;
}

template <int N, class T>
Dual<N, T> abs(Dual<N, T> const& a) {
  return select<Dual<N, T>>(a.value < T(0.0), -a, a);
}
template <int N, class T>
Dual<N, T> min(Dual<N, T> const& a, Dual<N, T> const& b) {
  return select<Dual<N, T>>(b.value < a.value, b, a);
}
template <int N, class T>
Dual<N, T> max(Dual<N, T> const& a, Dual<N, T> const& b) {
  return select<Dual<N, T>>(a.value < b.value, b, a);
}

/// At 0 the slope is infinite, but an argument that does not vary gives a root that does not: the norm of a tensor is
/// flat where the tensor vanishes.
template <int N, class T>
Dual<N, T> sqrt(Dual<N, T> const& a) {
  T const root = sqrt(a.value);
  T const slope = T(0.5) / root;
  Dual<N, T> r(root);
  for (std::size_t k = 0; k < N; ++k)
    r.gradient[k] = select<T>(a.gradient[k] == T(0.0) && root == T(0.0), T(0.0), T(slope * a.gradient[k]));
  return r;
}
template <int N, class T>
Dual<N, T> exp(Dual<N, T> const& a) {
  T const e = exp(a.value);
  return Dual<N, T>::chain(a, e, e);
}
template <int N, class T>
Dual<N, T> expm1(Dual<N, T> const& a) {
  return Dual<N, T>::chain(a, expm1(a.value), exp(a.value));
}
template <int N, class T>
Dual<N, T> log(Dual<N, T> const& a) {
  return Dual<N, T>::chain(a, log(a.value), T(1.0) / a.value);
}
template <int N, class T>
Dual<N, T> log1p(Dual<N, T> const& a) {
  return Dual<N, T>::chain(a, log1p(a.value), T(1.0) / (T(1.0) + a.value));
}
template <int N, class T>
Dual<N, T> sinh(Dual<N, T> const& a) {
  return Dual<N, T>::chain(a, sinh(a.value), cosh(a.value));
}
template <int N, class T>
Dual<N, T> cosh(Dual<N, T> const& a) {
  return Dual<N, T>::chain(a, cosh(a.value), sinh(a.value));
}
template <int N, class T>
Dual<N, T> asinh(Dual<N, T> const& a) {
  return Dual<N, T>::chain(a, asinh(a.value), T(1.0) / sqrt(T(T(1.0) + a.value * a.value)));
}

/// True where the value and every derivative are finite.
template <int N, class T>
auto is_finite(Dual<N, T> const& a) {
  auto finite = is_finite(a.value);
  for (T const& slope : a.gradient) finite = finite && is_finite(slope);
  return finite;
}

static_assert(Scalar<Dual<3>> && Scalar<Dual<3, Dual<3>>> && Scalar<Dual<2, Lanes>>);

}  // namespace talus
