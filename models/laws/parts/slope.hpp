#pragma once
/// What the slope of a yield surface in the (p, q) plane is made of: the factor that a surface gives to a rate law.

#include <algorithm>
#include <tuple>

#include "core/config/parameters.hpp"
#include "models/laws/parts/ellipse.hpp"
#include "models/laws/parts/fields.hpp"

namespace talus::law {

/// Most that a viscous law tells of q/S, where S vanishes.
inline constexpr double most_friction = 1e10;

/// M of the Cam-Clay ellipse, q_y = M S.
struct CriticalSlope {
  using Derived = Fields<field::Friction>;

  struct Parameters {
    double M = 0.381863;  // tan 20.9 deg
    static constexpr auto table() {
      return std::tuple{
          parameter(&Parameters::M, "M", "M", "1", "slope q/p of the critical-state line without cohesion",
                    non_negative)
              .usual(0, 3),
      };
    }
  };

  double M;
  explicit CriticalSlope(Parameters const& p) : M(p.M) {}
  /// Slope of the yield surface. Where it is 0 the ellipse is all but flat and the material a frictionless fluid.
  [[nodiscard]] double slope() const { return std::max(M, least_slope); }
};

/// M of the Drucker–Prager cone, q_y = M S, where S = p - p_tip is the pressure above that of the tip.
struct ConeSlope {
  using Derived = Fields<field::Friction>;

  struct Parameters {
    double M = 0.57735;  // tan 30 deg
    static constexpr auto table() {
      return std::tuple{
          parameter(&Parameters::M, "M", "M", "1", "slope of the yield line", positive).usual(0.01, 3),
      };
    }
  };

  double M;
  explicit ConeSlope(Parameters const& p) : M(p.M) {}
  [[nodiscard]] double slope() const { return M; }
};

/// Of a surface without friction, where S is the shear strength q_y itself.
struct UnitSlope {
  using Derived = Fields<>;
  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };
  explicit UnitSlope(Parameters const& /*p*/) {}
  [[nodiscard]] static double slope() { return 1; }
};

/// q/S of a viscous law: the slope where the material is elastic, and never more than `most_friction`.
template <Scalar T>
[[nodiscard]] T apparent_friction(double slope, T q, EllipsePoint<T> const& at) {
  T const S = max(T(at.S), T(1e-10 * q));
  return max(T(slope), min(T(most_friction), T(q / (S + T(1e-300)))));
}

}  // namespace talus::law
