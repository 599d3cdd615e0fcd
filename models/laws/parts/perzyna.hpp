#pragma once

#include <tuple>

#include "core/config/parameters.hpp"
#include "core/roots.hpp"
#include "models/laws/parts/hencky.hpp"
#include "models/laws/parts/slope.hpp"

namespace talus::law {

/// Perzyna's overstress in the form of Perić: the strength grows as a power of the shear rate.
///
///   q = q_y (1 + t_v gamma)^s                                                                         (1)
///   gamma = (q_tr - q)/(G dt)                                                  over a step             (2)
///
/// With z = q - q_y, O = q_tr - q_y and r = t_v/(G dt), (1) and (2) are
///
///   h(z) = ln(1 + z/q_y) - s ln(1 + r (O - z)) = 0,   h(0) <= 0 <= h(O),   h' > 0                      (3)
///   z = O q_y t_v/(G dt + q_y t_v)                                             for s = 1               (4)
///
/// so that there is one root and it is always bracketed; logarithms cannot overflow, whatever s and dt.
///
/// q, q_y [Pa]: shear stress and yield stress slope S. gamma [1/s]: plastic shear rate. t_v [s]: viscous time; the
/// viscosity of (4) is eta = q_y t_v. s [1]: exponent. Where q_y = 0 nothing is viscous.
///
/// Source: Perzyna (1966), doi:10.1016/S0065-2156(08)70009-7; form (1): Perić (1993), doi:10.1002/nme.1620360807 (not
/// re-read); (3) derived here.
template <class Slope>
struct Perzyna : Slope {
  static constexpr bool rate_dependent = true, shares_flow = false;
  using Derived = Unite<typename Slope::Derived, Fields<field::ShearRate>>;

  struct Parameters : Slope::Parameters {
    double t_v = 1e-3, s = 1;
    static constexpr auto table() {
      return std::tuple_cat(Slope::Parameters::table(),
                            std::tuple{
                                parameter(&Parameters::t_v, "viscous_time", "t_v", "s",
                                          "at the rate 1/t_v strength is 2^s times as high", non_negative),
                                parameter(&Parameters::s, "rate_exponent", "s", "1", "exponent of the rate", positive),
                            });
    }
  };

  double t_v, s;
  explicit Perzyna(Parameters const& p) : Slope(p), t_v(p.t_v), s(p.s) {}

  [[nodiscard]] bool viscous() const { return t_v > 0; }

  /// (3), (4).
  template <Scalar T>
  [[nodiscard]] T relax(T q_tr, EllipsePoint<T> const& at, double G, T dt) const {
    T const q_y = T(this->slope()) * at.S, O = max(T(0.0), T(q_tr - q_y));
    T const z = O * q_y * T(t_v) / (T(G) * dt + q_y * T(t_v) + T(least_stress));  // (4)
    return q_y + (s == 1 ? z : overstress(q_y, O, z, G, dt));
  }
  template <Scalar T>
  [[nodiscard]] T share(T /*trial*/, T flowed, T /*dt*/) const {
    return flowed;
  }
  template <Scalar T>
  [[nodiscard]] T friction(T q, EllipsePoint<T> const& at) const {
    return apparent_friction(this->slope(), q, at);
  }
  /// The rate (1) that the state tells of; 0 where it is elastic.
  template <Scalar T, class List>
  void derive(T q, EllipsePoint<T> const& at, double /*G*/, Record<T, List>& derived) const {
    T const q_y = max(T(T(this->slope()) * at.S), T(1e-12 * q)) + T(least_stress);
    T const power = min(T(200.0), T(log1p(max(T(0.0), T((q - q_y) / q_y))) * T(1 / s)));
    derived[field::shear_rate] = t_v > 0 ? T(expm1(power) * T(1 / t_v)) : T(0.0);
    if constexpr (Derived::template holds<field::Friction>) derived[field::friction] = friction(q, at);
  }

 private:
  /// r of (3) [1/Pa], finite also where dt is 0.
  template <Scalar T>
  [[nodiscard]] T rate_factor(double G, T dt) const {
    return min(T(1e250), T(T(t_v) / (T(G) * dt + T(least_stress))));
  }
  /// Root of (3), from the one for s = 1.
  template <Scalar T>
  [[nodiscard]] T overstress(T q_y, T O, T start, double G, T dt) const {
    T const r = rate_factor(G, dt), y = q_y + T(least_stress);
    auto const h = [&](T z) -> WithDerivative<T> {
      T const rest = r * max(T(0.0), T(O - z));
      return {log1p(T(z / y)) - T(s) * log1p(rest), T(1.0) / (y + z) + T(s) * r / (T(1.0) + rest)};
    };
    T const root = bracketed_newton<T>(h, T(0.0), O, start, T(1e-15) * (q_y + O)).x;
    return select<T>(q_y > T(0.0), root, 0.0);
  }
};

}  // namespace talus::law
