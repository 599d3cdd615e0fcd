#pragma once
/// Walls that stay closed on a node, with friction: the pushes and drags that hold it there.

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <tuple>

#include "core/contact.hpp"
#include "core/errors.hpp"
#include "core/half_spaces.hpp"
#include "core/roots.hpp"

namespace talus {

/// Touches of one node in an order that their content alone decides.
template <int D>
struct Touches {
  std::array<Touch<D>, most_touches> sorted;
  std::array<std::size_t, most_touches> listed;  ///< place in the list as given
  std::array<Constraint<D>, most_touches> faces;
  std::size_t count;

  explicit Touches(std::span<Touch<D> const> touches) : count(touches.size()) {
    if (count > most_touches) throw RunError("more faces of walls touch one node than can be resolved together");
    for (std::size_t k = 0; k < count; ++k) {
      std::size_t at = k;
      for (; at > 0 && comes_before(touches[k], sorted[at - 1]); --at) {
        sorted[at] = sorted[at - 1];
        listed[at] = listed[at - 1];
      }
      sorted[at] = touches[k];
      listed[at] = k;
    }
    for (std::size_t k = 0; k < count; ++k)
      faces[k] = {sorted[k].normal, sorted[k].normal.dot(sorted[k].wall_velocity), !sorted[k].rule.separates};
  }
  static bool comes_before(Touch<D> const& a, Touch<D> const& b) {
    for (int i = 0; i < D; ++i)
      if (a.normal[i] != b.normal[i]) return a.normal[i] < b.normal[i];
    for (int i = 0; i < D; ++i)
      if (a.wall_velocity[i] != b.wall_velocity[i]) return a.wall_velocity[i] < b.wall_velocity[i];
    return std::tie(a.rule.sticks, a.rule.separates, a.friction) <
           std::tie(b.rule.sticks, b.rule.separates, b.friction);
  }
  [[nodiscard]] bool same(std::size_t a, std::size_t b) const {
    return !comes_before(sorted[a], sorted[b]) && !comes_before(sorted[b], sorted[a]);
  }
  [[nodiscard]] std::span<Constraint<D> const> constraints() const { return std::span(faces).first(count); }
};

/// The velocity that is left, and what each touch does: a push along its normal and a drag along its face [m/s].
template <int D>
struct Answer {
  Point<D> velocity;
  std::array<double, most_touches> pushes{};
  std::array<Point<D>, most_touches> drags;

  explicit Answer(Point<D> const& v) : velocity(v) { drags.fill(Point<D>::Zero()); }
};

/// Walls that all stay closed, with friction against the slip that remains:
///
///   n_j . (v' - w_j) = 0,   v' = v + sum_k N_k (n_k - mu_k d_k),   d_k = slip_k / |slip_k|, or 0 without slip      (4)
///
/// v' lies on the intersection of the faces. Where that is a point (D faces), v' and so d_k are known, and (4) is
/// linear in N. Where it is a line (an edge in 3-D) one unknown is left, the speed s along it.
template <int D>
class Closed {
 public:
  Closed(Touches<D> const& touches, ActiveSet<D> const& active, Point<D> const& v)
      : touches_(touches), active_(active), v_(v), base_(v) {
    independent_ = push_onto(touches.constraints(), active_, base_);
    no_slip_ = 64 * round_off * std::max(scale_of(touches.constraints(), v), base_.template lpNorm<Eigen::Infinity>());
  }
  /// Nothing where the normals depend on one another.
  [[nodiscard]] std::optional<Answer<D>> solve() const {
    if (active_.size == 0) return Answer<D>(v_);
    if (active_.size == 1) return one();
    if (!independent_) return std::nullopt;
    if constexpr (D == 3)
      if (active_.size == 2) return along_edge();
    return answer(base_, press(base_));
  }

 private:
  using Pushes = Eigen::Matrix<double, D, 1>;

