#pragma once
/// Brings an elastic scene to rest.

#include "verification/suite/setup.hpp"

namespace talus::verification {

/// Takes at most n steps. Whenever the kinetic energy has fallen since the step before, all velocities are set to zero
/// (kinetic damping); that leaves a scene at rest where it is. Returns the largest speed of the last steps between two
/// such stops [m/s].
///
/// Source: Cundall (1982), Adaptive density-scaling for time-explicit calculations (from memory).
template <int D>
double settle(Simulation<D>& simulation, long n, Cost& cost) {
  auto const stop = [&] {
    Particles<D>& particles = simulation.particles();
    Layout const& layout = particles.layout();
    int const v = layout.find(field::velocity), C = layout.find("affine_velocity");
    particles.for_each([&](std::ptrdiff_t slot, int) {
      for (int d = 0; d < D; ++d) particles.set(slot, v + d, 0);
      for (int k = 0; C >= 0 && k < D * D; ++k) particles.set(slot, C + k, 0);
    });
  };
  auto const kinetic = [&] {
    double sum = 0;
    auto const m = column(simulation, "mass");
    auto const v = vectors(simulation, "velocity");
    for (std::size_t p = 0; p < v.size(); ++p) sum += 0.5 * m[p] * v[p].squaredNorm();
    return sum;
  };
  double before = 0, fastest = 0, last = 0;
  for (long k = 0; k < n; ++k) {
    take_steps(simulation, 1, cost);
    double const now = kinetic();
    fastest = std::max(fastest, simulation.motion().speed);
    if (now < before) {
      stop();
      last = fastest;
      fastest = before = 0;
    } else {
      before = now;
    }
  }
  return last;
}

}  // namespace talus::verification
