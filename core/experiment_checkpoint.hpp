#pragma once
/// Checkpoints of an experiment: what core/experiment_of.hpp declares.

#include "core/experiment_of.hpp"

namespace talus {

/// Calls f(number) for every number of a ledger, always in the same order.
template <class Ledger, class F>
void for_each_number(Ledger& ledger, F const& f) {
  auto const vector = [&](auto& v) {
    for (auto& number : v) f(number);
  };
  for (auto* totals : {&ledger.start, &ledger.now}) {
    for (auto* number : {&totals->kinetic, &totals->elastic, &totals->second_moment}) f(*number);
    for (auto* v : {&totals->momentum, &totals->first_moment}) vector(*v);
    vector(totals->spin);
  }
  f(ledger.body_force.work);
  vector(ledger.body_force.impulse);
  vector(ledger.body_force.torque);
  for (auto* number : {&ledger.gravity, &ledger.walls, &ledger.plastic, &ledger.transfer, &ledger.stepping}) f(*number);
  for (auto* v : {&ledger.gravity_torque, &ledger.wall_torque, &ledger.transfer_spin}) vector(*v);
}

template <int D>
io::Checkpoint ExperimentOf<D>::checkpoint() const {
  io::Checkpoint saved{state(), {}};
  std::vector<std::int64_t> keys, blocks, materials, counts;
  for (std::uint64_t key : simulation_->grid().particle_keys()) keys.push_back(static_cast<std::int64_t>(key));
  for (Run const& run : simulation_->particles().runs()) {
    blocks.push_back(run.block);
    materials.push_back(run.material);
    counts.push_back(run.particles);
  }
  std::vector<double> momentum(simulation_->momentum().gravity.begin(), simulation_->momentum().gravity.end());
  for (Point<D> const& impulse : simulation_->momentum().walls)
    momentum.insert(momentum.end(), impulse.begin(), impulse.end());
  std::vector<double> ledger;
  for_each_number(simulation_->ledger(), [&](double number) { ledger.push_back(number); });
  saved.values = {{"block_keys", keys},
                  {"ledger", ledger},
                  {"run_blocks", blocks},
                  {"run_materials", materials},
                  {"run_particles", counts},
                  {"drift", simulation_->drift()},
                  {"speed", simulation_->motion().speed},
                  {"gradient", simulation_->motion().gradient},
                  {"momentum", momentum},
                  {"first_front", first_front_}};
  return saved;
}

template <int D>
void ExperimentOf<D>::restore(io::Checkpoint const& saved) {
  using Integers = std::vector<std::int64_t>;
  auto const& keys = saved.value<Integers>("block_keys");
  auto const& blocks = saved.value<Integers>("run_blocks");
  auto const& materials = saved.value<Integers>("run_materials");
  auto const& counts = saved.value<Integers>("run_particles");
  auto const& numbers = saved.value<std::vector<double>>("momentum");
  auto& particles = simulation_->particles();
  std::vector<Run> runs;
  for (std::size_t r = 0; r < blocks.size(); ++r)
    runs.push_back({static_cast<std::int32_t>(blocks[r]), static_cast<std::int32_t>(materials[r]), 0,
                    static_cast<int>(counts[r])});
  std::vector<std::uint64_t> const places(keys.begin(), keys.end());
  std::size_t const walls = simulation_->scene().walls.size();
  if (saved.particles.dimension != D || numbers.size() != D * (walls + 1))
    throw CheckpointError("the checkpoint is of another dimension or has other walls than the case");
  particles.allocate(std::move(runs), places.size());
  if (particles.count() != saved.particles.particles())
    throw CheckpointError("the checkpoint's runs do not add up to its particles");
  for (Column const& column : particles.layout().columns()) {
    NamedColumn const* named = saved.particles.find(column.info.name);
    if (named == nullptr || named->components != column.components)
      throw CheckpointError("the checkpoint does not hold the field '" + std::string(column.info.name) +
                            "' as the case needs it");
    std::size_t next = 0;
    particles.for_each([&](std::ptrdiff_t slot, int) {
      for (int k = 0; k < column.components; ++k) particles.set(slot, column.offset + k, named->values[next++]);
    });
  }
  Ledger<D> ledger;
  auto const& entries = saved.value<std::vector<double>>("ledger");
  std::size_t next_entry = 0;
  for_each_number(ledger, [&](double& number) {
    if (next_entry == entries.size()) throw CheckpointError("the checkpoint's ledger is not whole");
    number = entries[next_entry++];
  });
  Momentum<D> momentum;
  momentum.walls.assign(walls, Point<D>::Zero());
  for (int d = 0; d < D; ++d) momentum.gravity[d] = numbers[static_cast<std::size_t>(d)];
  for (std::size_t w = 0; w < walls; ++w)
    for (int d = 0; d < D; ++d) momentum.walls[w][d] = numbers[(w + 1) * D + static_cast<std::size_t>(d)];
  simulation_->resume(places, saved.particles.time, static_cast<long>(saved.particles.step),
                      saved.value<double>("drift"),
                      {.speed = saved.value<double>("speed"), .gradient = saved.value<double>("gradient")},
                      std::move(momentum), ledger);
  first_front_ = saved.value<double>("first_front");
}

}  // namespace talus
