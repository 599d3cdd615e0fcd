#pragma once
/// What walls do to the velocity of a node that touches them.

#include <cmath>
#include <cstddef>
#include <span>

#include "core/tensor.hpp"

namespace talus {

/// What a contact lets a node do. A contact policy gives it; it is no input by itself.
struct ContactRule {
  bool sticks = false;             ///< the node takes the wall's velocity; nothing else counts
  bool separates = true;           ///< the wall pushes and never pulls
  bool material_friction = false;  ///< the coefficient of friction is the material's at the node, not `friction`
  bool mirrors = false;            ///< what lies behind is the image of what lies before: core/mirror.hpp
  double friction = 0;             ///< coefficient of friction [1]

  /// Whether the wall pulls as well as it pushes.
  [[nodiscard]] bool holds() const { return sticks || !separates; }
};

/// A node on a face of a wall.
template <int D>
struct Touch {
  Point<D> normal;         ///< of the face, length 1, out of the wall
  Point<D> wall_velocity;  ///< [m/s]
  ContactRule rule;
  double friction;  ///< the coefficient that holds here [1]: the rule's or the material's
  int wall;         ///< number of the wall; plays no part in the result
};

/// More faces than this cannot be resolved at one node.
inline constexpr std::size_t most_touches = 16;

/// The velocity that one wall allows; v [m/s] is the node's, w the wall's:
///
///   v_r = v - w,  v_n = n . v_r,  v_t = v_r - v_n n
///   sticks:                            v' = w                                           (1)
///   separates and v_n >= 0:            v' = v, bit by bit                               (2)
///   else                               v' = w + max(0, 1 - mu |v_n| / |v_t|) v_t        (3)
///
/// Coulomb friction of the impulse |v_n| that the wall gives to a unit mass; the direction of v_t is kept. Applied
/// twice it adds no more than round-off. A velocity that is no number stays so, but for (1).
template <int D>
[[nodiscard]] Point<D> allowed_by(Touch<D> const& touch, Point<D> const& v) {
  if (touch.rule.sticks) return touch.wall_velocity;  // (1)
  Point<D> const v_r = v - touch.wall_velocity;
  double const v_n = touch.normal.dot(v_r);
  if (touch.rule.separates && !(v_n < 0)) return v;          // (2)
  if (!(touch.friction > 0)) return v - v_n * touch.normal;  // (3), mu = 0
  Point<D> const v_t = v_r - v_n * touch.normal;
  double const slip = v_t.norm(), lost = touch.friction * std::abs(v_n);
  if (lost >= slip) return touch.wall_velocity;
  return v - v_n * touch.normal - (lost / slip) * v_t;  // (3)
}

/// `resolve` for two touches or more; there for D = 2 and 3.
template <int D>
[[nodiscard]] Point<D> resolve_together(std::span<Touch<D> const> touches, Point<D> const& v,
                                        std::span<Point<D>> changes);

/// The velocity [m/s] that all touching walls together allow, and the change of velocity that each one causes; the
/// changes sum to result - v but for round-off.
///
/// One wall: `allowed_by`. Several: the velocity v' and changes N_k n_k + T_k for which (3) holds at every wall, given
/// what the others do. No wall is penetrated, none pulls that may separate, |T_k| <= mu_k N_k against the slip. Without
/// friction v' is the point nearest to v in the intersection of half-spaces. Where walls stick, v' is the mean of their
/// velocities and the others do nothing. Walls that close on each other get the least-squares compromise; walls whose
/// friction would jam (it loads them without bound) act without it.
///
/// The order of the touches plays no part, to the last bit. Touches that are the same share what they cause.
/// Throws: RunError at more than `most_touches`.
template <int D>
[[nodiscard]] inline Point<D> resolve(std::span<Touch<D> const> touches, Point<D> const& v,
                                      std::span<Point<D>> changes) {
  if (touches.size() != 1) return resolve_together<D>(touches, v, changes);
  Point<D> const allowed = allowed_by(touches[0], v);
  changes[0] = allowed - v;
  return allowed;
}

}  // namespace talus
