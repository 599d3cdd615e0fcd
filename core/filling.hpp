#pragma once
/// From the seeds of bodies to the particles of a simulation.

#include <utility>
#include <vector>

#include "core/body.hpp"
#include "core/simulation.hpp"

namespace talus {

/// The particles of one body: places, velocities and their gradients (at rest where left empty), material, density
/// [kg/m^3].
template <int D>
struct Filling {
  body::Seeds<D> seeds;
  std::vector<Point<D>> velocities;
  std::vector<Matrix<double, D>> gradients;
  std::int32_t material = 0;
  double density = 0;
};

/// Puts the particles of all bodies into a simulation that has none yet, and begins it.
template <int D>
void fill(Simulation<D>& simulation, std::vector<Filling<D>> const& fillings) {
  Particles<D>& particles = simulation.particles();
  Layout const& layout = particles.layout();
  std::vector<Run> runs;
  for (Filling<D> const& f : fillings) runs.push_back({0, f.material, 0, static_cast<int>(f.seeds.points.size())});
  particles.allocate(runs, 1);
  int const affine = layout.find("affine_velocity");
  std::vector<std::pair<int, double>> start;
  double id = 0;
  for (std::size_t b = 0; b < fillings.size(); ++b) {
    Filling<D> const& f = fillings[b];
    start.clear();
    simulation.scene().materials[static_cast<std::size_t>(f.material)]->start(start);
    for (std::size_t k = 0; k < f.seeds.points.size(); ++k) {
      std::ptrdiff_t const slot = particles.runs()[b].first_chunk * lanes + static_cast<std::ptrdiff_t>(k);
      for (int d = 0; d < D; ++d) {
        particles.set(slot, layout.find(field::position) + d, f.seeds.points[k][d]);
        if (!f.velocities.empty()) particles.set(slot, layout.find(field::velocity) + d, f.velocities[k][d]);
        for (int j = 0; affine >= 0 && !f.gradients.empty() && j < D; ++j)
          particles.set(slot, affine + d * D + j, f.gradients[k](d, j));
      }
      particles.set(slot, layout.find(field::mass), f.seeds.volume * f.density);
      particles.set(slot, layout.find(field::identity), id++);
      for (auto const& [pack, value] : start) particles.set(slot, pack, value);
    }
  }
  simulation.begin();
}

extern template void fill<2>(Simulation<2>&, std::vector<Filling<2>> const&);  // core/simulation.cpp
extern template void fill<3>(Simulation<3>&, std::vector<Filling<3>> const&);

}  // namespace talus
