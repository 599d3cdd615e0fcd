#pragma once
/// An experiment goes on from a checkpoint, which is believed nothing that could lead it out of its memory.

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/experiment_checkpoint.hpp"

namespace talus {

namespace detail {

using Integers = std::vector<std::int64_t>;

inline void require(bool fulfilled, char const* fault) {
  if (!fulfilled) throw CheckpointError(fault);
}

/// Keys of the blocks: each once, in order, within reach and within the period.
template <int D>
std::vector<std::uint64_t> blocks_of(io::Checkpoint const& saved, BlockIndex<D> const& periods) {
  auto const& keys = saved.value<Integers>("block_keys");
  for (std::size_t b = 0; b < keys.size(); ++b) {
    bool good = keys[b] >= 0 && (b == 0 || keys[b] > keys[b - 1]);
    BlockIndex<D> const place = place_of<D>(static_cast<std::uint64_t>(std::max<std::int64_t>(keys[b], 0)));
    for (std::size_t d = 0; d < D; ++d)
      good = good && std::abs(place[d]) < farthest_block - 1 &&
             (periods[d] == 0 || (place[d] >= 0 && place[d] < periods[d]));
    require(good && key_of<D>(place) == static_cast<std::uint64_t>(keys[b]),
            "its blocks are no blocks of the case's grid");
  }
  return {keys.begin(), keys.end()};
}

/// Runs of particles: every block has some, block by block and material by material.
inline std::vector<Run> runs_of(io::Checkpoint const& saved, std::size_t blocks, std::size_t materials) {
  auto const& block = saved.value<Integers>("run_blocks");
  auto const& material = saved.value<Integers>("run_materials");
  auto const& count = saved.value<Integers>("run_particles");
  require(material.size() == block.size() && count.size() == block.size(), "its lists of runs differ in length");
  std::vector<Run> runs;
  std::int64_t last_block = -1, last_material = -1;
  for (std::size_t r = 0; r < block.size(); ++r) {
    bool const same_block = block[r] == last_block && material[r] > last_material;
    bool const known = block[r] >= 0 && material[r] >= 0 && material[r] < static_cast<std::int64_t>(materials);
    require((same_block || block[r] == last_block + 1) && known, "its runs of particles are not in order");
    require(count[r] > 0 && count[r] <= std::numeric_limits<int>::max(), "it has a run without particles");
    runs.push_back(
        {static_cast<std::int32_t>(block[r]), static_cast<std::int32_t>(material[r]), 0, static_cast<int>(count[r])});
    last_block = block[r];
    last_material = material[r];
  }
  require(last_block + 1 == static_cast<std::int64_t>(blocks), "its runs of particles are not those of its blocks");
  return runs;
}

/// Takes over every field that the case stores.
template <int D>
void fill_fields(Snapshot const& saved, Particles<D>& particles) {
  for (Column const& column : particles.layout().columns()) {
    NamedColumn const* named = saved.find(column.info.name);
    std::size_t const size = particles.count() * static_cast<std::size_t>(column.components);
    if (named == nullptr || named->components != column.components || named->values.size() != size)
      throw CheckpointError("it does not hold the field '" + std::string(column.info.name) + "' as the case needs it");
    std::size_t next = 0;
    particles.for_each([&](std::ptrdiff_t slot, int) {
      for (int k = 0; k < column.components; ++k) particles.set(slot, column.offset + k, named->values[next++]);
    });
  }
}

/// Every particle has a number of its own and a mass.
template <int D>
void require_identities(Particles<D> const& particles) {
  constexpr double most = 9007199254740992;  // 2^53: whole numbers are exact up to here
  int const id = particles.layout().find(field::identity), mass = particles.layout().find(field::mass);
  std::vector<double> ids;
  particles.for_each([&](std::ptrdiff_t slot, int) {
    ids.push_back(particles.get(slot, id));
    require(ids.back() >= 0 && ids.back() < most && ids.back() == std::floor(ids.back()), "a particle has no number");
    double const m = particles.get(slot, mass);
    require(m > 0 && is_finite(m), "a particle has no mass");
  });
  std::sort(ids.begin(), ids.end());
  require(std::adjacent_find(ids.begin(), ids.end()) == ids.end(), "two particles have the same number");
}

/// Every particle lies where its block's arena reaches, if it is not sorted anew before it is needed.
template <int D>
void require_places(Particles<D> const& particles, std::vector<std::uint64_t> const& keys, Scene<D> const& scene,
                    double drift) {
  constexpr double margin = 1e-7;  // for rounding; less than the drift's, so that no state of ours is refused
  int const position = particles.layout().find(field::position);
  for (Run const& run : particles.runs()) {
    BlockIndex<D> const block = place_of<D>(keys[static_cast<std::size_t>(run.block)]);
    for (std::ptrdiff_t slot = run.first_chunk * lanes; slot < run.first_chunk * lanes + run.particles; ++slot)
      for (int d = 0; d < D; ++d) {
        double const x = particles.get(slot, position + d);
        double const cell =
            x / scene.spacing - scene.stages->base_shift - block_edge * block[static_cast<std::size_t>(d)];
        bool const reached = cell >= margin - 1 && cell <= block_edge - margin;
        require(is_finite(x) && (reached || drift > drift_limit), "a particle is not where its block is");
      }
  }
}

template <int D>
Momentum<D> momentum_of(io::Checkpoint const& saved, std::size_t walls) {
  auto const& numbers = saved.value<std::vector<double>>("momentum");
  require(numbers.size() == D * (walls + 1), "it has other walls than the case");
  Momentum<D> momentum;
  momentum.walls.assign(walls, Point<D>::Zero());
  for (std::size_t d = 0; d < D; ++d) {
    momentum.gravity[static_cast<int>(d)] = numbers[d];
    for (std::size_t w = 0; w < walls; ++w) momentum.walls[w][static_cast<int>(d)] = numbers[(w + 1) * D + d];
  }
  return momentum;
}

template <int D>
Ledger<D> ledger_of(io::Checkpoint const& saved) {
  auto const& entries = saved.value<std::vector<double>>("ledger");
  Ledger<D> ledger;
  std::size_t next = 0;
  for_each_number(ledger, [&](double& number) {
    require(next < entries.size(), "its ledger is not whole");
    number = entries[next++];
  });
  return ledger;
}

/// A finite value that is zero or more.
inline double size_in(io::Checkpoint const& saved, char const* name) {
  double const value = saved.value<double>(name);
  if (!(value >= 0 && is_finite(value)))
    throw CheckpointError("its '" + std::string(name) + "' is no number from 0 on");
  return value;
}

}  // namespace detail

template <int D>
void ExperimentOf<D>::restore(io::Checkpoint const& saved) {
  Scene<D> const& scene = simulation_->scene();
  Snapshot const& state = saved.particles;
  detail::require(state.dimension == D, "it is of another dimension than the case");
  bool const counted = state.step >= 0 && state.step < std::int64_t{1} << 53;  // longer than any run
  detail::require(state.time >= 0 && is_finite(state.time) && counted, "its time is no time of a run");
  auto const keys = detail::blocks_of<D>(saved, scene.periods);
  auto runs = detail::runs_of(saved, keys.size(), scene.materials.size());
  std::size_t count = 0;
  for (Run const& run : runs) count += static_cast<std::size_t>(run.particles);
  NamedColumn const* const id = state.find(field::identity.name);
  detail::require(id != nullptr && id->values.size() == count, "its runs do not add up to its particles");

  auto& particles = simulation_->particles();
  double const drift = detail::size_in(saved, "drift");
  particles.allocate(std::move(runs), keys.size());
  detail::fill_fields(state, particles);
  detail::require_identities(particles);
  detail::require_places(particles, keys, scene, drift);
  double const first_front = saved.value<double>("first_front"), last_dt = detail::size_in(saved, "last_dt");
  simulation_->resume(
      keys, {.time = state.time,
             .drift = drift,
             .steps = static_cast<long>(state.step),
             .mass = detail::size_in(saved, "mass"),
             .motion = {.speed = detail::size_in(saved, "speed"), .gradient = detail::size_in(saved, "gradient")},
             .momentum = detail::momentum_of<D>(saved, scene.walls.size()),
             .ledger = detail::ledger_of<D>(saved)});
  first_front_ = first_front;
  last_dt_ = last_dt;
}

}  // namespace talus
