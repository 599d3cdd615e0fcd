#pragma once
/// Sine and cosine of dual numbers: for motions that solutions are made of.

#include <cmath>

#include "core/dual.hpp"

namespace talus {

using std::cos;
using std::sin;

template <int N, class T>
Dual<N, T> sin(Dual<N, T> const& a);
template <int N, class T>
Dual<N, T> cos(Dual<N, T> const& a) {
  return Dual<N, T>::chain(a, cos(a.value), -sin(a.value));
}
template <int N, class T>
Dual<N, T> sin(Dual<N, T> const& a) {
  return Dual<N, T>::chain(a, sin(a.value), cos(a.value));
}

}  // namespace talus
