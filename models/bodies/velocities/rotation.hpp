#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/config/parameters.hpp"
#include "core/coordinates.hpp"
#include "core/errors.hpp"
#include "core/tensor.hpp"

namespace talus::body {

/// Rotation as a rigid body about an axis through a centre, counter-clockwise where the axis points at the observer.
///
///   v(x) = omega a x (x - x_0),  |a| = 1            (1)
///
/// In the plane the axis is z.
struct Rotation {
  static constexpr std::string_view name = "rotation", title = "Rigid rotation", source = "elementary kinematics";
  static constexpr bool supports(int D) { return D == 2 || D == 3; }

  struct Parameters {
    double angular_velocity = 0;
    Coordinates centre{0, 0, 0};
    std::vector<double> axis{0, 0, 1};
    static constexpr auto table() {
      return std::tuple{
          parameter(&Parameters::angular_velocity, "angular_velocity", "omega", "rad/s", "angular velocity").required(),
          parameter(&Parameters::centre, "centre", "x_0", "m", "a point on the axis").per_axis(),
          parameter(&Parameters::axis, "axis", "a", "1",
                    "direction of the axis, always with three entries; z in the plane")
              .sized(3, 3)};
    }
    static std::optional<std::string> check(Parameters const& p) {
      if (p.axis.size() != 3) return "the axis must have three entries";
      double const length = std::hypot(p.axis[0], p.axis[1], p.axis[2]);
      if (!(length > 0 && length <= std::numeric_limits<double>::max()))
        return "the axis must have a finite length above 0";
      return std::nullopt;
    }
  };

  template <int D>
  class In {
   public:
    static constexpr int dimension = D;
    /// Throws InputError where the axis has no direction, or one other than z in the plane.
    explicit In(Parameters const& p) : centre_(to_point<D>(p.centre)) {
      if (auto const wrong = Parameters::check(p)) throw InputError("rotation: " + *wrong);
      if (!std::isfinite(p.angular_velocity)) throw InputError("rotation: the angular velocity must be finite");
      if (D == 2 && (p.axis[0] != 0 || p.axis[1] != 0)) throw InputError("rotation: in the plane the axis must be z");
      double const scale = p.angular_velocity / std::hypot(p.axis[0], p.axis[1], p.axis[2]);
      double const x = scale * p.axis[0], y = scale * p.axis[1], z = scale * p.axis[2];
      gradient_(0, 1) = -z;  // (1) as a matrix
      gradient_(1, 0) = z;
      if constexpr (D == 3) {
        gradient_(0, 2) = y;
        gradient_(2, 0) = -y;
        gradient_(1, 2) = -x;
        gradient_(2, 1) = x;
      }
    }
    /// (1) [m/s]
    [[nodiscard]] Point<D> velocity(Point<D> const& x) const {
      Point<D> v = Point<D>::Zero();
      for (int i = 0; i < D; ++i) {
        for (int j = 0; j < D; ++j) v[i] += gradient_(i, j) * (x[j] - centre_[j]);
      }
      return v;
    }
    /// dv_i/dx_j [1/s]
    [[nodiscard]] Matrix<double, D> gradient(Point<D> const& /*x*/) const { return gradient_; }

   private:
    Point<D> centre_;
    Matrix<double, D> gradient_;
  };
};

}  // namespace talus::body
