#pragma once
/// A dense background grid over a box, and the nodes about a point of it.

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/tensor.hpp"

namespace talus::naive {

template <int D>
struct Node {
  double mass = 0;                ///< [kg]
  Point<D> v = Point<D>::Zero();  ///< momentum [kg m/s] while particles add to it, then velocity [m/s]
};

/// What the nodes about a point are to it, axis by axis.
template <int D, class Spline>
struct Stencil {
  std::size_t first;                ///< number of the lowest node
  double weight[D][Spline::width];  ///< N [1]
  double slope[D][Spline::width];   ///< dN/dx [1/m]
  double arm[D][Spline::width];     ///< x_i - x_p [m]
};

/// Nodes i h that lie in a box, the last axis running fastest.
template <int D>
class Grid {
 public:
  using Index = Eigen::Array<int, D, 1>;

  /// h [m]; the box from `low` to `high` [m] is widened to whole cells.
  Grid(double spacing, Point<D> const& low, Point<D> const& high)
      : spacing_(spacing),
        first_((low.array() / spacing).floor().template cast<int>()),
        count_((high.array() / spacing).ceil().template cast<int>() - first_ + 1),
        nodes_(static_cast<std::size_t>(count_.template cast<long>().prod())) {}

  void clear() { std::fill(nodes_.begin(), nodes_.end(), Node<D>{}); }

  /// Whether all nodes about x are there. False where x is not a number.
  template <class Spline>
  [[nodiscard]] bool holds(Point<D> const& x) const {
    auto const start = (x / spacing_).array() - Spline::behind - first_.template cast<double>();
    return (start >= 0).all() && (start + double(Spline::width) <= count_.template cast<double>()).all();
  }

  /// Pre: holds<Spline>(x).
  template <class Spline>
  [[nodiscard]] Stencil<D, Spline> about(Point<D> const& x) const {
    Stencil<D, Spline> s;
    double const cells = 1 / spacing_;
    s.first = 0;
    for (int d = 0; d < D; ++d) {
      double const start = x[d] * cells - first_[d] - Spline::behind;
      int const lowest = static_cast<int>(start);  // not negative, so rounded down
      double const t = start - lowest;
      Spline::evaluate(t, s.weight[d], s.slope[d]);
      for (int k = 0; k < Spline::width; ++k) {
        s.slope[d][k] *= cells;
        s.arm[d][k] = spacing_ * (k - Spline::behind - t);
      }
      s.first = s.first * static_cast<std::size_t>(count_[d]) + static_cast<std::size_t>(lowest);
    }
    return s;
  }

  /// Calls f(node, w, grad w, x_i - x_p) for each node of a stencil: products of weights and slopes over the axes.
  template <class Spline, class F>
  void for_each(Stencil<D, Spline> const& s, F const& f) {
    auto const &w = s.weight, &g = s.slope, &r = s.arm;
    Node<D>* line = nodes_.data() + s.first;
    for (int i = 0; i < Spline::width; ++i, line += stride(0)) {
      if constexpr (D == 2) {
        for (int j = 0; j < Spline::width; ++j)
          f(line[j], w[0][i] * w[1][j], Point<D>(g[0][i] * w[1][j], w[0][i] * g[1][j]), Point<D>(r[0][i], r[1][j]));
      } else {
        Node<D>* row = line;
        for (int j = 0; j < Spline::width; ++j, row += stride(1)) {
          double const ww = w[0][i] * w[1][j], gw = g[0][i] * w[1][j], wg = w[0][i] * g[1][j];
          for (int k = 0; k < Spline::width; ++k)
            f(row[k], ww * w[2][k], Point<D>(gw * w[2][k], wg * w[2][k], ww * g[2][k]),
              Point<D>(r[0][i], r[1][j], r[2][k]));
        }
      }
    }
  }

  /// Calls f(node, its place x_i [m]) for each node that has mass.
  template <class F>
  void for_each_massive(F const& f) {
    for (std::size_t n = 0; n < nodes_.size(); ++n)
      if (nodes_[n].mass > 0) f(nodes_[n], place(n));
  }

 private:
  /// Distance in memory of neighbours on axis d.
  [[nodiscard]] std::ptrdiff_t stride(int d) const {
    std::ptrdiff_t product = 1;
    for (int k = d + 1; k < D; ++k) product *= count_[k];
    return product;
  }
  [[nodiscard]] Point<D> place(std::size_t n) const {
    Point<D> x;
    for (int d = D - 1; d >= 0; --d) {
      auto const count = static_cast<std::size_t>(count_[d]);
      x[d] = spacing_ * (first_[d] + static_cast<int>(n % count));
      n /= count;
    }
    return x;
  }

  double spacing_;
  Index first_, count_;
  std::vector<Node<D>> nodes_;
};

}  // namespace talus::naive
