#pragma once
/// Weights of a chunk of particles on the nodes of an arena, and the turn from particles-in-lanes to one particle's
/// vectors.

#include <array>

#include "core/arena.hpp"
#include "core/batch.hpp"
#include "core/kernel.hpp"

namespace talus {

/// Nodes along an edge of a block's arena: the block's cells, one more for the drift of half a cell on either side, and
/// the kernel's reach.
template <class Kernel>
inline constexpr int arena_edge = block_edge + 1 + Kernel::degree;

/// Kernel values of the particles of a register along one dimension, in units of h.
///
///   weight[k]  N_k        slope[k]  h dN_k/dx        lever[k]  N_k (x_k - x_p) / h
template <class Kernel>
struct Axis {
  static constexpr int width = Kernel::width;
  std::array<Register, width> weight, slope, lever;
  Register base;  ///< the stencil's first node

  /// xi [1]: places of the particles, from the arena's first node on.
  [[gnu::always_inline]] explicit Axis(Register xi) : base(floor(xi - Register(Kernel::base_shift))) {
    Register const f = xi - base;
    Kernel::weights(f, weight);
    Kernel::slopes(f, slope);
#pragma GCC unroll 4
    for (int k = 0; k < width; ++k) lever[k] = weight[k] * (Register(double(k)) - f);
  }
};

/// What the loop over a chunk's particles needs of the kernel: weight[d][k][lane], the products of those of the first two
/// dimensions, pair[i][j][lane] (in space), and node[lane], the number of the stencil's first node in the arena.
template <int D, class Kernel>
struct Stencil {
  static constexpr int width = Kernel::width, edge = arena_edge<Kernel>;
  using AtLanes = std::array<double, lanes>;

  alignas(Lanes) std::array<std::array<AtLanes, width>, D> weight;
  alignas(Lanes) std::array<std::array<AtLanes, width>, width> pair;
  std::array<int, lanes> node;

  /// Takes the particles of register r from the chunk; calls along(d, axis) for each dimension.
  template <class F>
  [[gnu::always_inline]] void place(Batch<D> const& batch, Lanes const* chunk, int r, F const& along) {
    Lanes const* position = chunk + batch.at.position;
    Register at(0.0);
#pragma GCC unroll 4
    for (int d = 0; d < D; ++d) {
      Register const x = part(position[d], r);
      Axis<Kernel> const axis(x * Register(1.0 / batch.spacing) - Register(batch.first[d]));
#pragma GCC unroll 4
      for (int k = 0; k < width; ++k) {
        axis.weight[k].store(&weight[d][k][r * register_lanes]);
        if (D == 3 && d == 1)
          for (int i = 0; i < width; ++i)
            (Register::load(&weight[0][i][r * register_lanes]) * axis.weight[k]).store(&pair[i][k][r * register_lanes]);
      }
      at = at * Register(double(edge)) + axis.base;
      along(d, axis);
    }
    store_whole(at, &node[r * register_lanes]);
  }

  /// The first node of a particle's stencil. The address is kept whole: g++ would else add the two halves of it anew at
  /// every node.
  template <class Vector>
  [[gnu::always_inline]] Vector* first(Vector* arena, int lane, int vectors) const {
    Vector* node_of = arena + node[lane] * vectors;
    asm("" : "+r"(node_of));
    return node_of;
  }
};

namespace detail {
/// Rows to columns: component k of result j is component j of argument k.
[[gnu::always_inline]] inline std::array<NodeVector, 4> transposed(NodeVector a, NodeVector b, NodeVector c,
                                                                   NodeVector d) {
  using V = NodeVector::Value;
  V const ab_low = __builtin_shufflevector(a.value, b.value, 0, 4, 2, 6);
  V const ab_high = __builtin_shufflevector(a.value, b.value, 1, 5, 3, 7);
  V const cd_low = __builtin_shufflevector(c.value, d.value, 0, 4, 2, 6);
  V const cd_high = __builtin_shufflevector(c.value, d.value, 1, 5, 3, 7);
  return {NodeVector(__builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5)),
          NodeVector(__builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5)),
          NodeVector(__builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7)),
          NodeVector(__builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7))};
}
}  // namespace detail

/// Components of node vectors for the particles of a register: a register each.
using Components = std::array<Register, 4>;

/// Components of particles to one vector a particle: out[lane] = {c[0], c[1], c[2], c[3]} of that lane.
[[gnu::always_inline]] inline void to_particles(Components const& c, NodeVector* out) {
  auto const rows = detail::transposed(c[0], c[1], c[2], c[3]);
#pragma GCC unroll 4
  for (int k = 0; k < register_lanes; ++k) out[k] = rows[k];
}

/// The way back: component k of in[lane] becomes lane `lane` of result k.
[[gnu::always_inline]] inline Components to_lanes(NodeVector const* in) {
  return detail::transposed(in[0], in[1], in[2], in[3]);
}

}  // namespace talus
