#pragma once

#include <cmath>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/config/parameters.hpp"
#include "core/coordinates.hpp"
#include "core/errors.hpp"
#include "core/tensor.hpp"

namespace talus::body {

/// A velocity that is linear in the position: shear, stretching, any affine motion.
///
///   v(x) = v_0 + G (x - x_0)                        (1)
struct Linear {
  static constexpr std::string_view name = "linear", title = "Linear velocity field", source = "elementary kinematics";
  static constexpr bool supports(int D) { return D == 2 || D == 3; }

  struct Parameters {
    Coordinates velocity{0, 0, 0}, origin{0, 0, 0};
    std::vector<Coordinates> gradient{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    static constexpr auto table() {
      return std::tuple{parameter(&Parameters::velocity, "velocity", "v_0", "m/s", "velocity at the origin").per_axis(),
                        parameter(&Parameters::origin, "origin", "x_0", "m", "where the velocity is v_0").per_axis(),
                        parameter(&Parameters::gradient, "gradient", "G", "1/s",
                                  "gradient dv_i/dx_j, a list of rows: one for each component of the velocity")
                            .per_axis()
                            .required()};
    }
  };

  template <int D>
  class In {
   public:
    static constexpr int dimension = D;
    /// Throws InputError where the gradient has fewer rows than the space has axes, or a number is not finite.
    explicit In(Parameters const& p) : velocity_(to_point<D>(p.velocity)), origin_(to_point<D>(p.origin)) {
      if (p.gradient.size() < D) throw InputError("linear: the gradient needs a row for each axis");
      for (int i = 0; i < D; ++i) {
        Point<D> const row = to_point<D>(p.gradient[static_cast<std::size_t>(i)]);
        for (int j = 0; j < D; ++j) gradient_(i, j) = row[j];
      }
    }
    /// (1) [m/s]
    [[nodiscard]] Point<D> velocity(Point<D> const& x) const {
      Point<D> v = velocity_;
      for (int i = 0; i < D; ++i) {
        for (int j = 0; j < D; ++j) v[i] += gradient_(i, j) * (x[j] - origin_[j]);
      }
      return v;
    }
    /// dv_i/dx_j [1/s]
    [[nodiscard]] Matrix<double, D> gradient(Point<D> const& /*x*/) const { return gradient_; }

   private:
    Point<D> velocity_, origin_;
    Matrix<double, D> gradient_;
  };
};

}  // namespace talus::body
