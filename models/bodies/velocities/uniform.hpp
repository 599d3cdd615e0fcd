#pragma once

#include <string_view>
#include <tuple>

#include "core/config/parameters.hpp"
#include "core/coordinates.hpp"
#include "core/tensor.hpp"

namespace talus::body {

/// The same velocity everywhere.
struct Uniform {
  static constexpr std::string_view name = "uniform", title = "Uniform velocity", source = "elementary kinematics";
  static constexpr bool supports(int D) { return D == 2 || D == 3; }

  struct Parameters {
    Coordinates velocity{0, 0, 0};
    static constexpr auto table() {
      return std::tuple{parameter(&Parameters::velocity, "velocity", "v_0", "m/s", "velocity of every particle")
                            .per_axis()
                            .required()};
    }
  };

  template <int D>
  class In {
   public:
    static constexpr int dimension = D;
    /// Throws InputError where the velocity is not finite.
    explicit In(Parameters const& p) : velocity_(to_point<D>(p.velocity)) {}
    /// [m/s]
    [[nodiscard]] Point<D> velocity(Point<D> const& /*x*/) const { return velocity_; }
    /// dv_i/dx_j [1/s]
    [[nodiscard]] Matrix<double, D> gradient(Point<D> const& /*x*/) const { return {}; }

   private:
    Point<D> velocity_;
  };
};

}  // namespace talus::body
