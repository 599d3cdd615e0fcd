#pragma once
/// Weights of a chunk of particles on the nodes of an arena, and the turn from particles-in-lanes to one particle's
/// vectors.

#include <array>

#include "core/batch.hpp"
#include "core/kernel.hpp"

namespace talus {

/// Nodes along an edge of a block's arena: the block's cells, the kernel's reach, and one cell of drift on either side.
template <class Kernel>
inline constexpr int arena_edge = block_edge + Kernel::degree + 2;

/// Nodes of an arena.
template <int D, class Kernel>
inline constexpr int arena_nodes =
    D == 2 ? arena_edge<Kernel>* arena_edge<Kernel> : arena_edge<Kernel>* arena_edge<Kernel>* arena_edge<Kernel>;

/// Vectors over the components of a node: D velocities (or momenta), then the mass.
using NodeVector = Pack<4>;

/// Kernel values of the particles of one chunk, dimension by dimension.
///
///   weight[d][k][lane]  N_k                    slope[d][k][lane]  dN_k/dx [1/m]
///   arm[d][k][lane]     x_k - x_p [m]          node[lane]         the stencil's first node in the arena
template <int D, class Kernel>
struct Stencil {
  static constexpr int width = Kernel::width, edge = arena_edge<Kernel>;
  using Values = std::array<std::array<Lanes, width>, D>;

  Values weight, slope, arm;
  std::array<int, lanes> node;

  [[gnu::always_inline]] Stencil(Batch<D> const& batch, Lanes const* position) {
    double const h = batch.spacing;
    std::array<Lanes, D> base;
    for (int d = 0; d < D; ++d) {
      Lanes const xi = position[d] * Lanes(1.0 / h) - Lanes(batch.first[d]);
      base[d] = floor(xi - Lanes(Kernel::base_shift));
      Lanes const f = xi - base[d];
      Kernel::weights(f, weight[d]);
      Kernel::slopes(f, slope[d]);
      for (int k = 0; k < width; ++k) {
        slope[d][k] = slope[d][k] * Lanes(1.0 / h);
        arm[d][k] = (Lanes(double(k)) - f) * Lanes(h);
      }
    }
    Lanes at = base[0];
    for (int d = 1; d < D; ++d) at = at * Lanes(double(edge)) + base[d];
    for (int lane = 0; lane < lanes; ++lane) node[lane] = static_cast<int>(at[lane]);
  }
};

/// Four packs of particles to one vector of four numbers a particle: out[lane] = {a, b, c, d} of that lane.
[[gnu::always_inline]] inline void to_particles(Lanes a, Lanes b, Lanes c, Lanes d, NodeVector* out) {
  using V = NodeVector::Value;
  for (int half = 0; half < lanes; half += 4) {
    V v[4];
    Lanes const packs[4] = {a, b, c, d};
    for (int k = 0; k < 4; ++k) __builtin_memcpy(&v[k], reinterpret_cast<double const*>(&packs[k]) + half, sizeof(V));
    V const ab_low = __builtin_shufflevector(v[0], v[1], 0, 4, 2, 6);
    V const ab_high = __builtin_shufflevector(v[0], v[1], 1, 5, 3, 7);
    V const cd_low = __builtin_shufflevector(v[2], v[3], 0, 4, 2, 6);
    V const cd_high = __builtin_shufflevector(v[2], v[3], 1, 5, 3, 7);
    out[half + 0] = NodeVector(__builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5));
    out[half + 1] = NodeVector(__builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5));
    out[half + 2] = NodeVector(__builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7));
    out[half + 3] = NodeVector(__builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7));
  }
}

/// The way back: one vector a particle to packs of particles; component k of in[lane] becomes lane `lane` of out[k].
[[gnu::always_inline]] inline std::array<Lanes, 4> to_lanes(NodeVector const* in) {
  using V = NodeVector::Value;
  std::array<Lanes, 4> out;
  for (int half = 0; half < lanes; half += 4) {
    V const a = in[half].value, b = in[half + 1].value, c = in[half + 2].value, d = in[half + 3].value;
    V const ab_low = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_high = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    V const cd_low = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_high = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    V const rows[4] = {
        __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5), __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5),
        __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7), __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7)};
    for (int k = 0; k < 4; ++k) __builtin_memcpy(reinterpret_cast<double*>(&out[k]) + half, &rows[k], sizeof(V));
  }
  return out;
}

}  // namespace talus
