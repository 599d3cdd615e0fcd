#pragma once
/// The background grid as blocks of 4^D nodes, of which only those near particles exist.
///
/// A particle belongs to the block of its stencil's first node, half a cell of drift on either side included. Each
/// particle block scatters into an arena, a copy of the nodes that it reaches, which is then added to the grid. Blocks
/// are taken colour by colour: those of one colour share no node, so that each node's sum is taken in the order of the
/// colours, whatever the number of threads. No cost grows with the bounding box.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/arena.hpp"
#include "core/batch.hpp"
#include "core/errors.hpp"

namespace talus {

/// Place of a block: its first node is block_edge * place.
template <int D>
using BlockIndex = std::array<std::int32_t, static_cast<std::size_t>(D)>;

/// Blocks further than this from the origin are refused: 2^20 blocks of 4 cells.
inline constexpr std::int32_t farthest_block = 1 << 20;

/// The number under which a block is known and by which blocks are ordered: the first axis counts most.
template <int D>
constexpr std::uint64_t key_of(BlockIndex<D> const& place) {
  std::uint64_t key = 0;
  for (int d = 0; d < D; ++d)
    key = (key << 21) | static_cast<std::uint64_t>(place[static_cast<std::size_t>(d)] + farthest_block);
  return key;
}
template <int D>
constexpr BlockIndex<D> place_of(std::uint64_t key) {
  BlockIndex<D> place{};
  for (int d = D - 1; d >= 0; --d, key >>= 21)
    place[static_cast<std::size_t>(d)] = static_cast<std::int32_t>(key & ((1U << 21) - 1)) - farthest_block;
  return place;
}

/// Step o_d in {-1, 0, 1} to neighbour number n; the last axis runs fastest.
template <int D>
constexpr BlockIndex<D> neighbour_step(int n) {
  BlockIndex<D> step{};
  for (int d = D - 1; d >= 0; --d, n /= 3) step[static_cast<std::size_t>(d)] = n % 3 - 1;
  return step;
}

/// Which particle blocks and node blocks exist, and who is whose neighbour.
template <int D>
class BlockGrid {
 public:
  using Neighbours = std::array<std::int32_t, static_cast<std::size_t>(neighbour_count<D>)>;

  /// periods: number of blocks after which an axis repeats, 0 where it does not.
  explicit BlockGrid(BlockIndex<D> periods = {}) : periods_(periods) {}

  /// Builds the tables for particle blocks with these keys (sorted, each once), unless they are what there is.
  void build(std::vector<std::uint64_t> keys) {
    if (keys == particle_keys_) return;
    particle_keys_ = std::move(keys);
    find_node_blocks();
    link();
    sort_by_colour();
  }

  [[nodiscard]] std::size_t particle_blocks() const { return particle_keys_.size(); }
  [[nodiscard]] std::size_t node_blocks() const { return node_keys_.size(); }
  [[nodiscard]] std::vector<std::uint64_t> const& particle_keys() const { return particle_keys_; }
  [[nodiscard]] BlockIndex<D> particle_block(std::size_t b) const { return place_of<D>(particle_keys_[b]); }
  /// The place of neighbour n of particle block b, not brought back into the period.
  [[nodiscard]] BlockIndex<D> neighbour(std::size_t b, int n) const { return moved(particle_keys_[b], n); }
  [[nodiscard]] BlockIndex<D> node_block(std::size_t b) const { return place_of<D>(node_keys_[b]); }
  /// Number of the node block at a place, or -1 where there is none.
  [[nodiscard]] std::ptrdiff_t find_node_block(BlockIndex<D> const& place) const {
    return find(node_keys_, key_of<D>(wrap(place)));
  }
  /// Node blocks around particle block b, by neighbour number.
  [[nodiscard]] Neighbours const& nodes_around(std::size_t b) const { return nodes_around_[b]; }
  /// Particle blocks of colour c, the first axis slowest. Some colours may have none.
  [[nodiscard]] std::span<std::int32_t const> coloured(int c) const {
    auto const from = first_of_colour_[static_cast<std::size_t>(c)];
    return std::span(order_).subspan(from, first_of_colour_[static_cast<std::size_t>(c) + 1] - from);
  }
  /// Two an axis, and a third for the last block where an axis repeats after an odd number of them.
  static constexpr int colours = D == 2 ? 9 : 27;
  [[nodiscard]] BlockIndex<D> const& periods() const { return periods_; }

  /// A place brought back into the period.
  [[nodiscard]] BlockIndex<D> wrap(BlockIndex<D> place) const {
    for (int d = 0; d < D; ++d) {
      auto& c = place[static_cast<std::size_t>(d)];
      std::int32_t const n = periods_[static_cast<std::size_t>(d)];
      if (n > 0) c = ((c % n) + n) % n;
    }
    return place;
  }

 private:
  static BlockIndex<D> moved(std::uint64_t key, int neighbour) {
    BlockIndex<D> place = place_of<D>(key);
    BlockIndex<D> const step = neighbour_step<D>(neighbour);
    for (std::size_t d = 0; d < D; ++d) place[d] += step[d];
    return place;
  }

  void find_node_blocks() {
    node_keys_.clear();
    for (std::uint64_t key : particle_keys_)
      for (int n = 0; n < neighbour_count<D>; ++n) node_keys_.push_back(key_of<D>(wrap(moved(key, n))));
    std::sort(node_keys_.begin(), node_keys_.end());
    node_keys_.erase(std::unique(node_keys_.begin(), node_keys_.end()), node_keys_.end());
  }

  static std::int32_t find(std::vector<std::uint64_t> const& keys, std::uint64_t key) {
    auto const at = std::lower_bound(keys.begin(), keys.end(), key);
    return at != keys.end() && *at == key ? static_cast<std::int32_t>(at - keys.begin()) : -1;
  }

  void link() {
    nodes_around_.resize(particle_keys_.size());
    for (std::size_t b = 0; b < particle_keys_.size(); ++b)
      for (int n = 0; n < neighbour_count<D>; ++n)
        nodes_around_[b][static_cast<std::size_t>(n)] = find(node_keys_, key_of<D>(wrap(moved(particle_keys_[b], n))));
  }

  [[nodiscard]] int colour(std::uint64_t key) const {
    BlockIndex<D> const place = place_of<D>(key);
    int colour = 0;
    for (std::size_t d = 0; d < D; ++d) {
      bool const odd_period = periods_[d] % 2 != 0;
      colour = 3 * colour + (odd_period && place[d] == periods_[d] - 1 ? 2 : place[d] & 1);
    }
    return colour;
  }

  void sort_by_colour() {
    first_of_colour_.fill(0);
    for (std::uint64_t key : particle_keys_) ++first_of_colour_[static_cast<std::size_t>(colour(key)) + 1];
    for (std::size_t c = 0; c < colours; ++c) first_of_colour_[c + 1] += first_of_colour_[c];
    order_.resize(particle_keys_.size());
    auto next = first_of_colour_;
    for (std::size_t b = 0; b < particle_keys_.size(); ++b)
      order_[next[static_cast<std::size_t>(colour(particle_keys_[b]))]++] = static_cast<std::int32_t>(b);
  }

  BlockIndex<D> periods_;
  std::vector<std::uint64_t> particle_keys_, node_keys_;
  std::vector<Neighbours> nodes_around_;
  std::vector<std::int32_t> order_;
  std::array<std::size_t, colours + 1> first_of_colour_{};
};

}  // namespace talus
