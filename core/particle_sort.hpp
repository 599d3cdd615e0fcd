#pragma once
/// The order in which particles are stored: by block, material and cell; equal ones stay as they were.
///
/// A counting sort. Since the last one a particle has drifted by half a cell at most, so that its block is the old one
/// or a neighbour: which one, and the cell in it, are computed for a chunk at once, and a block is looked up once for all
/// that took the same way. Only strays, whose block was not known, are looked up one by one.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/block_grid.hpp"
#include "core/parallel.hpp"

namespace talus {

/// The particles of one material in one block: `particles` of them from chunk `first_chunk` on.
struct Run {
  std::int32_t block = 0, material = 0;
  std::ptrdiff_t first_chunk = 0;
  int particles = 0;
  [[nodiscard]] int chunks() const { return (particles + lanes - 1) / lanes; }
};

template <int D>
class Particles;

/// Finds the order. Its memory is kept from sort to sort.
template <int D>
class ParticleSort {
 public:
  /// Builds the grid of the blocks that particles are in now; brings particles back into the period. Throws RunError
  /// for a particle that is not finite or too far away to be addressed.
  void find(Particles<D>& particles, BlockGrid<D>& grid, double spacing, double base_shift) {
    locate(particles, grid, spacing, base_shift);
    look_up_strays(particles, grid, spacing, base_shift);
    follow_ways(particles, grid, spacing);
    std::vector<std::uint64_t> keys = occupied();
    order(particles, keys.size());
    grid.build(std::move(keys));
    strays_ = std::vector<Stray>();  // all particles are, in the first sort
  }

  /// One run for every block and material that has particles; their first chunks are not given yet.
  [[nodiscard]] std::vector<Run> const& runs() const { return runs_; }
  /// Old slots of the particles of run r, in their new order.
  [[nodiscard]] std::ptrdiff_t const* slots(std::size_t r) const { return slots_.data() + first_slot_[r]; }
  [[nodiscard]] std::size_t bytes() const {
    auto const of = [](auto const&... kept) { return ((kept.capacity() * sizeof(kept[0])) + ...); };
    return of(codes_, ways_, start_, slots_, runs_, first_slot_);
  }

 private:
  static constexpr int cells = nodes_per_block<D>;
  static constexpr double farthest_base = double(block_edge) * (farthest_block - 2);
  static constexpr auto neighbours = static_cast<std::size_t>(neighbour_count<D>);

  /// From the block of a run to a neighbour.
  struct Way {
    std::uint64_t key = 0;   ///< of the neighbour
    std::int32_t block = 0;  ///< its new number
    bool taken = false;      ///< by a particle
  };
  struct Stray {
    std::uint64_t key = 0;
    std::int32_t block = 0;
    int cell = 0;
  };

  /// codes_[slot] = neighbour * cells + cell, or -1 for a stray.
  void locate(Particles<D> const& particles, BlockGrid<D> const& grid, double spacing, double base_shift) {
    std::vector<Run> const& runs = particles.runs();
    codes_.resize(static_cast<std::size_t>(particles.chunks() * lanes));
    ways_.assign(runs.size() * neighbours, {});
    for_each_index(static_cast<std::ptrdiff_t>(runs.size()), [&](std::ptrdiff_t r) {
      Run const& run = runs[static_cast<std::size_t>(r)];
      int* const codes = codes_.data() + run.first_chunk * lanes;
      auto const block = static_cast<std::size_t>(run.block);
      if (block >= grid.particle_blocks()) {  // before the first sort there are none
        std::fill(codes, codes + run.particles, -1);
        return;
      }
      for (int c = 0; c < run.chunks(); ++c)
        store_whole(code(particles.position(run.first_chunk + c), grid.particle_block(block), spacing, base_shift),
                    codes + c * lanes);
      Way* const ways = ways_.data() + static_cast<std::size_t>(r) * neighbours;
      for (int k = 0; k < run.particles; ++k)
        if (codes[k] >= 0) ways[codes[k] / cells].taken = true;
    });
  }

  [[nodiscard]] static Lanes code(Lanes const* position, BlockIndex<D> const& block, double spacing,
                                  double base_shift) {
    Lanes neighbour(0.0), cell(0.0);
    auto near = neighbour == cell;
    for (int d = 0; d < D; ++d) {
      Lanes const base = floor(position[d] / Lanes(spacing) - Lanes(base_shift) + Lanes(0.5)),
                  place = floor(base * Lanes(1.0 / block_edge)),
                  step = place - Lanes(double(block[static_cast<std::size_t>(d)]));
      near = near & (abs(step) <= Lanes(1.0)) & (abs(base) < Lanes(farthest_base));
      neighbour = neighbour * Lanes(3.0) + (step + Lanes(1.0));
      cell = cell * Lanes(double(block_edge)) + (base - Lanes(double(block_edge)) * place);
    }
    return select_lanes(near, neighbour * Lanes(double(cells)) + cell, Lanes(-1.0));
  }

  /// codes_[slot] = -1 - number of the stray.
  void look_up_strays(Particles<D>& particles, BlockGrid<D> const& grid, double spacing, double base_shift) {
    strays_.clear();  // what an error left
    particles.for_each([&](std::ptrdiff_t slot, int) {
      int& code = codes_[static_cast<std::size_t>(slot)];
      if (code >= 0) return;
      code = -1 - static_cast<int>(strays_.size());
      strays_.push_back(look_up(particles, grid, spacing, base_shift, slot));
    });
  }

