#pragma once
/// The stages of a step, each by itself on blocks that are in the near cache. All that touches the inside of a
/// simulation is in this file.

#include <memory>
#include <utility>
#include <vector>

#include "benchmarks/scenes/compete.hpp"
#include "benchmarks/scenes/compose.hpp"
#include "benchmarks/scenes/formulations.hpp"
#include "core/grid_pass.hpp"

namespace talus::bench {

/// A simulation whose stages can be called one by one.
template <int D>
class Prepared {
 public:
  explicit Prepared(std::unique_ptr<Simulation<D>> simulation)
      : simulation_(std::move(simulation)), pass_(simulation_->scene()) {
    simulation_->begin();
    dt_ = simulation_->next(1).dt;
    pass_.resize(grid(), 1);
    auto const chunks = static_cast<std::size_t>(simulation_->particles().most_chunks_of_a_run());
    loads_.resize(chunks * runs().size());
    gradients_.resize(chunks * runs().size());
    told_.resize(pass_.told_size());
    summed_.assign(pass_.summed_size(), NodeVector(0.0));
    load();
    scatter();
    grid_pass();
    gather();
  }

  [[nodiscard]] std::size_t particles() const { return simulation_->particles().count(); }

  /// Stress of every particle.
  void load() {
    for_each_run([&](Run const&, Batch<D> const& batch, std::size_t first) {
      material().load(batch, stages().friction, &loads_[first]);
    });
  }
  void scatter() {
    for_each_run([&](Run const&, Batch<D> const& batch, std::size_t first) {
      stages().scatter(batch, &loads_[first], dt_, summed_.data());
    });
  }
  /// Arenas added to the nodes, nodes moved, arenas loaded.
  void grid_pass() {
    Impulses<D> impulses(simulation_->scene().walls.size(), Point<D>::Zero());
    for (std::size_t b = 0; b < grid().particle_blocks(); ++b) pass_.add(grid(), b, summed_.data());
    pass_.move(grid(), simulation_->time(), dt_, impulses);
    for (std::size_t b = 0; b < grid().particle_blocks(); ++b) pass_.load(grid(), b, told_.data());
  }
  /// Particles would leave their blocks after some calls, so the nodes are at rest: the same work, and nothing
  /// moves.
  void gather() {
    std::fill(told_.begin(), told_.end(), NodeVector(0.0));
    for_each_run([&](Run const&, Batch<D> const& batch, std::size_t first) {
      stages().gather(batch, told_.data(), dt_, &gradients_[first], motion_);
    });
  }
  /// Trial strain and return map.
  void law() {
    for_each_run([&](Run const&, Batch<D> const& batch, std::size_t first) {
      material().update(batch, &gradients_[first], dt_, motion_, nullptr, false, nullptr);
    });
  }
  void sort() { simulation_->begin(); }

  /// What strains every particle in each `law` from now on: dt dv_x/dy and dt dv_y/dy [1].
  void shear(double across, double along) {
    for (auto& gradient : gradients_) {
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) gradient(i, j) = Lanes(0.0);
      gradient(0, 1) = Lanes(across);
      gradient(1, 1) = Lanes(along);
    }
  }

 private:
  [[nodiscard]] BlockGrid<D> const& grid() const { return simulation_->grid(); }
  [[nodiscard]] Stages<D> const& stages() const { return *simulation_->scene().stages; }
  [[nodiscard]] Material<D> const& material() const { return *simulation_->scene().materials.front(); }
  [[nodiscard]] std::vector<Run> const& runs() const { return simulation_->particles().runs(); }

  template <class F>
  void for_each_run(F const& f) {
    std::size_t first = 0;
    for (Run const& run : runs()) {
      auto const place = grid().particle_block(static_cast<std::size_t>(run.block));
      f(run, simulation_->particles().batch(run, simulation_->scene().spacing, place), first);
      first += static_cast<std::size_t>(run.chunks());
    }
  }

  std::unique_ptr<Simulation<D>> simulation_;
  GridPass<D> pass_;
  double dt_ = 0;
  Motion motion_;
  std::vector<NodeVector> told_, summed_;
  std::vector<Load<D>> loads_;
  std::vector<Matrix<Lanes, D>> gradients_;
};

}  // namespace talus::bench
