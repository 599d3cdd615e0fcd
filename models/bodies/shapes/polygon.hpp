#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/config/parameters.hpp"
#include "core/coordinates.hpp"
#include "core/errors.hpp"
#include "core/tensor.hpp"

namespace talus::body {

/// A polygon in the plane without holes, its edges meeting at its vertices only; vertices in either sense of rotation.
///
///   A = 1/2 |sum_k (x_k - x_0) x (x_{k+1} - x_0)|                      (1)
///
/// A point lies inside where a ray from it along +x crosses an odd number of edges (2). Every edge counts its lower end
/// and not its upper one, and gives the same crossing in either sense: of polygons that share an edge exactly one owns
/// a point on it.
struct Polygon {
  static constexpr std::string_view name = "polygon", title = "Simple polygon (plane only)",
                                    source = "elementary geometry";
  static constexpr bool supports(int D) { return D == 2; }

  struct Parameters {
    std::vector<Coordinates> points{{0, 0}, {1, 0}, {0, 1}};
    static constexpr auto table() {
      return std::tuple{parameter(&Parameters::points, "points", "x_k", "m", "vertices in order along the boundary")
                            .sized(3, 2000)
                            .required()};
    }
    static std::optional<std::string> check(Parameters const& p) {
      if (p.points.size() < 3) return "needs three points or more";
      auto const is_plane = [](Coordinates const& x) { return x.size() == 2; };
      if (!std::all_of(p.points.begin(), p.points.end(), is_plane))
        return "it lives in the plane: every point must have two coordinates";
      return wrong_with(vertices_of(p));
    }
  };

  template <int D>
  class In {
   public:
    static constexpr int dimension = D;
    static_assert(supports(D));

    /// Throws InputError where the polygon crosses or touches itself, or has no area.
    explicit In(Parameters const& p) {
      if (auto const wrong = Parameters::check(p)) throw InputError("polygon: " + *wrong);
      vertices_ = vertices_of(p);
    }
    [[nodiscard]] bool contains(Point<D> const& x) const {
      bool inside = false;
      for (std::size_t k = 0; k < vertices_.size(); ++k) {
        auto const [low, high] = edge(vertices_, k);
        if ((low[1] > x[1]) == (high[1] > x[1])) continue;
        double const crossing = low[0] + (x[1] - low[1]) / (high[1] - low[1]) * (high[0] - low[0]);
        if (x[0] < crossing) inside = !inside;  // (2)
      }
      return inside;
    }
    /// Area (1) [m^2].
    [[nodiscard]] double volume() const { return std::abs(signed_area(vertices_)); }
    /// Corners of the box around it [m].
    [[nodiscard]] std::pair<Point<D>, Point<D>> bounds() const { return box_around(vertices_); }

   private:
    std::vector<Point<D>> vertices_;
  };

 private:
  using Vertices = std::vector<Point<2>>;

  static Vertices vertices_of(Parameters const& p) {
    Vertices vertices;
    vertices.reserve(p.points.size());
    for (auto const& x : p.points) vertices.push_back(to_point<2>(x));
    return vertices;
  }
  static double cross(Point<2> const& a, Point<2> const& b) { return a[0] * b[1] - a[1] * b[0]; }
  /// Edge k, its lower end first (of two equally low ends, the left one).
  static std::pair<Point<2>, Point<2>> edge(Vertices const& v, std::size_t k) {
    Point<2> const &a = v[k], &b = v[(k + 1) % v.size()];
    bool const a_is_lower = a[1] < b[1] || (a[1] == b[1] && a[0] < b[0]);
    return a_is_lower ? std::pair{a, b} : std::pair{b, a};
  }
  static double signed_area(Vertices const& v) {
    double twice = 0;
    for (std::size_t k = 1; k + 1 < v.size(); ++k) twice += cross(v[k] - v[0], v[k + 1] - v[0]);
    return 0.5 * twice;
  }
  static std::pair<Point<2>, Point<2>> box_around(Vertices const& v) {
    Point<2> low = v[0], high = v[0];
    for (auto const& x : v) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
    return {low, high};
  }

  /// Side of the line from a to b on which x lies: 1 left, -1 right, 0 on it.
  static int side(Point<2> const& a, Point<2> const& b, Point<2> const& x) {
    double const turn = cross(b - a, x - a);
    return turn > 0 ? 1 : (turn < 0 ? -1 : 0);
  }
  /// Whether x, known to lie on the line through a and b, lies between them.
  static bool between(Point<2> const& a, Point<2> const& b, Point<2> const& x) {
    return (x.array() >= a.cwiseMin(b).array()).all() && (x.array() <= a.cwiseMax(b).array()).all();
  }
  static bool meet(Point<2> const& a, Point<2> const& b, Point<2> const& c, Point<2> const& d) {
    int const c_side = side(a, b, c), d_side = side(a, b, d), a_side = side(c, d, a), b_side = side(c, d, b);
    if (c_side * d_side < 0 && a_side * b_side < 0) return true;
    return (c_side == 0 && between(a, b, c)) || (d_side == 0 && between(a, b, d)) ||
           (a_side == 0 && between(c, d, a)) || (b_side == 0 && between(c, d, b));
  }
  /// What keeps the vertices from being a simple polygon, or nothing.
  static std::optional<std::string> wrong_with(Vertices const& v) {
    std::size_t const n = v.size();
    auto const at = [&](std::size_t k) -> Point<2> const& { return v[k % n]; };
    auto const number = [&](std::size_t k) { return std::to_string(k % n); };
    for (std::size_t k = 0; k < n; ++k) {
      Point<2> const here = at(k + 1) - at(k), next = at(k + 2) - at(k + 1);
      if (here.isZero(0)) return "points " + number(k) + " and " + number(k + 1) + " are the same";
      bool const straight = side(at(k), at(k + 1), at(k + 2)) == 0;
      if (straight && here.dot(next) < 0) return "the boundary turns back onto itself at point " + number(k + 1);
    }
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t const last = k == 0 ? n - 1 : n;  // the last edge is the first one's neighbour
      for (std::size_t other = k + 2; other < last; ++other) {
        if (meet(at(k), at(k + 1), at(other), at(other + 1)))
          return "the edges that begin at points " + number(k) + " and " + number(other) + " meet";
      }
    }
    auto const [low, high] = box_around(v);
    double const round_off =
        static_cast<double>(n) * std::numeric_limits<double>::epsilon() * (high - low).squaredNorm();
    if (!(std::abs(signed_area(v)) > round_off && std::isfinite(round_off)))
      return "the area must be positive and finite";
    return std::nullopt;
  }
};

}  // namespace talus::body
