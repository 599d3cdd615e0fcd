#pragma once
/// The particles of a scene: chunks of one pack width, grouped by grid block and material.

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "core/block_grid.hpp"
#include "core/layout.hpp"

namespace talus {

/// The particles of one material in one block: `particles` of them from chunk `first_chunk` on.
struct Run {
  std::int32_t block = 0, material = 0;
  std::ptrdiff_t first_chunk = 0;
  int particles = 0;
  [[nodiscard]] int chunks() const { return (particles + lanes - 1) / lanes; }
};

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
  [[nodiscard]] int most_chunks_of_a_run() const { return most_chunks_; }
  [[nodiscard]] std::size_t bytes() const { return (data_.size() + spare_.size()) * sizeof(Lanes); }

  /// What a kernel sees of a run.
  [[nodiscard]] Batch<D> batch(Run const& run, double spacing, BlockIndex<D> const& block) {
    Batch<D> b;
    b.chunks = data_.data() + run.first_chunk * layout_.packs();
    b.count = run.chunks();
    b.ahead = b.chunks + static_cast<std::ptrdiff_t>(b.count) * layout_.packs();
    b.particles = run.particles;
    b.stride = layout_.packs();
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
  struct Bin {
    std::uint64_t key;
    std::int32_t cell, material;
  };
  Bin bin_of(BlockGrid<D> const& grid, double spacing, double base_shift, std::ptrdiff_t slot, int material);
  void lay_out(std::size_t blocks);
  void move_to_spare(std::vector<std::ptrdiff_t> const& slots);
  void park_empty_lanes(BlockGrid<D> const& grid, double spacing, double base_shift);

  Layout layout_;
  FieldOffsets places_;
  std::size_t count_ = 0;
  std::ptrdiff_t chunks_ = 0;
  int most_chunks_ = 0;
  std::vector<Run> runs_;
  std::vector<std::size_t> first_run_;
  std::vector<Lanes> data_, spare_;
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
typename Particles<D>::Bin Particles<D>::bin_of(BlockGrid<D> const& grid, double spacing, double base_shift,
                                                std::ptrdiff_t slot, int material) {
  BlockIndex<D> place{};
  std::int32_t cell = 0;
  for (int d = 0; d < D; ++d) {
    double const x = get(slot, places_.position + d), base = std::floor(x / spacing - base_shift + 0.5);
    if (!(std::abs(base) < double(block_edge) * (farthest_block - 2)))
      throw RunError("particle " + std::to_string(static_cast<long>(get(slot, places_.identity))) +
                     " is outside the space that can be addressed: coordinate " + std::to_string(d) + " is " +
                     std::to_string(x) + " m");
    place[static_cast<std::size_t>(d)] = static_cast<std::int32_t>(std::floor(base / block_edge));
    cell = cell * block_edge + static_cast<std::int32_t>(base) - block_edge * place[static_cast<std::size_t>(d)];
  }
  BlockIndex<D> const wrapped = grid.wrap(place);
  for (int d = 0; d < D; ++d)
    if (int const shift = wrapped[static_cast<std::size_t>(d)] - place[static_cast<std::size_t>(d)]; shift != 0)
      set(slot, places_.position + d, get(slot, places_.position + d) + shift * block_edge * spacing);
  return {key_of<D>(wrapped), cell, material};
}

template <int D>
void Particles<D>::sort(BlockGrid<D>& grid, double spacing, double base_shift) {
  constexpr std::int32_t cells = D == 2 ? block_edge * block_edge : block_edge * block_edge * block_edge;
  std::vector<Bin> bins;
  std::vector<std::ptrdiff_t> slots;
  std::vector<std::uint64_t> keys;
  std::int32_t materials = 1;
  bins.reserve(count_);
  slots.reserve(count_);
  for_each([&](std::ptrdiff_t slot, std::int32_t material) {
    bins.push_back(bin_of(grid, spacing, base_shift, slot, material));
    slots.push_back(slot);
    if (keys.empty() || keys.back() != bins.back().key) keys.push_back(bins.back().key);
    materials = std::max(materials, material + 1);
  });
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  grid.build(keys);

  // Counting sort by (block, material, cell); equal ones keep their order.
  std::vector<std::size_t> rank(bins.size());
  std::vector<std::size_t> start(keys.size() * static_cast<std::size_t>(materials * cells) + 1, 0);
  std::size_t block = 0;
  for (std::size_t k = 0; k < bins.size(); ++k) {
    if (keys[block] != bins[k].key)
      block = static_cast<std::size_t>(std::lower_bound(keys.begin(), keys.end(), bins[k].key) - keys.begin());
    rank[k] = (block * static_cast<std::size_t>(materials) + static_cast<std::size_t>(bins[k].material)) *
                  static_cast<std::size_t>(cells) +
              static_cast<std::size_t>(bins[k].cell);
    ++start[rank[k] + 1];
  }
  for (std::size_t k = 1; k < start.size(); ++k) start[k] += start[k - 1];
  runs_.clear();
  for (std::size_t b = 0; b < keys.size(); ++b)
    for (std::int32_t m = 0; m < materials; ++m) {
      std::size_t const at = (b * static_cast<std::size_t>(materials) + static_cast<std::size_t>(m)) * cells;
      if (auto const n = start[at + cells] - start[at]; n > 0)
        runs_.push_back({static_cast<std::int32_t>(b), m, 0, static_cast<int>(n)});
    }
  std::vector<std::ptrdiff_t> ordered(slots.size());
  for (std::size_t k = 0; k < slots.size(); ++k) ordered[start[rank[k]]++] = slots[k];
  lay_out(keys.size());
  move_to_spare(ordered);
  data_.swap(spare_);
  park_empty_lanes(grid, spacing, base_shift);
}

template <int D>
void Particles<D>::move_to_spare(std::vector<std::ptrdiff_t> const& slots) {
  spare_.assign(static_cast<std::size_t>(chunks_ * layout_.packs()), Lanes(0.0));
  auto const* from = reinterpret_cast<double const*>(data_.data());
  auto* to = reinterpret_cast<double*>(spare_.data());
  std::ptrdiff_t const stride = static_cast<std::ptrdiff_t>(layout_.packs()) * lanes;
  std::size_t k = 0;
  for_each([&](std::ptrdiff_t slot, int) {
    double const* source = from + slots[k] / lanes * stride + slots[k] % lanes;
    double* target = to + slot / lanes * stride + slot % lanes;
    ++k;
    for (int pack = 0; pack < layout_.packs(); ++pack) target[pack * lanes] = source[pack * lanes];
  });
}

template <int D>
void Particles<D>::park_empty_lanes(BlockGrid<D> const& grid, double spacing, double base_shift) {
  for (Run const& run : runs_) {
    BlockIndex<D> const block = grid.particle_block(static_cast<std::size_t>(run.block));
    for (int k = run.particles; k < run.chunks() * lanes; ++k)
      for (int d = 0; d < D; ++d)
        set(run.first_chunk * lanes + k, places_.position + d,
            spacing * (block_edge * (block[static_cast<std::size_t>(d)] + 0.5) + base_shift));
  }
}

}  // namespace talus
