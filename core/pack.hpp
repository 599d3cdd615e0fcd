#pragma once
/// A fixed number of doubles that are computed with together (SIMD), on the compilers' vector extensions.
///
/// A pack behaves as a number: the arithmetic operators, `select`, and the functions below act lane by lane.
/// Comparisons give a mask. A lane's result never depends on its neighbours.

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>

namespace talus {

/// Doubles in one register (256 bits). A longer pack is two of half its length: handed a vector longer than the
/// machine's registers, g++ 12 takes comparisons and choices apart lane by lane, which costs a law two to four times
/// its time.
inline constexpr int register_lanes = 4;

/// Compiler vectors of N doubles and of N 64-bit integers (the masks that comparisons give).
template <int N>
struct VectorExtension;
template <>
struct VectorExtension<2> {
  typedef double Value __attribute__((vector_size(16)));
  typedef long long Mask __attribute__((vector_size(16)));
};
template <>
struct VectorExtension<4> {
  typedef double Value __attribute__((vector_size(32)));
  typedef long long Mask __attribute__((vector_size(32)));
};
/// N truth values.
template <int N>
struct Mask {
  Mask<N / 2> low, high;

  [[nodiscard]] bool operator[](int lane) const { return lane < N / 2 ? low[lane] : high[lane - N / 2]; }
  friend Mask operator&(Mask a, Mask b) { return {a.low & b.low, a.high & b.high}; }
  friend Mask operator|(Mask a, Mask b) { return {a.low | b.low, a.high | b.high}; }
  friend Mask operator!(Mask a) { return {!a.low, !a.high}; }
  friend Mask operator&&(Mask a, Mask b) { return a & b; }
  friend Mask operator||(Mask a, Mask b) { return a | b; }
};

/// In one register all bits of a lane are set where it is true.
template <int N>
requires(N <= register_lanes) struct Mask<N> {
  typename VectorExtension<N>::Mask bits;

  [[nodiscard]] bool operator[](int lane) const { return bits[lane] != 0; }
  friend Mask operator&(Mask a, Mask b) { return {a.bits & b.bits}; }
  friend Mask operator|(Mask a, Mask b) { return {a.bits | b.bits}; }
  friend Mask operator!(Mask a) { return {~a.bits}; }
  friend Mask operator&&(Mask a, Mask b) { return {a.bits & b.bits}; }
  friend Mask operator||(Mask a, Mask b) { return {a.bits | b.bits}; }
};

/// N doubles.
template <int N>
struct alignas(8 * N) Pack {
  using Half = Pack<N / 2>;
  static constexpr int size = N;

  Half low, high;

  Pack() = default;
  Pack(Half l, Half h) : low(l), high(h) {}
  Pack(double s) : low(s), high(s) {}  // NOLINT: a number is a pack of equal lanes
  static Pack load(double const* p) { return {Half::load(p), Half::load(p + N / 2)}; }
  void store(double* p) const {
    low.store(p);
    high.store(p + N / 2);
  }

  [[nodiscard]] double operator[](int lane) const { return lane < N / 2 ? low[lane] : high[lane - N / 2]; }
  void set(int lane, double s) { lane < N / 2 ? low.set(lane, s) : high.set(lane - N / 2, s); }

  friend Pack operator+(Pack a, Pack b) { return {a.low + b.low, a.high + b.high}; }
  friend Pack operator-(Pack a, Pack b) { return {a.low - b.low, a.high - b.high}; }
  friend Pack operator*(Pack a, Pack b) { return {a.low * b.low, a.high * b.high}; }
  friend Pack operator/(Pack a, Pack b) { return {a.low / b.low, a.high / b.high}; }
  friend Pack operator-(Pack a) { return {-a.low, -a.high}; }
  Pack& operator+=(Pack b) { return *this = *this + b; }
  Pack& operator-=(Pack b) { return *this = *this - b; }
  Pack& operator*=(Pack b) { return *this = *this * b; }
  Pack& operator/=(Pack b) { return *this = *this / b; }

