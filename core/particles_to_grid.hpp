#pragma once
/// Particles to grid: one block scatters mass, momentum and internal force into its own arena.
///
///   m_i    = sum_p w_ip m_p                                            (1)
///   (mv)_i = sum_p w_ip m_p (v_p + C_p (x_i - x_p))                    (2)   C_p only where the transfer is affine
///   dt f_i = - dt sum_p V_p^0 tau_p grad w_ip                          (3)
///   (mu m)_i = sum_p w_ip m_p mu_p                                     (4)   only where walls take friction from it
///
/// SIMD lanes lie along the components of a node; the sums are factorised dimension by dimension.
/// Source: Sulsky, Chen & Schreyer (1994), doi:10.1016/0045-7825(94)90112-0 (not re-read); affine term: Jiang et al.
/// (2015), doi:10.1145/2766996 (not re-read).

#include "core/stencil.hpp"

namespace talus {

/// Shape of the stress that acts in the D dimensions of motion.
template <int D>
using InPlane = std::conditional_t<D == 2, shape::Plane, shape::Solid>;

/// What a material hands to the grid for one chunk.
template <int D>
struct Load {
  Symmetric<Lanes, InPlane<D>> force;  ///< V_p^0 tau_p [J]
  Lanes friction;                      ///< mu_p [1]; set only where a wall asks for it
};

/// `affine`: the velocity has a gradient C_p. `apart`: the node has a second vector for the impulse (and friction),
/// because the blend needs the velocity before it; else the impulse is added to the momentum at once. `loaded`: there
/// are forces at all.
struct Scatter {
  bool affine = false, apart = false, friction = false, loaded = true;
};

namespace detail {

/// The vectors that one particle spreads over its nodes: `spread` by w, `arm[d]` by w (x_i - x_p)_d, `push[d]` by
/// dw/dx_d.
template <int D, Scatter S>
struct Spread {
  NodeVector spread[lanes], rub[lanes], arm[D][lanes], push[D][lanes];

  [[gnu::always_inline]] Spread(Batch<D> const& batch, Lanes const* chunk, Load<D> const* load, double dt) {
    Lanes const* v = chunk + batch.at.velocity;
    Lanes const m = chunk[batch.at.mass], none(0.0);
    if constexpr (D == 2) to_particles(m * v[0], m * v[1], m, none, spread);
    if constexpr (D == 3) to_particles(m * v[0], m * v[1], m * v[2], m, spread);
    if constexpr (S.affine) {
      Lanes const* C = chunk + batch.at.affine;
      for (int d = 0; d < D; ++d) {
        if constexpr (D == 2) to_particles(m * C[d], m * C[D + d], none, none, arm[d]);
        if constexpr (D == 3) to_particles(m * C[d], m * C[D + d], m * C[2 * D + d], none, arm[d]);
      }
    }
    if constexpr (S.loaded) {
      auto const& force = load->force;
      Lanes const s(-dt);
      for (int d = 0; d < D; ++d) {
        if constexpr (D == 2) to_particles(s * force(0, d), s * force(1, d), none, none, push[d]);
        if constexpr (D == 3) to_particles(s * force(0, d), s * force(1, d), s * force(2, d), none, push[d]);
      }
    }
    if constexpr (S.friction) {
      if constexpr (D == 2) to_particles(none, none, m * load->friction, none, rub);
      if constexpr (D == 3) to_particles(none, none, none, m * load->friction, rub);
    }
  }
};

/// Two sums that belong to a node: its momentum, and its impulse where that is kept apart.
template <Scatter S>
struct Pair {
  NodeVector momentum, impulse;
};

/// Adds one particle to the nodes of its stencil.
template <int D, class Kernel, Scatter S>
[[gnu::always_inline]] inline void scatter_one(Spread<D, S> const& p, Stencil<D, Kernel> const& stencil, int lane,
                                               NodeVector* arena) {
  constexpr int width = Kernel::width, edge = Stencil<D, Kernel>::edge, vectors = S.apart ? 2 : 1;
  auto const w = [&](int d, int k) { return NodeVector(stencil.weight[d][k][lane]); };
  auto const g = [&](int d, int k) { return NodeVector(stencil.slope[d][k][lane]); };
  auto const r = [&](int d, int k) { return NodeVector(stencil.arm[d][k][lane]); };
  // What dimension d adds along node k, for a unit weight in the others.
  auto const along = [&](int d, int k) {
    Pair<S> sum{NodeVector(0.0), NodeVector(0.0)};
    if constexpr (S.affine) sum.momentum = w(d, k) * r(d, k) * p.arm[d][lane];
    if constexpr (S.loaded) (S.apart ? sum.impulse : sum.momentum) += g(d, k) * p.push[d][lane];
    return sum;
  };
  // sum <- sum w + other s
  auto const advance = [](Pair<S> const& sum, NodeVector weight, Pair<S> const& other, NodeVector scale) {
    Pair<S> next = sum;
    next.momentum = sum.momentum * weight + other.momentum * scale;
    if constexpr (S.apart) next.impulse = sum.impulse * weight + other.impulse * scale;
    return next;
  };
  Pair<S> const own{p.spread[lane], S.friction ? p.rub[lane] : NodeVector(0.0)};
  Pair<S> last[width];
  for (int k = 0; k < width; ++k) last[k] = along(D - 1, k);
  NodeVector const one(1.0);
  for (int i = 0; i < width; ++i) {
    Pair<S> const x = advance(own, w(0, i), along(0, i), one);
    if constexpr (D == 2) {
      NodeVector* node = arena + (stencil.node[lane] + i * edge) * vectors;
      for (int j = 0; j < width; ++j, node += vectors) {
        Pair<S> const add = advance(x, w(1, j), last[j], w(0, i));
        node[0] += add.momentum;
        if constexpr (S.apart) node[1] += add.impulse;
      }
    } else {
      for (int j = 0; j < width; ++j) {
        Pair<S> const xy = advance(x, w(1, j), along(1, j), w(0, i));
        NodeVector const scale = w(0, i) * w(1, j);
        NodeVector* node = arena + (stencil.node[lane] + (i * edge + j) * edge) * vectors;
        for (int k = 0; k < width; ++k, node += vectors) {
          Pair<S> const add = advance(xy, w(2, k), last[k], scale);
          node[0] += add.momentum;
          if constexpr (S.apart) node[1] += add.impulse;
        }
      }
    }
  }
}

}  // namespace detail

/// Adds a batch to its block's arena. `loads` has one entry a chunk (unused where S.loaded and S.friction are false).
template <int D, class Kernel, Scatter S>
[[gnu::flatten]] void particles_to_grid(Batch<D> const& batch, Load<D> const* loads, double dt, NodeVector* arena) {
  for (int c = 0; c < batch.count; ++c) {
    Lanes const* chunk = batch.chunk(c);
    __builtin_prefetch(chunk + batch.stride);
    Stencil<D, Kernel> const stencil(batch, chunk + batch.at.position);
    detail::Spread<D, S> const spread(batch, chunk, loads + c, dt);
    int const filled = batch.filled(c);
    for (int lane = 0; lane < filled; ++lane) detail::scatter_one<D, Kernel, S>(spread, stencil, lane, arena);
  }
}

}  // namespace talus
