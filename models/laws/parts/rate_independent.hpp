#pragma once

#include <algorithm>
#include <tuple>

#include "core/config/parameters.hpp"
#include "models/laws/parts/ellipse.hpp"
#include "models/laws/parts/fields.hpp"

namespace talus::law {

/// Shear stress that does not depend on the rate of shear: the friction coefficient is M.
struct RateIndependent {
  static constexpr bool rate_dependent = false, dissipative = true;
  using Derived = Fields<field::Friction>;

  struct Parameters {
    double M = 0.381863;  // tan 20.9 deg
    static constexpr auto table() {
      return std::tuple{
          parameter(&Parameters::M, "M", "M", "1", "slope q/p of the critical-state line without cohesion",
                    non_negative),
      };
    }
  };

  double M;
  explicit RateIndependent(Parameters const& p) : M(p.M) {}

  /// Slope of the yield surface. Where it is 0 the ellipse is all but flat and the material a frictionless fluid.
  [[nodiscard]] double slope() const { return std::max(M, least_slope); }
  /// Shear stress at the end of the step [Pa]: the yield stress.
  template <Scalar T>
  [[nodiscard]] T relax(T /*q_tr*/, EllipsePoint<T> const& at, double /*G*/, T /*dt*/) const {
    return T(slope()) * at.S;
  }
  template <Scalar T>
  [[nodiscard]] T friction(T /*q*/, EllipsePoint<T> const& /*at*/) const {
    return T(M);
  }
  template <Scalar T, class List>
  void derive(T q, EllipsePoint<T> const& at, Record<T, List>& derived) const {
    derived[field::friction] = friction(q, at);
  }
};

}  // namespace talus::law