  [[nodiscard]] static Stray look_up(Particles<D>& particles, BlockGrid<D> const& grid, double spacing,
                                     double base_shift, std::ptrdiff_t slot) {
    BlockIndex<D> place{};
    Stray stray;
    for (int d = 0; d < D; ++d) {
      double const x = particles.position(slot, d), base = std::floor(x / spacing - base_shift + 0.5);
      if (!(std::abs(base) < farthest_base))
        throw RunError("particle " + std::to_string(particles.identity(slot)) +
                       " is outside the space that can be addressed: coordinate " + std::to_string(d) + " is " +
                       std::to_string(x) + " m");
      auto& p = place[static_cast<std::size_t>(d)];
      p = static_cast<std::int32_t>(std::floor(base / block_edge));
      stray.cell = stray.cell * block_edge + static_cast<std::int32_t>(base) - block_edge * p;
    }
    stray.key = key_of<D>(bring_back(particles, grid, spacing, slot, place));
    return stray;
  }

  /// Moves a particle by whole periods, so that a place comes to lie in the period. Returns that place. One function for
  /// strays and others: inlined, the product and the sum may round once here and twice there.
  [[gnu::noinline]] static BlockIndex<D> bring_back(Particles<D>& particles, BlockGrid<D> const& grid, double spacing,
                                                    std::ptrdiff_t slot, BlockIndex<D> const& place) {
    BlockIndex<D> const wrapped = grid.wrap(place);
    for (std::size_t d = 0; d < D; ++d)
      if (int const shift = wrapped[d] - place[d]; shift != 0)
        particles.move(slot, static_cast<int>(d), shift * block_edge * spacing);
    return wrapped;
  }

  /// Where the ways that were taken lead.
  void follow_ways(Particles<D>& particles, BlockGrid<D> const& grid, double spacing) {
    for (std::size_t k = 0; k < ways_.size(); ++k) {
      if (!ways_[k].taken) continue;
      Run const& run = particles.runs()[k / neighbours];
      auto const place = grid.neighbour(static_cast<std::size_t>(run.block), static_cast<int>(k % neighbours));
      ways_[k].key = key_of<D>(grid.wrap(place));
      if (ways_[k].key != key_of<D>(place))
        for (std::ptrdiff_t slot = run.first_chunk * lanes; slot < run.first_chunk * lanes + run.particles; ++slot)
          if (int const code = codes_[static_cast<std::size_t>(slot)];
              code >= 0 && static_cast<std::size_t>(code / cells) == k % neighbours)
            bring_back(particles, grid, spacing, slot, place);
    }
  }

  /// Keys of the blocks that have particles, in order; tells ways and strays their numbers.
  [[nodiscard]] std::vector<std::uint64_t> occupied() {
    std::vector<std::uint64_t> keys;
    for (Way const& way : ways_)
      if (way.taken) keys.push_back(way.key);
    for (Stray const& stray : strays_)
      if (keys.empty() || keys.back() != stray.key) keys.push_back(stray.key);
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    auto const number = [&](auto& at) {
      at.block = static_cast<std::int32_t>(std::lower_bound(keys.begin(), keys.end(), at.key) - keys.begin());
    };
    for (Way& way : ways_)
      if (way.taken) number(way);
    for (Stray& stray : strays_) number(stray);
    return keys;
  }

  void order(Particles<D> const& particles, std::size_t blocks) {
    std::size_t materials = 1;
    for (Run const& run : particles.runs()) materials = std::max(materials, static_cast<std::size_t>(run.material) + 1);
    start_.assign(blocks * materials * cells + 1, 0);
    auto const for_each_rank = [&](auto const& f) {  // f(slot, rank)
      for (std::size_t r = 0; r < particles.runs().size(); ++r) {
        Run const& run = particles.runs()[r];
        std::ptrdiff_t const first = run.first_chunk * lanes;
        for (std::ptrdiff_t slot = first; slot < first + run.particles; ++slot) {
          int const code = codes_[static_cast<std::size_t>(slot)];
          auto const block =
              static_cast<std::size_t>(code < 0 ? strays_[static_cast<std::size_t>(-1 - code)].block
                                                : ways_[r * neighbours + static_cast<std::size_t>(code / cells)].block);
          int const cell = code < 0 ? strays_[static_cast<std::size_t>(-1 - code)].cell : code % cells;
          f(slot,
            (block * materials + static_cast<std::size_t>(run.material)) * cells + static_cast<std::size_t>(cell));
        }
      }
    };
    for_each_rank([&](std::ptrdiff_t, std::size_t rank) { ++start_[rank + 1]; });
    for (std::size_t k = 1; k < start_.size(); ++k) start_[k] += start_[k - 1];
    runs_.clear();
    first_slot_.clear();
    for (std::size_t group = 0; group < blocks * materials; ++group)
      if (auto const from = start_[group * cells], n = start_[(group + 1) * cells] - from; n > 0) {
        runs_.push_back({static_cast<std::int32_t>(group / materials), static_cast<std::int32_t>(group % materials), 0,
                         static_cast<int>(n)});
        first_slot_.push_back(from);
      }
    slots_.resize(particles.count());
    for_each_rank([&](std::ptrdiff_t slot, std::size_t rank) { slots_[start_[rank]++] = slot; });
  }

  std::vector<int> codes_;
  std::vector<Way> ways_;  ///< of every run, by neighbour number
  std::vector<Stray> strays_;
  std::vector<std::size_t> start_;  ///< of every block, material and cell, in the new order
  std::vector<std::ptrdiff_t> slots_;
  std::vector<Run> runs_;
  std::vector<std::size_t> first_slot_;  ///< of every run
};

}  // namespace talus
