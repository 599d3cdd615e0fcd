#pragma once
/// The work of a step twice over: kernel by kernel on every block, as Talus takes it, and fused.

#include <memory>
#include <utility>
#include <vector>

#include "benchmarks/scenes/compose.hpp"
#include "benchmarks/scenes/formulations.hpp"
#include "core/grid_pass.hpp"

namespace talus::bench {

/// Elastic APIC in a simulation's own blocks, on one thread. The step is so short that no particle moves.
template <int D, class K>
class WholeStep {
 public:
  using F = Of<D, K>;
  using Law = law::Hencky;
  using Shape = typename F::Kinematics::Shape;

  explicit WholeStep(Cloud<D> const& cloud)
      : simulation_(simulate<F>(setup<F>(cloud.spacing), {cloud}, corner<D>(cloud.low))), pass_(simulation_->scene()) {
    pass_.resize(grid(), 1);
    auto const chunks = static_cast<std::size_t>(simulation_->particles().most_chunks_of_a_run());
    loads_.resize(chunks);
    gradients_.resize(chunks);
    told_.resize(pass_.told_size());
    summed_.assign(pass_.summed_size(), NodeVector(0.0));
    walls_.assign(simulation_->scene().walls.size(), Point<D>::Zero());
  }

  [[nodiscard]] double particles() const { return static_cast<double>(simulation_->particles().count()); }

  /// Three kernels a block, each called through its interface, with their results between them in memory.
  void by_block() {
    step([&](Batch<D> const& batch) {
      Stages<D> const& stages = *simulation_->scene().stages;
      stages.gather(batch, told_.data(), dt, gradients_.data(), motion_);
      simulation_->scene().materials.front()->update(batch, gradients_.data(), dt, motion_, loads_.data(), false,
                                                     nullptr);
      stages.scatter(batch, loads_.data(), dt, summed_.data());
    });
  }

  /// One kernel, chunk by chunk, in which everything is known to the compiler and nothing goes through memory.
  void fused() {
    step([&](Batch<D> const& batch) { fused(batch); });
  }

 private:
  static constexpr double dt = 1e-30;

  [[nodiscard]] BlockGrid<D> const& grid() const { return simulation_->grid(); }

  [[gnu::flatten]] void fused(Batch<D> const& batch) {
    Largest largest;
    for (int c = 0; c < batch.count; ++c) {
      Matrix<Lanes, D> H;
      gather_chunk<D, K, Gather{.affine = true}>(batch, c, told_.data(), dt, 0, &H, largest);
      Lanes* chunk = batch.chunk(c);
      Symmetric<Lanes, Shape> eps;
      for (int k = 0; k < eps.size; ++k) eps[k] = chunk[batch.at.strain + k];
      eps = trial_strain(eps, H);
      for (int k = 0; k < eps.size; ++k) chunk[batch.at.strain + k] = eps[k];
      auto const tau = law_.stress(eps);
      Lanes const volume = chunk[batch.at.mass] * Lanes(1 / density);
      Load<D> load;
      for (int i = 0; i < D; ++i)
        for (int j = i; j < D; ++j) load.force(i, j) = volume * tau(i, j);
      scatter_chunk<D, K, Scatter{.affine = true}>(batch, c, &load, dt, summed_.data());
    }
    motion_.speed = horizontal_max(largest.speed);
    motion_.gradient = horizontal_max(largest.gradient);
  }

  /// Calls `kernels` for every block, between what the grid does.
  template <class Kernels>
  void step(Kernels const& kernels) {
    pass_.move(grid(), 0, dt, walls_);
    auto& particles = simulation_->particles();
    for (int colour = 0; colour < BlockGrid<D>::colours; ++colour)
      for (std::int32_t const b : grid().coloured(colour)) {
        auto const block = static_cast<std::size_t>(b);
        pass_.load(grid(), block, told_.data());
        for (std::size_t r = particles.first_run(block); r < particles.first_run(block + 1); ++r)
          kernels(particles.batch(particles.runs()[r], simulation_->scene().spacing, grid().particle_block(block)));
        pass_.add(grid(), block, summed_.data());
      }
  }

  std::unique_ptr<Simulation<D>> simulation_;
  GridPass<D> pass_;
  Law law_{Law::Parameters{}};
  Motion motion_;
  Impulses<D> walls_;
  std::vector<NodeVector> told_, summed_;
  std::vector<Load<D>> loads_;
  std::vector<Matrix<Lanes, D>> gradients_;
};

}  // namespace talus::bench
