#pragma once
/// Elementary functions of packs, lane by lane.

#include <cmath>
#include <limits>

#include "core/pack.hpp"

namespace talus {

template <int N>
Pack<N> log(Pack<N> a) {
  return lane_by_lane(a, [](double s) { return std::log(s); });
}
template <int N>
Pack<N> log1p(Pack<N> a) {
  return lane_by_lane(a, [](double s) { return std::log1p(s); });
}
template <int N>
Pack<N> expm1(Pack<N> a) {
  return lane_by_lane(a, [](double s) { return std::expm1(s); });
}
template <int N>
Pack<N> sinh(Pack<N> a) {
  return lane_by_lane(a, [](double s) { return std::sinh(s); });
}
template <int N>
Pack<N> asinh(Pack<N> a) {
  return lane_by_lane(a, [](double s) { return std::asinh(s); });
}
template <int N>
Pack<N> cosh(Pack<N> a) {
  return lane_by_lane(a, [](double s) { return std::cosh(s); });
}

/// 2^k, where `shifted` is 1.5 * 2^52 + k: its low bits hold the whole number k.
template <int N>
Pack<N> power_of_two(Pack<N> shifted) {
  if constexpr (N > register_lanes) {
    return {power_of_two(shifted.low), power_of_two(shifted.high)};
  } else {
    using Bits = typename VectorExtension<N>::Mask;
    return Pack<N>(typename Pack<N>::Value((Bits(shifted.value) + 1023LL) << 52));
  }
}

/// exp to about one unit in the last place: 2^k exp(r), |r| <= ln(2)/2, exp(r) by its Taylor polynomial of degree 13.
/// Below -708 the result is 0, above 709 infinity; NaN stays NaN.
template <int N>
Pack<N> exp(Pack<N> a) {
  using P = Pack<N>;
  constexpr double log2e = 1.4426950408889634074, ln2_hi = 6.93147180369123816490e-01,
                   ln2_lo = 1.90821492927058770002e-10, shift = 6755399441055744.0;  // 1.5 * 2^52: rounds to integer
  P const x = max(P(-708.0), min(P(709.0), a));
  P const shifted = x * P(log2e) + P(shift);
  P const k = shifted - P(shift);
  P const r = (x - k * P(ln2_hi)) - k * P(ln2_lo);
  constexpr double c[] = {0.5,         1.0 / 6,      1.0 / 24,      1.0 / 120,      1.0 / 720,       1.0 / 5040,
                          1.0 / 40320, 1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
  // 1 + r + r^2 (...), the rest in pairs of pairs (Estrin), so that few operations wait for each other
  P const r2 = r * r, r4 = r2 * r2;
  auto const pair = [&](int i) { return P(c[i]) + P(c[i + 1]) * r; };
  auto const four = [&](int i) { return pair(i) + pair(i + 2) * r2; };
  P const poly = P(1.0) + (r + r2 * (four(0) + r4 * (four(4) + r4 * four(8))));
  P const scaled = poly * power_of_two(shifted);
  P const high = select_lanes(a > P(709.0), P(std::numeric_limits<double>::infinity()), scaled);
  P const low = select_lanes(a < P(-708.0), P(0.0), high);
  return select_lanes(a == a, low, a);
}

}  // namespace talus
