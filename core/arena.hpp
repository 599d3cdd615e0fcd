#pragma once
/// How the arena of a particle block overlaps the node blocks around it.
///
/// An arena is an array of edge^D nodes, the last axis fastest, each of one or two vectors; it begins one node before
/// its block. A node block is an array of block_edge^D nodes of the same kind. They share boxes of nodes, and of a box
/// each row along the last axis lies in one piece in both.

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/batch.hpp"

namespace talus {

/// Vectors over the components of a node: D velocities (or momenta), then the mass.
using NodeVector = Pack<4>;

/// Number of a node block among those around a particle block: (s_x + 1) 3 + s_y + 1 in the plane, for steps s in
/// {-1, 0, 1}; likewise in space.
template <int D>
inline constexpr int neighbour_count = D == 2 ? 9 : 27;

template <int D>
inline constexpr int nodes_per_block = D == 2 ? block_edge* block_edge : block_edge* block_edge* block_edge;

template <int D, int edge>
struct Arena {
  static constexpr int nodes = D == 2 ? edge * edge : edge * edge * edge;

  /// Nodes that arena and block share along an axis when the block lies `step` from the arena's: [begin, end) of the
  /// block; the arena's own number is node + shift.
  struct Overlap {
    int begin, end, shift;
    constexpr explicit Overlap(int step)
        : begin(std::max(0, -block_edge * step - 1)),
          end(std::min(block_edge, edge - block_edge * step - 1)),
          shift(block_edge * step + 1) {}
  };

  /// Calls row(node, own, length) for every row that node block number n shares: `length` nodes from `node` of the
  /// block and from `own` of the arena on. The length is a constant.
  template <class F>
  [[gnu::always_inline]] static void for_each_row(int n, F const& row) {
    switch (n % 3) {
      case 0:
        return rows<Overlap(-1)>(n / 3, row);
      case 1:
        return rows<Overlap(0)>(n / 3, row);
      default:
        return rows<Overlap(1)>(n / 3, row);
    }
  }

 private:
  template <Overlap last, class F>
  [[gnu::always_inline]] static void rows(int n, F const& row) {
    constexpr std::integral_constant<int, std::max(0, last.end - last.begin)> length{};
    if constexpr (D == 2) {
      Overlap const x(n - 1);
      for (int i = x.begin; i < x.end; ++i)
        row(i * block_edge + last.begin, (i + x.shift) * edge + last.begin + last.shift, length);
    } else {
      Overlap const x(n / 3 - 1), y(n % 3 - 1);
      for (int i = x.begin; i < x.end; ++i)
        for (int j = y.begin; j < y.end; ++j)
          row((i * block_edge + j) * block_edge + last.begin,
              ((i + x.shift) * edge + j + y.shift) * edge + last.begin + last.shift, length);
    }
  }
};

/// Adds what the arena holds of node block number n, and leaves zeros there.
template <int D, int edge, int vectors>
[[gnu::flatten]] void add_arena(NodeVector* arena, int n, NodeVector* block) {
  Arena<D, edge>::for_each_row(n, [&](int node, int own, auto length) {
    NodeVector* from = arena + own * vectors;
    NodeVector* to = block + node * vectors;
    for (int k = 0; k < length * vectors; ++k) {
      to[k] += from[k];
      from[k] = NodeVector(0.0);
    }
  });
}

/// Copies what the arena needs of node block number n.
template <int D, int edge, int vectors>
[[gnu::flatten]] void load_arena(NodeVector const* block, int n, NodeVector* arena) {
  Arena<D, edge>::for_each_row(n, [&](int node, int own, auto length) {
    NodeVector const* from = block + node * vectors;
    NodeVector* to = arena + own * vectors;
    for (int k = 0; k < length * vectors; ++k) to[k] = from[k];
  });
}

}  // namespace talus
