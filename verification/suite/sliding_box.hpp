#pragma once
/// An elastic box on a plane with Coulomb friction, placed at rest in the state in which it slides or sticks.
///
/// The frame of the plane: t points down the slope, n out of the wall; g = g (sin theta t - cos theta n). `lean` turns
/// that frame against the grid: with 0 the plate lies along an axis and gravity is tilted; with lean = theta gravity is
/// vertical and the plane cuts through the cells.
///
/// While all of the base slides, momentum and Coulomb's law give, for constant steps and a start at rest,
///
///   x + mu y = a t (t + dt)/2,   a = g (sin theta - mu cos theta)                                       (1)
///
/// for the way x of the centre of mass down the slope and y away from it, whatever the box does; a box that does not
/// rise has y = 0.

#include <functional>
#include <vector>

#include "core/simulation.hpp"
#include "verification/suite/findings.hpp"
#include "verification/suite/scheme.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification {

inline constexpr double degree = 0.017453292519943295;

/// Of Hencky's elasticity, in plane strain. Without lateral strain (nu = 0) a box that slides is stable; see
/// cases/friction/sliding_box.cpp.
struct SlidingBox {
  Scheme scheme = {};
  double angle = 0;  ///< theta [rad]
  double lean = 0;   ///< [rad]
  double length = 0.1, height = 0.05, spacing = 0.0125;
  int per_axis = 2;
  double density = 1000, young = 1e6, poisson = 0;
  double friction = 0.2679491924311227;  ///< tan 15 degrees
  double gravity = 9.81;
  double step = 0.8;  ///< share of the stable step

  [[nodiscard]] Point<2> down() const;
  [[nodiscard]] Point<2> normal() const;
  [[nodiscard]] Point<2> pull() const;        ///< g as a vector [m/s^2]
  [[nodiscard]] double acceleration() const;  ///< a of (1), for a box that slides down [m/s^2]
  [[nodiscard]] double mass() const { return density * length * height; }
};

/// The box's scene with its time step set, on a plane that runs upslope beneath it at `belt` [m/s].
[[nodiscard]] Scene<2> scene_of_box(SlidingBox const& box, Point<2> const& gravity, double belt = 0);

/// The box at rest, strained as it is while it slides down steadily. It has lain on a belt that ran upslope beneath it,
/// under the force mu g cos theta t - g cos theta n which it feels in a frame that slides along; PIC took the waves
/// out. upslope: strained as it is while it slides up.
[[nodiscard]] std::vector<Seed<2>> settled_sliding(SlidingBox const& box, bool upslope = false);

/// The box at rest, stuck to the slope under its weight.
[[nodiscard]] std::vector<Seed<2>> settled_sticking(SlidingBox const& box);

/// What a box did.
struct Slid {
  double time = 0, step = 0;                 ///< [s]
  double along = 0, away = 0;                ///< way of the centre of mass along t and n [m]
  double base_slip = 0;                      ///< largest way of a particle of the lowest row [m]
  double short_by = 0, excess = 0;           ///< T - mu N over mu g cos theta M dt: minus its mean, and its largest
  double least_load = 1, greatest_load = 1;  ///< N over g cos theta M dt
  Cost cost = {};

  /// t (t + dt)/2 [s^2]
  [[nodiscard]] double half_square() const { return 0.5 * time * (time + step); }
};

/// Lets the box go for `end` seconds, with the velocities of its seeds. after_each: called after each step.
[[nodiscard]] Slid slide(SlidingBox const& box, std::vector<Seed<2>> const& seeds, double end,
                         std::function<void(Simulation<2> const&)> const& after_each = {});

/// Mean velocity of the particles along a direction [m/s]; they all have the same mass.
[[nodiscard]] double mean_velocity(Simulation<2> const& simulation, Point<2> const& direction);

/// How far the particles have moved along a direction on the mean [m].
[[nodiscard]] double mean_way(Simulation<2> const& simulation, std::vector<Seed<2>> const& from,
                              Point<2> const& direction);

}  // namespace talus::verification
