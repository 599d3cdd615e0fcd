#pragma once

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/config/parameters.hpp"
#include "core/scalar.hpp"

namespace talus::law {

/// Strength and factor of a hardening law, and the range in which a strength is used.
///
///   1e-9 p_c0 <= p_c <= 10 K
///
/// (and no less than 1e-100 Pa). Below, a particle is loose: it keeps its plastic strain and carries next to nothing.
/// At the upper end it is taken as elastic: pressures of the order of the bulk modulus K are beyond any model of
/// grains.
struct Strength {
  struct Parameters {
    double p_c0 = 100, xi = 50;
    static constexpr auto table() {
      return std::tuple{
          parameter(&Parameters::p_c0, "p_c0", "p_c^0", "Pa", "initial compressive strength", positive),
          parameter(&Parameters::xi, "xi", "xi", "1", "hardening factor; 0: the strength stays as it is", non_negative),
      };
    }
  };

  double p_c0, xi;
  explicit Strength(Parameters const& p) : p_c0(p.p_c0), xi(p.xi) {}

  [[nodiscard]] double floor() const { return std::max(1e-9 * p_c0, 1e-100); }  // its square is a number
  [[nodiscard]] static double ceiling(double K) { return 10 * K; }

  template <Scalar T>
  [[nodiscard]] T limited(T p_c, double K) const {
    return max(T(floor()), min(T(ceiling(K)), p_c));
  }
  /// `slope` where the strength is free to change, 0 at the ends of its range.
  template <Scalar T>
  [[nodiscard]] T where_free(T slope, T p_c, double K) const {
    return select<T>(p_c > T(floor()) && p_c < T(ceiling(K)), slope, T(0.0));
  }
};

/// p_c = p_c0: perfectly plastic.
struct NoHardening : Strength {
  struct Parameters {
    double p_c0 = 100;
    static constexpr auto table() {
      return std::tuple{parameter(&Parameters::p_c0, "p_c0", "p_c^0", "Pa", "compressive strength", positive)};
    }
  };
  explicit NoHardening(Parameters const& p) : Strength({.p_c0 = p.p_c0, .xi = 0}) {}

  template <Scalar T>
  [[nodiscard]] T strength(T /*eps_V*/, double K) const {
    return limited(T(p_c0), K);
  }
  template <Scalar T>
  [[nodiscard]] T slope(T /*p_c*/, double /*K*/) const {
    return T(0.0);
  }
};

/// p_c = p_c0 exp(-xi eps_V^P).
///
/// eps_V^P [1]: plastic volumetric strain, positive in dilation; K [Pa]: bulk modulus, for the range alone.
/// Source: Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643.
struct ExponentialHardening : Strength {
  using Strength::Strength;

  template <Scalar T>
  [[nodiscard]] T strength(T eps_V, double K) const {
    return limited(T(p_c0 * exp(T(-xi * eps_V))), K);  // infinity and 0 are limited as well
  }
  /// dp_c/deps_V^P where the strength is p_c [Pa].
  template <Scalar T>
  [[nodiscard]] T slope(T p_c, double K) const {
    return where_free(T(-xi * p_c), p_c, K);
  }
};

/// p_c = K sinh(s + asinh(p_c0/K)) = p_c0 + 1/2 (h + p_c0)(e^s - 1) + 1/2 (h - p_c0)(1 - e^-s),
/// s = -xi eps_V^P,   h = sqrt(K^2 + p_c0^2).
///
/// For p_c0 << K all strength is lost after a dilation of p_c0/(K xi). Symbols as above.
/// Source: Gaume et al. (2018), doi:10.1038/s41467-018-05181-w.
struct HyperbolicSineHardening : Strength {
  using Strength::Strength;

