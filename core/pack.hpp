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

/// Compiler vectors of N doubles, in a register and as they lie among other doubles, and of N 64-bit integers (the
/// masks that comparisons give). A copy by memcpy would go through 128 bits, and the next load would wait for it.
template <int N>
struct VectorExtension;
template <>
struct VectorExtension<2> {
  typedef double Value __attribute__((vector_size(16)));
  typedef double InMemory __attribute__((vector_size(16), aligned(8), may_alias));
  typedef long long Mask __attribute__((vector_size(16)));
};
template <>
struct VectorExtension<4> {
  typedef double Value __attribute__((vector_size(32)));
  typedef double InMemory __attribute__((vector_size(32), aligned(8), may_alias));
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
  using InMemory = typename VectorExtension<N>::InMemory;
  static constexpr int size = N;

  Value value;

  Pack() = default;
  // Written out, because g++ copies an array of trivial structures through registers of 128 bits, and the next load of
  // the whole waits until those have reached the cache.
  Pack(Pack const& other) : value(other.value) {}
  Pack& operator=(Pack const& other) {
    value = other.value;
    return *this;
  }
  explicit Pack(Value v) : value(v) {}
  Pack(double s) : value(s - Value{}) {}  // NOLINT: a number is a pack of equal lanes; - 0 keeps every s as it is
  static Pack load(double const* p) { return Pack(*reinterpret_cast<InMemory const*>(p)); }
  void store(double* p) const { *reinterpret_cast<InMemory*>(p) = value; }

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

/// What fills a register. Long sums over few values are taken register by register, so that they stay in registers.
using Register = Pack<register_lanes>;
inline constexpr int registers = lanes / register_lanes;  ///< of a pack of particles
static_assert(registers == 2);

/// Register number r of a pack.
inline Register& part(Lanes& pack, int r) {
  return r == 0 ? pack.low : pack.high;
}
inline Register const& part(Lanes const& pack, int r) {
  return r == 0 ? pack.low : pack.high;
}

/// A value that is used many times and is to stay in its register: g++ would load it from memory at every use, as an
/// operand of the instruction. Nothing where there are no registers of its size; g++ tells so by the largest alignment.
template <int N>
[[gnu::always_inline]] inline Pack<N> in_register(Pack<N> value) {
  if constexpr (__BIGGEST_ALIGNMENT__ >= sizeof(value)) asm("" : "+v"(value.value));
  return value;
}

template <int N>
bool any(Mask<N> m) {
  if constexpr (N > register_lanes) {
    return any(m.low | m.high);
  } else {
    auto bits = m.bits;
    if constexpr (N == 4) bits |= __builtin_shufflevector(bits, bits, 2, 3, 0, 1);
    return (bits[0] | bits[1]) != 0;
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
/// Without the sign's bit: one instruction, where a choice takes three.
template <int N>
Pack<N> abs(Pack<N> a) {
  if constexpr (N > register_lanes) {
    return {abs(a.low), abs(a.high)};
  } else {
    using Bits = typename VectorExtension<N>::Mask;
    return Pack<N>(typename Pack<N>::Value(Bits(a.value) & std::numeric_limits<long long>::max()));
  }
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
/// Writes lanes that are whole numbers as such.
template <int N>
void store_whole(Pack<N> a, int* out) {
  if constexpr (N > register_lanes) {
    store_whole(a.low, out);
    store_whole(a.high, out + N / 2);
  } else {
    typedef int Whole __attribute__((vector_size(4 * N)));
    Whole const whole = __builtin_convertvector(a.value, Whole);
    __builtin_memcpy(out, &whole, sizeof(Whole));
  }
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
