#pragma once
/// Particles as dots on a plane: what a picture shows of a snapshot.

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "core/io/snapshot.hpp"

namespace talus::io {

/// The column of that name. Throws InputError, which names those that there are.
[[nodiscard]] NamedColumn const& column_of(Snapshot const& snapshot, std::string const& name);

using Direction = std::array<double, 3>;

/// A parallel projection: unit vectors to the right, upwards, and towards the eye.
struct View {
  Direction right, up, toward;
};

/// Along the z axis: x to the right, y upwards.
[[nodiscard]] View side_view();
/// From the front, right and above; y is upwards.
[[nodiscard]] View oblique_view();

/// The smallest box around points [m]; empty before it holds any.
struct Bounds {
  Direction low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};

  void include(Direction const& point);
  [[nodiscard]] bool empty() const { return low[0] > high[0]; }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
};

/// The particles' positions with a third coordinate (0 in the plane), those with a non-finite one left out.
[[nodiscard]] Bounds bounds_of(Snapshot const& snapshot);

/// A dot: its place on the plane [m] and what it is coloured by.
struct Dot {
  double x, y, value;
};

/// The particles of a snapshot on a plane, the farthest from the eye first, those of equal depth along a curve that
/// fills the plane: so every n-th dot is an even sample of them. `value` is the magnitude of the column `field`.
/// Particles with a non-finite place or value are left out.
[[nodiscard]] std::vector<Dot> dots_of(Snapshot const& snapshot, View const& view, std::string const& field);

/// About the distance between neighbouring particles [m]: the D-th root of the volume of the cells that hold any,
/// shared among all; 0 for less than two particles.
[[nodiscard]] double spacing_of(Snapshot const& snapshot);

}  // namespace talus::io
