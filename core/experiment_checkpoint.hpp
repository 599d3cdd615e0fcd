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
                  {"mass", simulation_->mass()},
                  {"speed", simulation_->motion().speed},
                  {"gradient", simulation_->motion().gradient},
                  {"momentum", momentum},
                  {"first_front", first_front_},
                  {"last_dt", last_dt_}};
  return saved;
}

}  // namespace talus
