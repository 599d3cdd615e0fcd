#pragma once
/// Impulses of particles to the nodes around them, one particle after the other: for what only few scenes have.
///
///   I_i = sum_p w_ip I_p                                               (1)

#include <vector>

#include "core/stencil.hpp"

namespace talus {

/// Adds (1) to an arena of one vector a node. impulses [kg m/s]: one a particle of the batch, in its order.
template <int D, class Kernel>
void impulses_to_grid(Batch<D> const& batch, std::vector<Point<D>> const& impulses, NodeVector* arena) {
  constexpr int width = Kernel::width, edge = Stencil<D, Kernel>::edge;
  Stencil<D, Kernel> stencil;
  for (int p = 0; p < batch.particles; ++p) {
    int const lane = p % lanes;
    if (lane == 0)
      for (int r = 0; r < registers; ++r)
        stencil.place(batch, batch.chunk(p / lanes), r, [](int, Axis<Kernel> const&) {});
    NodeVector impulse(0.0);
    for (int d = 0; d < D; ++d) impulse.set(d, impulses[static_cast<std::size_t>(p)][d]);
    NodeVector* const first = stencil.first(arena, lane, 1);
    for (int i = 0; i < width; ++i)
      for (int j = 0; j < width; ++j) {
        double const w_ij = stencil.weight[0][i][lane] * stencil.weight[1][j][lane];
        if constexpr (D == 2)
          first[i * edge + j] += NodeVector(w_ij) * impulse;
        else
          for (int k = 0; k < width; ++k)
            first[(i * edge + j) * edge + k] += NodeVector(w_ij * stencil.weight[2][k][lane]) * impulse;
      }
  }
}

}  // namespace talus
