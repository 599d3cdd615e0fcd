#pragma once
/// The longest step that the solver bears, found by trying; lengths of steps as dt sqrt(E/rho)/h.
///
/// Kinematics: PlaneStrainReduced, PlaneStrain or Solid.

#include <array>
#include <cmath>
#include <vector>

#include "verification/reference/lattice_modes.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification {

/// A scheme with an elastic material.
struct ElasticScheme {
  Scheme scheme = {};
  double young = 1e6, poisson = 0.3, density = 1000, spacing = 0.1;

  /// h/sqrt(E/rho) [s]
  [[nodiscard]] double unit() const { return spacing / std::sqrt(young / density); }
  /// c_p/sqrt(E/rho) of waves of compression: steps as Courant numbers c_p dt/h.
  [[nodiscard]] double wave_speed() const { return std::sqrt((1 - poisson) / ((1 + poisson) * (1 - 2 * poisson))); }
};

/// The scheme in the words of the predictions (verification/reference/stability).
[[nodiscard]] reference::Transfer transfer_of(Scheme const& scheme);

/// Core's bound of an isolated particle, without its safety.
template <class Kinematics>
[[nodiscard]] double isolated_bound(ElasticScheme const& elastic);

/// Growth of disturbances that counts as unstable.
inline constexpr double unstable_growth = 1000;

/// A lattice that fills a periodic box, n particles a cell along each axis, `offset` cells beyond the places (k + 1/2)/n.
struct PeriodicLattice {
  static constexpr int cells = 8;
  int per_axis = 2;
  std::array<double, 3> offset{};
};

/// The longest step at which small random velocities do not lead to a velocity gradient that is a thousand times as large
/// within 2000 steps, nor to the end of the run; by bisection to 0.5 %.
template <class Kinematics>
[[nodiscard]] double measured_limit(ElasticScheme const& elastic, PeriodicLattice const& lattice, Cost& cost);
/// What verification/reference/stability/regular.hpp says of it.
template <class Kinematics>
[[nodiscard]] double predicted_limit(ElasticScheme const& elastic, PeriodicLattice const& lattice);

/// The offset along the diagonal of a cell, in sixteenths of the particles' distance, with the shortest prediction.
template <class Kinematics>
[[nodiscard]] PeriodicLattice worst_lattice(ElasticScheme const& elastic, int per_axis);

/// Particles so far apart that they share no node, one at each of these offsets from a node [cells], strained a little
/// in every way. Returns by what factor the largest strain of each has grown at most over so many steps; the run is cut
/// short where one of them has grown so much that its motion is no longer small.
template <class Kinematics>
[[nodiscard]] std::vector<double> isolated_growth(ElasticScheme const& elastic,
                                                  std::vector<Point<Kinematics::dimension>> const& offsets, double step,
                                                  int steps, Cost& cost);

/// The longest step that a particle at each of these offsets bears: steps are made longer by 1 % until its strain grows.
template <class Kinematics>
[[nodiscard]] std::vector<double> isolated_limits(ElasticScheme const& elastic,
                                                  std::vector<Point<Kinematics::dimension>> const& offsets, Cost& cost);

}  // namespace talus::verification
