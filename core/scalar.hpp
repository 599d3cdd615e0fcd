#pragma once
/// What numerics may be written over: a double, a pack of doubles, a forward dual number.

#include <algorithm>
#include <cmath>
#include <concepts>

#include "core/pack_functions.hpp"

namespace talus {

// The functions of a plain number, so that `sqrt(x)` finds the right one for every scalar by its name alone.
using std::abs;
using std::asinh;
using std::cosh;
using std::exp;
using std::expm1;
using std::log;
using std::log1p;
using std::max;
using std::min;
using std::sinh;
using std::sqrt;

inline bool any(bool condition) {
  return condition;
}
inline bool all(bool condition) {
  return condition;
}
static_assert(__FINITE_MATH_ONLY__ == 0,
              "Talus refuses a fast-math build: non-finite states are found by what it forgets. Take -ffast-math, "
              "-Ofast or -ffinite-math-only out of the compiler's flags");
inline bool is_finite(double a) {
  return std::abs(a) <= std::numeric_limits<double>::max();
}

inline double select_lanes(bool condition, double a, double b) {
  return condition ? a : b;
}

/// `a` where the condition holds, `b` elsewhere. Both are evaluated, so both must be finite wherever they may be
/// dropped by a multiplication. Write the scalar out (`select<T>(q > 0, 1, x)`): the other arguments may then be plain
/// numbers.
template <class T, class Condition>
[[nodiscard]] T select(Condition condition, std::type_identity_t<T> a, std::type_identity_t<T> b) {
  return select_lanes(condition, a, b);
}

/// A number, a pack of numbers, or a forward dual number.
/// Semiregular, not regular: `==` of packs gives a mask.
template <class T>
concept Scalar = std::semiregular<T> && std::constructible_from<T, double> && requires(T a, T b, double c) {
  {T(a + b)};
  {T(a - b)};
  {T(a * b)};
  {T(a / b)};
  {T(-a)};
  {T(c * a)};
  { select<T>(a < b, a, b) } -> std::same_as<T>;
  { any(a < b) } -> std::same_as<bool>;
  {T(sqrt(a))};
  {T(exp(a))};
  {T(log(a))};
};

static_assert(Scalar<double> && Scalar<Lanes>);

}  // namespace talus
