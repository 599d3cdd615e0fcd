#pragma once

#include <span>
#include <string_view>
#include <tuple>

#include "core/wall.hpp"
#include "models/boundaries/extent.hpp"

namespace talus::wall {

/// The material is inside a box along the axes. Along each axis the nearer of two faces counts, so that a node in a
/// corner has D of them:
///
///   distance_i = min(x_i - min_i, max_i - x_i)                         (1)
struct Container {
  static constexpr std::string_view name = "container", title = "Box along the axes that holds the material";
  static constexpr bool supports(int D) { return D == 2 || D == 3; }

  using Parameters = Extent;

  template <int D>
  class In {
   public:
    static_assert(supports(D) && D <= Wall<D>::max_surfaces);

    /// Throws InputError where min is not below max along each axis.
    explicit In(Parameters const& p) { std::tie(min_, max_) = p.corners<D>(); }
    int surfaces(Point<D> const& x, std::span<Surface<D>> out) const {
      for (int axis = 0; axis < D; ++axis) {
        double const above = x[axis] - min_[axis], below = max_[axis] - x[axis];
        bool const is_low = above <= below;
        out[static_cast<std::size_t>(axis)] = {
            is_low ? above : below, is_low ? Point<D>(Point<D>::Unit(axis)) : Point<D>(-Point<D>::Unit(axis))};
      }
      return D;
    }
    [[nodiscard]] double distance(Point<D> const& x) const {
      return (x - min_).cwiseMin(max_ - x).minCoeff();  // (1)
    }

   private:
    Point<D> min_, max_;
  };
};

}  // namespace talus::wall