  template <Scalar T>
  [[nodiscard]] T strength(T eps_V, double K) const {
    T const s = max(T(-20.0), min(T(60.0), T(-xi * eps_V)));  // both ends are beyond the range of p_c
    T const u = expm1(s), v = u / (u + T(1.0));               // e^s - 1, 1 - e^-s
    double const h = std::hypot(K, p_c0);
    return limited(T(p_c0 + 0.5 * (h + p_c0) * u + 0.5 * (h - p_c0) * v), K);
  }
  /// dp_c/deps_V^P = -xi sqrt(K^2 + p_c^2) where the strength is p_c [Pa].
  template <Scalar T>
  [[nodiscard]] T slope(T p_c, double K) const {
    return where_free(T(-xi * sqrt(T(p_c * p_c + T(K * K)))), p_c, K);
  }
};

/// A strength that does not change during a step.
template <Scalar T>
struct FrozenStrength {
  T p_c;
  [[nodiscard]] T strength(T /*eps_V*/, double /*K*/) const { return p_c; }
  [[nodiscard]] T slope(T /*p_c*/, double /*K*/) const { return T(0.0); }
};

/// Any hardening, taken explicitly: a step maps onto the surface of the strength before it, and the strength follows.
///
/// After the step the stress lies on the surface that was, and off the present one by what the strength changed, of
/// first order in the step. The law says so by `hardens_explicitly`.
template <class Hardening>
struct Explicit : Hardening {
  using Hardening::Hardening;
};

/// Whether a strength is frozen during a step.
template <class Hardening>
inline constexpr bool is_explicit = false;
template <class Hardening>
inline constexpr bool is_explicit<Explicit<Hardening>> = true;

/// Exponential hardening during one step, from what it was before: p_c = p_c,n exp(-xi (eps_V - eps_V,n)), of which a
/// few terms of the series are enough as long as the strength changes by a few per cent.
template <Scalar T>
struct ExponentialStep {
  ExponentialHardening const& hardening;
  T eps_V_n, p_c_n, near;  ///< near: the largest exponent that the series serves

  ExponentialStep(ExponentialHardening const& law, T eps_V, T p_c, double K)
      : hardening(law),
        eps_V_n(eps_V),
        p_c_n(p_c),
        near(select<T>(p_c > T(law.floor()) && p_c < T(law.ceiling(K)), series_limit, -1.0)) {}

  template <Scalar U>
  [[nodiscard]] U strength(U eps_V, double K) const {
    U const x = U(-hardening.xi) * (eps_V - eps_V_n);
    U const by_series = hardening.limited(U(p_c_n * series(x)), K);
    auto const far = abs(x) > U(near);
    if (any(far)) [[unlikely]]
      return select<U>(far, hardening.strength(eps_V, K), by_series);
    return by_series;
  }
  template <Scalar U>
  [[nodiscard]] U slope(U p_c, double K) const {
    return hardening.slope(p_c, K);
  }

 private:
  static constexpr double series_limit = 0.03;  ///< the first term left out is 2e-17

  template <Scalar U>
  [[nodiscard]] static U series(U x) {
    U const x2 = x * x;
    auto const pair = [&](double a, double b) { return U(a) + U(b) * x; };
    return U(1.0) + (x + x2 * (pair(1. / 2, 1. / 6) + x2 * (pair(1. / 24, 1. / 120) + x2 * pair(1. / 720, 1. / 5040))));
  }
};

/// The strength that a step ends with, as the state will tell it, to the last digit.
template <class Hardening, Scalar T>
[[nodiscard]] T strength_of_state(Hardening const& hardening, T eps_V, double K) {
  return hardening.strength(eps_V, K);
}
template <Scalar T>
[[nodiscard]] T strength_of_state(ExponentialStep<T> const& step, T eps_V, double K) {
  return step.hardening.strength(eps_V, K);
}

/// The strength as it is during a step that starts with eps_V and p_c: the hardening itself, or what serves as well.
template <class Hardening, Scalar T>
[[nodiscard]] Hardening const& during_step(Hardening const& hardening, T /*eps_V*/, T /*p_c*/, double /*K*/) {
  return hardening;
}
template <Scalar T>
[[nodiscard]] ExponentialStep<T> during_step(ExponentialHardening const& hardening, T eps_V, T p_c, double K) {
  return {hardening, eps_V, p_c, K};
}
template <class Hardening, Scalar T>
[[nodiscard]] FrozenStrength<T> during_step(Explicit<Hardening> const& /*hardening*/, T /*eps_V*/, T p_c,
                                            double /*K*/) {
  return {p_c};
}

}  // namespace talus::law
