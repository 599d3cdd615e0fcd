#pragma once
/// A wall: the solid that the material must not enter.

#include <limits>
#include <span>
#include <string>
#include <utility>

#include "core/contact.hpp"
#include "core/tensor.hpp"

namespace talus {

/// A flat or curved face near a point.
template <int D>
struct Surface {
  double distance;  ///< [m], positive outside the wall, where the material is
  Point<D> normal;  ///< gradient of the distance: length 1, out of the wall
};

/// Farther than any wall [m].
inline constexpr double far_away = std::numeric_limits<double>::infinity();

/// A scene may have this many walls.
inline constexpr std::size_t most_walls = 64;

/// A wall at run time: a shape that moves, and what it does to what touches it. Virtual a wall, not a node's face: the
/// arithmetic of a shape is compiled into the one call.
template <int D>
class Wall {
 public:
  static constexpr int max_surfaces = 3;

  std::string name;
  ContactRule contact;

  Wall(std::string its_name, ContactRule rule) : name(std::move(its_name)), contact(rule) {}
  Wall(Wall const&) = delete;
  Wall& operator=(Wall const&) = delete;
  virtual ~Wall() = default;

  /// Faces near x [m] at time t [s], one or several at a corner; returns how many were written. x lies in the wall
  /// where one of them has a distance <= 0, and touches those that have. Pre: room for `max_surfaces`.
  virtual int surfaces(Point<D> const& x, double t, std::span<Surface<D>> out) const = 0;
  /// At most the distance of any face near x, and changing no faster than x does: where it exceeds r, nothing within r
  /// of x touches the wall [m].
  [[nodiscard]] virtual double distance(Point<D> const& x, double t) const = 0;
  /// [m/s]
  [[nodiscard]] virtual Point<D> velocity(double t) const = 0;
};

}  // namespace talus
