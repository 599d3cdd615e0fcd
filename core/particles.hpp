#pragma once
/// The particles of a scene: chunks of one pack width, grouped by grid block and material.

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "core/layout.hpp"
#include "core/particle_sort.hpp"

namespace talus {

/// Storage, order and the drift since the last sort. Fields are those of the layout, all doubles.
template <int D>
class Particles {
 public:
  explicit Particles(Layout layout) : layout_(std::move(layout)) {
    places_ = {layout_.find(field::position),  layout_.find(field::velocity),   layout_.find(field::mass),
               layout_.find("elastic_strain"), layout_.find("affine_velocity"), layout_.find(field::identity)};
  }

  [[nodiscard]] Layout const& layout() const { return layout_; }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::vector<Run> const& runs() const { return runs_; }
  /// Runs of block b: first_run(b) ... first_run(b + 1) - 1.
  [[nodiscard]] std::size_t first_run(std::size_t block) const { return first_run_[block]; }
  [[nodiscard]] std::ptrdiff_t chunks() const { return chunks_; }
  [[nodiscard]] int most_chunks_of_a_run() const { return most_chunks_; }
  [[nodiscard]] std::size_t bytes() const {
    return (data_.capacity() + spare_.capacity()) * sizeof(Lanes) + sort_.bytes();
  }

  /// What a kernel sees of a run.
  [[nodiscard]] Batch<D> batch(Run const& run, double spacing, BlockIndex<D> const& block) {
    Batch<D> b;
    b.chunks = data_.data() + run.first_chunk * layout_.packs();
    b.count = run.chunks();
    b.ahead = b.chunks + static_cast<std::ptrdiff_t>(b.count) * layout_.packs();
    b.particles = run.particles;
    b.stride = layout_.packs();
    b.used = b.stride - (places_.identity == b.stride - 1 ? 1 : 0);
    b.at = places_;
    b.spacing = spacing;
    for (std::size_t d = 0; d < D; ++d) b.first[d] = block_edge * double(block[d]) - 1;
    return b;
  }

  /// First chunk of a block.
  [[nodiscard]] Lanes const* chunks_of(std::size_t block) const {
    return data_.data() + runs_[first_run_[block]].first_chunk * layout_.packs();
  }

  /// One number of a particle; `slot` is its run's first chunk * lanes + its place in the run.
  [[nodiscard]] double get(std::ptrdiff_t slot, int pack) const {
    return data_[static_cast<std::size_t>(slot / lanes * layout_.packs() + pack)][static_cast<int>(slot % lanes)];
  }
  void set(std::ptrdiff_t slot, int pack, double value) {
    data_[static_cast<std::size_t>(slot / lanes * layout_.packs() + pack)].set(static_cast<int>(slot % lanes), value);
  }

  /// Positions of chunk c [m].
  [[nodiscard]] Lanes const* position(std::ptrdiff_t c) const {
    return data_.data() + c * layout_.packs() + places_.position;
  }
  [[nodiscard]] double position(std::ptrdiff_t slot, int d) const { return get(slot, places_.position + d); }
  void move(std::ptrdiff_t slot, int d, double by) { set(slot, places_.position + d, position(slot, d) + by); }
  [[nodiscard]] long identity(std::ptrdiff_t slot) const { return static_cast<long>(get(slot, places_.identity)); }

  /// Makes room for runs of particles in this order, all fields zero; the caller fills them in.
  void allocate(std::vector<Run> runs, std::size_t blocks) {
    runs_ = std::move(runs);
    lay_out(blocks);
    data_.assign(static_cast<std::size_t>(chunks_ * layout_.packs()), Lanes(0.0));
  }

  /// Calls f(slot, material) for every particle, in storage order.
  template <class F>
  void for_each(F const& f) const {
    for (Run const& run : runs_)
      for (int k = 0; k < run.particles; ++k) f(run.first_chunk * lanes + k, run.material);
  }

