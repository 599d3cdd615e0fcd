#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "core/config/parameters.hpp"
#include "core/coordinates.hpp"
#include "core/errors.hpp"
#include "core/tensor.hpp"

namespace talus::body {

/// The points x with min_i <= x_i < max_i: a rectangle or a cuboid along the axes.
struct Box {
  static constexpr std::string_view name = "box", title = "Box along the axes", source = "elementary geometry";
  static constexpr bool supports(int D) { return D == 2 || D == 3; }

  struct Parameters {
    Coordinates min{0, 0, 0}, max{1, 1, 1};
    static constexpr auto table() {
      return std::tuple{
          parameter(&Parameters::min, "min", "x_{min}", "m", "corner with the least coordinates").per_axis().required(),
          parameter(&Parameters::max, "max", "x_{max}", "m", "corner with the greatest coordinates")
              .per_axis()
              .required()};
    }
    static std::optional<std::string> check(Parameters const& p) {
      if (p.min.size() != p.max.size()) return "min and max must have as many coordinates";
      for (std::size_t axis = 0; axis < p.min.size(); ++axis) {
        if (!(p.min[axis] < p.max[axis])) return "min must be less than max along every axis";
      }
      return std::nullopt;
    }
  };

  template <int D>
  class In {
   public:
    static constexpr int dimension = D;
    static_assert(supports(D));

    /// Throws InputError where the box has no volume, or one that is no finite number.
    explicit In(Parameters const& p) : min_(to_point<D>(p.min)), max_(to_point<D>(p.max)) {
      if (auto const wrong = Parameters::check(p)) throw InputError("box: " + *wrong);
      if (!(volume() > 0 && volume() <= std::numeric_limits<double>::max()))
        throw InputError("box: the volume must be a positive finite number");
    }
    [[nodiscard]] bool contains(Point<D> const& x) const {
      return (x.array() >= min_.array()).all() && (x.array() < max_.array()).all();
    }
    /// [m^D]
    [[nodiscard]] double volume() const { return (max_ - min_).prod(); }
    /// Corners of the box around it [m]: itself.
    [[nodiscard]] std::pair<Point<D>, Point<D>> bounds() const { return {min_, max_}; }

   private:
    Point<D> min_, max_;
  };
};

}  // namespace talus::body