  friend Mask<N> operator<(Pack a, Pack b) { return {a.low < b.low, a.high < b.high}; }
  friend Mask<N> operator>(Pack a, Pack b) { return {a.low > b.low, a.high > b.high}; }
  friend Mask<N> operator<=(Pack a, Pack b) { return {a.low <= b.low, a.high <= b.high}; }
  friend Mask<N> operator>=(Pack a, Pack b) { return {a.low >= b.low, a.high >= b.high}; }
  friend Mask<N> operator==(Pack a, Pack b) { return {a.low == b.low, a.high == b.high}; }
  friend Mask<N> operator!=(Pack a, Pack b) { return {a.low != b.low, a.high != b.high}; }
};

/// N doubles in one register.
template <int N>
requires(N <= register_lanes) struct alignas(8 * N) Pack<N> {
  using Value = typename VectorExtension<N>::Value;
  static constexpr int size = N;

  Value value;

  Pack() = default;
  explicit Pack(Value v) : value(v) {}
  Pack(double s) : value(Value{} + s) {}  // NOLINT: a number is a pack of equal lanes
  static Pack load(double const* p) {
    Pack r;
    __builtin_memcpy(&r.value, p, sizeof(Value));
    return r;
  }
  void store(double* p) const { __builtin_memcpy(p, &value, sizeof(Value)); }

  [[nodiscard]] double operator[](int lane) const { return value[lane]; }
  void set(int lane, double s) { value[lane] = s; }

  friend Pack operator+(Pack a, Pack b) { return Pack(a.value + b.value); }
  friend Pack operator-(Pack a, Pack b) { return Pack(a.value - b.value); }
  friend Pack operator*(Pack a, Pack b) { return Pack(a.value * b.value); }
  friend Pack operator/(Pack a, Pack b) { return Pack(a.value / b.value); }
  friend Pack operator-(Pack a) { return Pack(-a.value); }
  Pack& operator+=(Pack b) { return *this = *this + b; }
  Pack& operator-=(Pack b) { return *this = *this - b; }
  Pack& operator*=(Pack b) { return *this = *this * b; }
  Pack& operator/=(Pack b) { return *this = *this / b; }

  friend Mask<N> operator<(Pack a, Pack b) { return {a.value < b.value}; }
  friend Mask<N> operator>(Pack a, Pack b) { return {a.value > b.value}; }
  friend Mask<N> operator<=(Pack a, Pack b) { return {a.value <= b.value}; }
  friend Mask<N> operator>=(Pack a, Pack b) { return {a.value >= b.value}; }
  friend Mask<N> operator==(Pack a, Pack b) { return {a.value == b.value}; }
  friend Mask<N> operator!=(Pack a, Pack b) { return {a.value != b.value}; }
};

/// Lanes of the packs in which particles are stored and computed.
inline constexpr int lanes = 8;
using Lanes = Pack<lanes>;

template <int N>
bool any(Mask<N> m) {
  if constexpr (N > register_lanes) {
    return any(m.low | m.high);
  } else {
    long long r = 0;
    for (int i = 0; i < N; ++i) r |= m.bits[i];
    return r != 0;
  }
}
template <int N>
bool all(Mask<N> m) {
  return !any(!m);
}

template <int N>
Pack<N> select_lanes(Mask<N> m, Pack<N> a, Pack<N> b) {
  if constexpr (N > register_lanes) {
    return {select_lanes(m.low, a.low, b.low), select_lanes(m.high, a.high, b.high)};
  } else {
    return Pack<N>(m.bits ? a.value : b.value);
  }
}

/// Applies a function of one number to every lane; for functions that no hot path calls.
template <int N, class F>
Pack<N> lane_by_lane(Pack<N> a, F f) {
  if constexpr (N > register_lanes) {
    return {lane_by_lane(a.low, f), lane_by_lane(a.high, f)};
  } else {
    Pack<N> r;
    for (int i = 0; i < N; ++i) r.value[i] = f(a.value[i]);
    return r;
  }
}

template <int N>
Pack<N> sqrt(Pack<N> a) {
  return lane_by_lane(a, [](double s) { return __builtin_sqrt(s); });
}
template <int N>
Pack<N> abs(Pack<N> a) {
  return select_lanes(a < Pack<N>(0.0), -a, a);
}
template <int N>
Pack<N> min(Pack<N> a, Pack<N> b) {
  return select_lanes(b < a, b, a);
}
template <int N>
Pack<N> max(Pack<N> a, Pack<N> b) {
  return select_lanes(a < b, b, a);
}
/// Largest whole number not above a; lane by lane.
template <int N>
Pack<N> floor(Pack<N> a) {
  return lane_by_lane(a, [](double s) { return __builtin_floor(s); });
}
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
  constexpr double c[] = {
      1.0 / 6227020800, 1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040,
      1.0 / 720,        1.0 / 120,       1.0 / 24,       1.0 / 6,       0.5,          1.0,         1.0};
  P poly(c[0]);
  for (int i = 1; i < 14; ++i) poly = poly * r + P(c[i]);
  P const scaled = poly * power_of_two(shifted);
  P const high = select_lanes(a > P(709.0), P(std::numeric_limits<double>::infinity()), scaled);
  P const low = select_lanes(a < P(-708.0), P(0.0), high);
  return select_lanes(a == a, low, a);
}

/// Largest lane.
template <int N>
double horizontal_max(Pack<N> a) {
  double r = a[0];
  for (int i = 1; i < N; ++i) r = a[i] > r ? a[i] : r;
  return r;
}

/// True in every lane that holds a finite number.
template <int N>
Mask<N> is_finite(Pack<N> a) {
  return abs(a) <= Pack<N>(std::numeric_limits<double>::max());
}

}  // namespace talus