  /// Groups the particles by block (of their stencil's first node, or the next one where that is nearer), material and
  /// cell; brings them back into the period. Throws RunError for a particle that is not finite or too far away to be addressed.
  void sort(BlockGrid<D>& grid, double spacing, double base_shift);

 private:
  void lay_out(std::size_t blocks);
  void move_to_spare(Run const& run, std::ptrdiff_t const* slots);
  void park_empty_lanes(Run const& run, BlockIndex<D> const& block, double spacing, double base_shift);

  Layout layout_;
  FieldOffsets places_;
  std::size_t count_ = 0;
  std::ptrdiff_t chunks_ = 0;
  int most_chunks_ = 0;
  std::vector<Run> runs_;
  std::vector<std::size_t> first_run_;
  std::vector<Lanes> data_, spare_;
  ParticleSort<D> sort_;
};

template <int D>
void Particles<D>::lay_out(std::size_t blocks) {
  first_run_.assign(blocks + 1, 0);
  chunks_ = 0;
  most_chunks_ = 0;
  count_ = 0;
  for (Run& run : runs_) {
    run.first_chunk = chunks_;
    chunks_ += run.chunks();
    most_chunks_ = std::max(most_chunks_, run.chunks());
    count_ += static_cast<std::size_t>(run.particles);
    ++first_run_[static_cast<std::size_t>(run.block) + 1];
  }
  for (std::size_t b = 0; b < blocks; ++b) first_run_[b + 1] += first_run_[b];
}

template <int D>
void Particles<D>::sort(BlockGrid<D>& grid, double spacing, double base_shift) {
  sort_.find(*this, grid, spacing, base_shift);
  runs_ = sort_.runs();
  lay_out(grid.particle_blocks());
  auto const packs = static_cast<std::size_t>(chunks_ * layout_.packs());
  if (packs > spare_.capacity()) {  // with some to spare, and nothing to copy
    spare_ = std::vector<Lanes>();
    spare_.reserve(packs + packs / 16);
  }
  spare_.resize(packs);
  for_each_index(static_cast<std::ptrdiff_t>(runs_.size()), [&](std::ptrdiff_t r) {
    Run const& run = runs_[static_cast<std::size_t>(r)];
    move_to_spare(run, sort_.slots(static_cast<std::size_t>(r)));
    park_empty_lanes(run, grid.particle_block(static_cast<std::size_t>(run.block)), spacing, base_shift);
  });
  data_.swap(spare_);
}

template <int D>
void Particles<D>::move_to_spare(Run const& run, std::ptrdiff_t const* slots) {
  auto const* const from = reinterpret_cast<double const*>(data_.data());
  std::ptrdiff_t const packs = layout_.packs(), stride = packs * lanes;
  for (int c = 0; c < run.chunks(); ++c) {
    auto* const chunk = reinterpret_cast<double*>(spare_.data() + (run.first_chunk + c) * packs);
    int const filled = std::min(lanes, run.particles - c * lanes);
    for (int lane = 0; lane < filled; ++lane) {
      std::ptrdiff_t const slot = slots[c * lanes + lane];
      double const* source = from + slot / lanes * stride + slot % lanes;
      for (std::ptrdiff_t k = 0; k < stride; k += lanes) chunk[k + lane] = source[k];
    }
  }
}

/// Empty lanes are zero but for their place, in the middle of the block.
template <int D>
void Particles<D>::park_empty_lanes(Run const& run, BlockIndex<D> const& block, double spacing, double base_shift) {
  int const filled = run.particles - (run.chunks() - 1) * lanes;
  Lanes* const last = spare_.data() + (run.first_chunk + run.chunks() - 1) * layout_.packs();
  for (int lane = filled; lane < lanes; ++lane) {
    for (int k = 0; k < layout_.packs(); ++k) last[k].set(lane, 0);
    for (int d = 0; d < D; ++d)
      last[places_.position + d].set(lane,
                                     spacing * (block_edge * (block[static_cast<std::size_t>(d)] + 0.5) + base_shift));
  }
}

extern template class Particles<2>;  // core/simulation.cpp
extern template class Particles<3>;

}  // namespace talus
