#pragma once

#include <tuple>

#include "core/config/parameters.hpp"
#include "models/laws/parts/hencky.hpp"
#include "models/laws/parts/slope.hpp"

namespace talus::law {

/// Viscosity of Duvaut and Lions: the stress relaxes within t_v towards its rate-independent projection.
///
///   d eps^P/dt = (1/t_v) C^-1 (tau - tau_bar)                                                        (1)
///   d eps^P    = d eps^P_bar/(1 + t_v/dt)         over a step, tau_bar and d eps^P_bar of the trial   (2)
///   gamma      = (q - q_bar)/(G t_v)              the shear part of (1)                               (3)
///
/// (2) is the implicit Euler step of (1): the points between the trial stress and its projection have the same
/// projection, also where the strength hardens with the flow. It acts on volume and shear alike, and not on shear alone
/// as an overstress does.
///
/// tau_bar [Pa]: projection without viscosity; C: elastic moduli; t_v [s]: time of relaxation.
/// Source: Duvaut & Lions (1972), Les inéquations en mécanique et en physique; Simo, Kennedy & Govindjee (1988),
/// doi:10.1002/nme.1620261003 (neither re-read); (2) derived here.
template <class Slope>
struct DuvautLions : Slope {
  static constexpr bool rate_dependent = true, shares_flow = true;
  using Derived = Unite<typename Slope::Derived, Fields<field::ShearRate>>;

  struct Parameters : Slope::Parameters {
    double t_v = 1e-3;
    static constexpr auto table() {
      return std::tuple_cat(Slope::Parameters::table(), std::tuple{parameter(&Parameters::t_v, "viscous_time", "t_v",
                                                                             "s", "time of relaxation", non_negative)});
    }
  };

  double t_v;
  explicit DuvautLions(Parameters const& p) : Slope(p), t_v(p.t_v) {}

  [[nodiscard]] bool viscous() const { return t_v > 0; }

  /// Shear stress of the projection [Pa].
  template <Scalar T>
  [[nodiscard]] T relax(T /*q_tr*/, EllipsePoint<T> const& at, double /*G*/, T /*dt*/) const {
    return T(this->slope()) * at.S;
  }
  /// p or q after (2).
  template <Scalar T>
  [[nodiscard]] T share(T trial, T flowed, T dt) const {
    return flowed + T(t_v) / (dt + T(t_v) + T(1e-300)) * (trial - flowed);
  }
  template <Scalar T>
  [[nodiscard]] T friction(T q, EllipsePoint<T> const& at) const {
    return apparent_friction(this->slope(), q, at);
  }
  /// The rate (3), where `at` is the projection.
  template <Scalar T, class List>
  void derive(T q, EllipsePoint<T> const& at, double G, Record<T, List>& derived) const {
    T const overstress = max(T(0.0), T(q - T(this->slope()) * at.S));
    derived[field::shear_rate] = t_v > 0 ? T(overstress * T(1 / (G * t_v))) : T(0.0);
    if constexpr (Derived::template holds<field::Friction>) derived[field::friction] = friction(q, at);
  }
};

}  // namespace talus::law