  [[nodiscard]] Touch<D> const& touch(std::size_t place) const { return touches_.sorted[active_.chosen[place]]; }
  [[nodiscard]] Point<D> slip(std::size_t place, Point<D> const& velocity) const {
    Point<D> const v_r = velocity - touch(place).wall_velocity;
    return v_r - touch(place).normal.dot(v_r) * touch(place).normal;
  }
  /// d of (4).
  [[nodiscard]] Point<D> direction(std::size_t place, Point<D> const& velocity) const {
    Point<D> const v_t = slip(place, velocity);
    double const speed = v_t.norm();
    return speed > no_slip_ ? Point<D>(v_t / speed) : Point<D>(Point<D>::Zero());
  }
  /// What friction may do at most, a half-space that pulls does nothing.
  [[nodiscard]] double limit(std::size_t place, Pushes const& N) const {
    double const push = N[static_cast<int>(place)];
    return touch(place).friction * (touch(place).rule.separates ? std::max(push, 0.0) : std::abs(push));
  }
  /// N of (4) for the directions of slip at this velocity.
  [[nodiscard]] Pushes press(Point<D> const& velocity) const {
    Eigen::Matrix<double, D, D> A = Eigen::Matrix<double, D, D>::Identity();
    Pushes b = Pushes::Zero();
    for (std::size_t k = 0; k < active_.size; ++k) {
      Point<D> const oblique = touch(k).normal - touch(k).friction * direction(k, velocity);
      for (std::size_t j = 0; j < active_.size; ++j)
        A(static_cast<int>(j), static_cast<int>(k)) = touch(j).normal.dot(oblique);
      b[static_cast<int>(k)] = touch(k).normal.dot(base_ - v_);
    }
    return A.partialPivLu().solve(b);
  }
  [[nodiscard]] Answer<D> answer(Point<D> const& velocity, Pushes const& N) const {
    Answer<D> all(velocity);
    for (std::size_t k = 0; k < active_.size; ++k) {
      all.pushes[active_.chosen[k]] = N[static_cast<int>(k)];
      all.drags[active_.chosen[k]] = -limit(k, N) * direction(k, velocity);
    }
    return all;
  }
  [[nodiscard]] Answer<D> one() const {
    Answer<D> all(allowed_by(touch(0), v_));
    Point<D> const change = all.velocity - v_;
    double const push = touch(0).normal.dot(change);
    all.pushes[active_.chosen[0]] = push;
    all.drags[active_.chosen[0]] = change - push * touch(0).normal;
    return all;
  }
  [[nodiscard]] Answer<D> along_edge() const;

  Touches<D> const& touches_;
  ActiveSet<D> active_;
  Point<D> v_, base_;
  double no_slip_;
  bool independent_;
};

/// v' = base + s e with  s + sum_k mu_k N_k(s) d_k(s) . e = 0. A wall whose slip vanishes at some s holds the node
/// there if no more is asked of it than it can give.
template <int D>
Answer<D> Closed<D>::along_edge() const {
  Point<D> const e = touch(0).normal.cross(touch(1).normal).normalized();
  auto const excess = [&](double s) {
    Point<D> const velocity = base_ + s * e;
    Pushes const N = press(velocity);
    for (std::size_t k = 0; k < 2; ++k) s += limit(k, N) * direction(k, velocity).dot(e);
    return WithDerivative<double>{s, 1.0};
  };
  double low = 0, high = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    double const s = (touch(k).wall_velocity - base_).dot(e);
    low = std::min(low, s);
    high = std::max(high, s);
    Point<D> const velocity = base_ + s * e;
    Pushes const N = press(velocity);
    std::array<double, 2> grip{};
    for (std::size_t j = 0; j < 2; ++j)
      if (slip(j, velocity).norm() <= no_slip_) grip[j] = limit(j, N);
    double const asked = excess(s).value, total = grip[0] + grip[1];
    if (!(total > 0 && std::abs(asked) <= total)) continue;
    Answer<D> held = answer(velocity, N);
    for (std::size_t j = 0; j < 2; ++j) held.drags[active_.chosen[j]] += asked * (grip[j] / total) * e;
    return held;
  }
  double const s = bracketed_newton(excess, low, high, 0.5 * (low + high), 0.0).x;
  Point<D> const velocity = base_ + s * e;
  return answer(velocity, press(velocity));
}

}  // namespace talus
