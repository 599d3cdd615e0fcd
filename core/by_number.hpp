#pragma once
/// A look at the particles of a simulation by their numbers, whatever the order they are stored in.

#include <string_view>
#include <vector>

#include "core/simulation.hpp"

namespace talus {

/// Component c of a field of every particle: entry k is that of the particle with number k.
template <int D>
[[nodiscard]] std::vector<double> column(Simulation<D> const& simulation, std::string_view field, int c = 0) {
  Particles<D> const& particles = simulation.particles();
  std::vector<double> values(particles.count());
  int const pack = particles.layout().find(field) + c, id = particles.layout().find(field::identity);
  particles.for_each([&](std::ptrdiff_t slot, int) {
    values[static_cast<std::size_t>(particles.get(slot, id))] = particles.get(slot, pack);
  });
  return values;
}

/// A vector field of every particle.
template <int D>
[[nodiscard]] std::vector<Point<D>> vectors(Simulation<D> const& simulation, std::string_view field) {
  std::vector<Point<D>> values(simulation.particles().count());
  for (int d = 0; d < D; ++d) {
    auto const one = column(simulation, field, d);
    for (std::size_t k = 0; k < one.size(); ++k) values[k][d] = one[k];
  }
  return values;
}

}  // namespace talus
