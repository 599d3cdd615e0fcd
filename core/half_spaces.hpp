#pragma once
/// The point of an intersection of half-spaces that lies nearest to a given one.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "core/tensor.hpp"

namespace talus {

/// {x : normal . x >= offset}, or the plane {x : normal . x = offset}; the normal has length 1.
template <int D>
struct Constraint {
  Point<D> normal;
  double offset;
  bool is_plane = false;

  /// How far x must be pushed along the normal: positive where x is outside the half-space.
  [[nodiscard]] double lacking(Point<D> const& x) const { return offset - normal.dot(x); }
  [[nodiscard]] bool holds(Point<D> const& x, double tolerance) const {
    double const gap = lacking(x);
    return gap <= tolerance && (!is_plane || gap >= -tolerance);
  }
};

/// The largest number in sight: coordinates of x and offsets.
template <int D>
[[nodiscard]] double scale_of(std::span<Constraint<D> const> constraints, Point<D> const& x) {
  double scale = x.template lpNorm<Eigen::Infinity>();
  for (auto const& constraint : constraints) scale = std::max(scale, std::abs(constraint.offset));
  return scale;
}

/// What round-off leaves of a constraint, as a share of the scale.
inline constexpr double round_off = 16 * std::numeric_limits<double>::epsilon();

/// A point this many scales away from x counts as none: half-spaces that face each other, all but parallel, meet there.
inline constexpr double farthest = 100;

/// Up to D of many constraints, each met with equality, and the pushes along their normals.
template <int D>
struct ActiveSet {
  std::array<std::size_t, D> chosen{};
  std::array<double, D> pushes{};
  std::size_t size = 0;

  [[nodiscard]] bool holds(std::size_t k) const { return std::find(begin(), end(), k) != end(); }
  void add(std::size_t k) { chosen[size++] = k; }
  void drop(std::size_t place) {
    for (--size; place < size; ++place) chosen[place] = chosen[place + 1];
  }
  /// 0, ..., n - 1
  static ActiveSet first(std::size_t n) {
    ActiveSet set;
    while (set.size < n) set.add(set.size);
    return set;
  }
  /// Moves on to the next set of this size, in lexical order; false after the last.
  [[nodiscard]] bool next(std::size_t count) {
    for (std::size_t k = size; k-- > 0;) {
      if (chosen[k] + (size - k) >= count) continue;
      ++chosen[k];
      for (std::size_t later = k + 1; later < size; ++later) chosen[later] = chosen[later - 1] + 1;
      return true;
    }
    return false;
  }

 private:
  [[nodiscard]] auto begin() const { return chosen.begin(); }
  [[nodiscard]] auto end() const { return chosen.begin() + static_cast<std::ptrdiff_t>(size); }
};

/// Moves x by pushes along their normals onto the planes of the active set. False where the normals depend on one
/// another.
///
///   n_i = sum_j L_ij q_j (modified Gram-Schmidt),  L c = lacking,  x <- x + sum_j c_j q_j,  L^T push = c
template <int D>
[[nodiscard]] bool push_onto(std::span<Constraint<D> const> constraints, ActiveSet<D>& active, Point<D>& x) {
  constexpr double dependent = 64 * std::numeric_limits<double>::epsilon();
  std::array<Point<D>, D> q;
  std::array<std::array<double, D>, D> L{};
  std::array<double, D> c{};
  for (std::size_t i = 0; i < active.size; ++i) {
    auto const& constraint = constraints[active.chosen[i]];
    q[i] = constraint.normal;
    for (std::size_t j = 0; j < 2 * i; ++j) {  // twice, so that q stays orthogonal where normals nearly coincide
      double const along = q[j % i].dot(q[i]);
      L[i][j % i] += along;
      q[i] -= along * q[j % i];
    }
    L[i][i] = q[i].norm();
    if (!(L[i][i] > dependent)) return false;
    q[i] /= L[i][i];
    c[i] = constraint.lacking(x) / L[i][i];
    x += c[i] * q[i];
  }
  for (std::size_t i = active.size; i-- > 0;) {
    double rest = c[i];
    for (std::size_t j = i + 1; j < active.size; ++j) rest -= L[j][i] * active.pushes[j];
    active.pushes[i] = rest / L[i][i];
  }
  return true;
}

/// Where no point meets all constraints: the point that misses them least (sum of squares). Each turn steps by the mean
/// of what they ask for, which is the steepest descent of that sum with a step at which it cannot grow.
template <int D>
[[nodiscard]] Point<D> compromise(std::span<Constraint<D> const> constraints, Point<D> x, std::span<double> pushes) {
  constexpr int most_turns = 200;
  double const tolerance = round_off * scale_of(constraints, x), share = 1.0 / static_cast<double>(constraints.size());
  for (int turn = 0; turn < most_turns; ++turn) {
    Point<D> step = Point<D>::Zero();
    for (std::size_t k = 0; k < constraints.size(); ++k) {
      double const gap = constraints[k].lacking(x);
      if (!constraints[k].is_plane && !(gap > 0)) continue;
      step += share * gap * constraints[k].normal;
      pushes[k] += share * gap;
    }
    x += step;
    if (!(step.template lpNorm<Eigen::Infinity>() > tolerance)) break;
  }
  return x;
}

/// The point nearest to x that meets all constraints, and the pushes along the normals that lead there:
///
///   result = x + sum_k pushes_k n_k,  pushes_k >= 0 for half-spaces, pushes_k = 0 unless the result lies on plane k
///
/// At most D planes decide, so every set of up to D planes is tried, small sets first. Where x meets all constraints it
/// comes back bit by bit. Where no point does, or none near (`farthest`), see `compromise`.
/// Error: `round_off` times the scale. Cost: count^D small solves at worst.
template <int D>
[[nodiscard]] Point<D> project(std::span<Constraint<D> const> constraints, Point<D> const& x,
                               std::span<double> pushes) {
  std::fill(pushes.begin(), pushes.end(), 0.0);
  auto const all_hold = [&](Point<D> const& y, double tolerance) {
    return std::all_of(constraints.begin(), constraints.end(),
                       [&](auto const& constraint) { return constraint.holds(y, tolerance); });
  };
  auto const pulls = [&](ActiveSet<D> const& active) {
    for (std::size_t k = 0; k < active.size; ++k)
      if (!constraints[active.chosen[k]].is_plane && !(active.pushes[k] >= 0)) return true;
    return false;
  };
  if (all_hold(x, 0.0)) return x;
  double const scale = scale_of(constraints, x);
  for (std::size_t size = 1; size <= std::min(std::size_t{D}, constraints.size()); ++size) {
    auto active = ActiveSet<D>::first(size);
    do {
      Point<D> y = x;
      if (!push_onto(constraints, active, y) || pulls(active)) continue;
      if ((y - x).template lpNorm<Eigen::Infinity>() > farthest * scale) continue;
      if (!all_hold(y, round_off * std::max(scale, y.template lpNorm<Eigen::Infinity>()))) continue;
      for (std::size_t k = 0; k < size; ++k) pushes[active.chosen[k]] = active.pushes[k];
      return y;
    } while (active.next(constraints.size()));
  }
  return compromise(constraints, x, pushes);
}

}  // namespace talus
