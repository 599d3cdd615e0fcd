#include "core/filling.hpp"
#include "core/simulation_extras.hpp"
#include "core/simulation_step.hpp"

namespace talus {

template <int D>
Simulation<D>::Simulation(Scene<D> scene)
    : scene_(std::move(scene)), particles_(scene_.layout()), grid_(scene_.periods), pass_(scene_) {
  for (auto& material : scene_.materials) material->bind(particles_.layout());
  momentum_.walls.assign(scene_.walls.size(), Point<D>::Zero());
}

template <int D>
Simulation<D>::~Simulation() = default;

template <int D>
void Simulation<D>::begin() {
  measure();
  sort();
  if (scene_.keeps_ledger) ledger_.start = ledger_.now = totals();
}

template <int D>
void Simulation<D>::resume(std::vector<std::uint64_t> keys, Reached<D> reached) {
  measure();
  grid_.build(std::move(keys));
  resize();
  scattered_for_ = 0;
  time_ = reached.time;
  steps_ = reached.steps;
  drift_ = reached.drift;
  mass_ = reached.mass;
  motion_ = reached.motion;
  momentum_ = std::move(reached.momentum);
  ledger_ = reached.ledger;
}

template <int D>
void Simulation<D>::sort() {
  particles_.sort(grid_, scene_.spacing, scene_.stages->base_shift);
  resize();
  drift_ = 0;
  scattered_for_ = 0;
  ++sorts_;
  if (scene_.keeps_ledger) ledger_.now.first_moment = totals().first_moment;  // a period may have been taken off
}

template class Particles<2>;
template class Particles<3>;
template class Simulation<2>;
template class Simulation<3>;
template void fill<2>(Simulation<2>&, std::vector<Filling<2>> const&);
template void fill<3>(Simulation<3>&, std::vector<Filling<3>> const&);

}  // namespace talus
