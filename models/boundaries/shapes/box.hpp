#pragma once

#include <array>
#include <span>
#include <string_view>
#include <tuple>

#include "core/wall.hpp"
#include "models/boundaries/extent.hpp"

namespace talus::wall {

/// A solid box along the axes; the material is outside. With q_i = max(min_i - x_i, x_i - max_i):
///
///   inside    distance = max_i q_i, normal to that face                (1)
///   outside   distance = |max(q, 0)|, normal away from the nearest point of the box      (2)
struct Box {
  static constexpr std::string_view name = "box", title = "Solid box along the axes, an obstacle";
  static constexpr bool supports(int D) { return D == 2 || D == 3; }

  using Parameters = Extent;

  template <int D>
  class In {
   public:
    static_assert(supports(D));

    /// Throws InputError where min is not below max along each axis.
    explicit In(Parameters const& p) { std::tie(min_, max_) = p.corners<D>(); }
    int surfaces(Point<D> const& x, std::span<Surface<D>> out) const {
      Point<D> const q = beyond(x);
      int nearest = 0;
      double const largest = q.maxCoeff(&nearest);
      if ((q.array() > 0).count() > 1) {
        Point<D> const away = q.cwiseMax(0.0).cwiseProduct(side(x)) / largest;
        double const length = away.norm();
        out[0] = {largest * length, away / length};  // (2)
      } else {
        out[0] = {largest, side(x)[nearest] * Point<D>::Unit(nearest)};  // (1), and (2) before a face
      }
      return 1;
    }
    [[nodiscard]] double distance(Point<D> const& x) const {
      std::array<Surface<D>, 1> nearest;
      surfaces(x, nearest);
      return nearest[0].distance;
    }

   private:
    [[nodiscard]] Point<D> beyond(Point<D> const& x) const { return (min_ - x).cwiseMax(x - max_); }
    /// -1 where the lower face is the nearer one, else 1.
    [[nodiscard]] Point<D> side(Point<D> const& x) const {
      return (min_ - x).binaryExpr(x - max_, [](double low, double high) { return low > high ? -1.0 : 1.0; });
    }

    Point<D> min_, max_;
  };
};

}  // namespace talus::wall
