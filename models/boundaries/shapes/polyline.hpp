#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/config/parameters.hpp"
#include "core/coordinates.hpp"
#include "core/errors.hpp"
#include "core/wall.hpp"

namespace talus::wall {

/// Ground in the plane: the wall lies to the right of the line as one travels along its points, the material to the
/// left. The line goes on straight beyond its ends.
///
/// The distance is that to the nearest point of the line, negative in the wall. Outside and at a corner that juts out,
/// the normal points away from that nearest point. In the wall, behind a corner where the material is wedged in, there
/// are the lines of both edges, as if each were a half-space. A line that crosses itself is not noticed.
struct Polyline {
  static constexpr std::string_view name = "polyline", title = "Ground along a line of points (plane only)";
  static constexpr bool supports(int D) { return D == 2; }

  struct Parameters {
    std::vector<Coordinates> points{{0, 0}, {1, 0}};
    static constexpr auto table() {
      return std::tuple{parameter(&Parameters::points, "points", "x_k", "m",
                                  "points in the order of travel, the material to the left")
                            .sized(2, 10000)
                            .required()};
    }
    static std::optional<std::string> check(Parameters const& p) {
      if (p.points.size() < 2) return "needs two points or more";
      for (auto const& x : p.points)
        if (x.size() != 2) return "every point must have two coordinates";
      for (std::size_t k = 0; k + 1 < p.points.size(); ++k) {
        std::string const here = "points " + std::to_string(k) + " and " + std::to_string(k + 1);
        Point<2> const step = to_point<2>(p.points[k + 1]) - to_point<2>(p.points[k]);
        if (!(step.stableNorm() > 0)) return here + " are the same";
        if (k + 2 >= p.points.size()) break;
        Point<2> const next = to_point<2>(p.points[k + 2]) - to_point<2>(p.points[k + 1]);
        if (turn(step.stableNormalized(), next.stableNormalized()) == 0 && step.dot(next) < 0)
          return "the line turns back onto itself after " + here;
      }
      return std::nullopt;
    }
  };

  template <int D>
  class In {
   public:
    static_assert(supports(D));

    /// Throws InputError at less than two points, points that repeat, a line that turns back onto itself.
    explicit In(Parameters const& p) {
      if (auto const wrong = Parameters::check(p)) throw InputError("polyline: " + *wrong);
      for (std::size_t k = 0; k + 1 < p.points.size(); ++k) {
        Point<2> const start = to_point<2>(p.points[k]), step = to_point<2>(p.points[k + 1]) - start;
        Point<2> const along = step.stableNormalized();
        edges_.push_back({start, along, {-along[1], along[0]}, step.stableNorm()});
      }
    }
    int surfaces(Point<2> const& x, std::span<Surface<2>> out) const {
      Nearest const nearest = nearest_to(x);
      bool const wedged = nearest.distance <= 0;
      if (nearest.corner > 0 && !(wedged && wedge(nearest.corner))) {
        out[0] = {nearest.distance, nearest.normal};
        return 1;
      }
      std::size_t count = 0;
      out[count++] = edges_[nearest.edge].face(x);
      if (wedged && wedge(nearest.edge)) out[count++] = edges_[nearest.edge - 1].face(x);
      if (wedged && wedge(nearest.edge + 1)) out[count++] = edges_[nearest.edge + 1].face(x);
      return static_cast<int>(count);
    }
    [[nodiscard]] double distance(Point<2> const& x) const { return nearest_to(x).distance; }

   private:
    struct Edge {
      Point<2> start, along, normal;
      double length;
      [[nodiscard]] Surface<2> face(Point<2> const& x) const { return {normal.dot(x - start), normal}; }
    };
    struct Nearest {
      double distance;
      Point<2> normal;
      std::size_t edge, corner;  ///< corner k is where edge k starts; 0 where no corner is the nearest point
    };

    /// Whether the material is wedged in at corner k: the line turns left.
    [[nodiscard]] bool wedge(std::size_t k) const {
      return k > 0 && k < edges_.size() && turn(edges_[k - 1].along, edges_[k].along) > 0;
    }
    [[nodiscard]] Nearest nearest_to(Point<2> const& x) const {
      Nearest best{0, Point<2>::Zero(), 0, 0};
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < edges_.size(); ++k) {
        Point<2> const from_start = x - edges_[k].start;
        double const s = edges_[k].along.dot(from_start);
        if (k > 0 && s <= 0) {
          if (from_start.stableNorm() < least) best = {0, from_start, k, k}, least = from_start.stableNorm();
        } else if (k + 1 == edges_.size() || s < edges_[k].length) {
          Surface<2> const face = edges_[k].face(x);
          if (std::abs(face.distance) < least)
            best = {face.distance, face.normal, k, 0}, least = std::abs(face.distance);
        }
      }
      if (best.corner > 0) settle(best, least);
      return best;
    }
    /// Side and normal at a corner, where `normal` still is the way from there to x.
    void settle(Nearest& best, double least) const {
      Point<2> const between = edges_[best.corner - 1].normal + edges_[best.corner].normal;
      double const side = best.normal.dot(between) < 0 ? -1.0 : 1.0;
      best.distance = side * least;
      best.normal = least > 0 ? Point<2>(best.normal * (side / least)) : Point<2>(between.normalized());
    }

    std::vector<Edge> edges_;
  };

 private:
  /// Sine of the angle by which b turns left of a.
  static double turn(Point<2> const& a, Point<2> const& b) { return a[0] * b[1] - a[1] * b[0]; }
};

}  // namespace talus::wall
