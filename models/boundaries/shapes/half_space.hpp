#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>

#include "core/config/parameters.hpp"
#include "core/coordinates.hpp"
#include "core/errors.hpp"
#include "core/wall.hpp"

namespace talus::wall {

/// The material is where the normal points:
///
///   distance = n . (x - x_0),  n = normal / |normal|                   (1)
struct HalfSpace {
  static constexpr std::string_view name = "half_space", title = "Half-space below a plane";
  static constexpr bool supports(int D) { return D == 2 || D == 3; }

  struct Parameters {
    Coordinates point{0, 0, 0}, normal{0, 1, 0};
    static constexpr auto table() {
      return std::tuple{
          parameter(&Parameters::point, "point", "x_0", "m", "a point of the plane").per_axis().required(),
          parameter(&Parameters::normal, "normal", "n", "1", "direction from the wall into the material, of any length")
              .per_axis()
              .required()};
    }
    static std::optional<std::string> check(Parameters const& p) {
      for (double const component : p.normal.values)
        if (component != 0) return std::nullopt;
      return "the normal must not be zero";
    }
  };

  template <int D>
  class In {
   public:
    static_assert(supports(D));

    /// Throws InputError where the normal is zero or a coordinate not finite.
    explicit In(Parameters const& p) : point_(to_point<D>(p.point)), normal_(to_point<D>(p.normal)) {
      double const largest = normal_.template lpNorm<Eigen::Infinity>();
      if (!(largest > 0)) throw InputError("half_space: the normal must not be zero");
      normal_ = (normal_ / largest).normalized();  // no square under- or overflows
    }
    int surfaces(Point<D> const& x, std::span<Surface<D>> out) const {
      out[0] = {distance(x), normal_};
      return 1;
    }
    [[nodiscard]] double distance(Point<D> const& x) const { return normal_.dot(x - point_); }  // (1)

   private:
    Point<D> point_, normal_;
  };
};

}  // namespace talus::wall
