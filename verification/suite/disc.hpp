#pragma once
/// A disc of particles.

#include <cmath>
#include <vector>

#include "verification/suite/setup.hpp"

namespace talus::verification {

/// A disc of rings of particles `pitch` apart, so that its rim is as round as they are close.
[[nodiscard]] inline std::vector<Seed<2>> disc(Point<2> const& centre, double radius, double pitch, double density) {
  constexpr double turn = 6.28318530717958648;
  double const rings = std::round(radius / pitch), width = radius / rings;
  std::vector<Seed<2>> seeds;
  for (double ring = 0; ring < rings; ++ring) {
    double const r = (ring + 0.5) * width, count = std::round(turn * (ring + 0.5));
    for (double k = 0; k < count; ++k) {
      double const angle = turn * (k + 0.5 * std::fmod(ring, 2)) / count;
      seeds.push_back({centre + r * Point<2>(std::cos(angle), std::sin(angle)), Point<2>::Zero(),
                       density * turn * r * width / count});
    }
  }
  return seeds;
}

/// Of the centre of mass, and the mean angular velocity about it.
struct RigidMotion {
  Point<2> centre = Point<2>::Zero(), velocity = Point<2>::Zero();
  double spin = 0;  ///< anticlockwise [1/s]
};
[[nodiscard]] inline RigidMotion rigid_motion(Simulation<2> const& simulation) {
  auto const x = vectors(simulation, "position"), v = vectors(simulation, "velocity");
  auto const m = column(simulation, "mass");
  RigidMotion motion;
  for (std::size_t p = 0; p < x.size(); ++p) {
    motion.centre += m[p] / simulation.mass() * x[p];
    motion.velocity += m[p] / simulation.mass() * v[p];
  }
  double turning = 0, inertia = 0;
  for (std::size_t p = 0; p < x.size(); ++p) {
    Point<2> const r = x[p] - motion.centre, u = v[p] - motion.velocity;
    turning += m[p] * (r[0] * u[1] - r[1] * u[0]);
    inertia += m[p] * r.squaredNorm();
  }
  motion.spin = turning / inertia;
  return motion;
}

}  // namespace talus::verification
