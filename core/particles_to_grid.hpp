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
/// because the blend needs the velocity before it; else the impulse is added to the momentum at once. `friction` is the
/// last component of the first vector in the plane, and of the second in space. `loaded`: there are forces at all.
struct Scatter {
  bool affine = false, apart = false, friction = false, loaded = true;
};

namespace detail {

/// What a particle spreads over its nodes is a sum of products over the dimensions, in which each dimension has one
/// factor that is a vector and the others are weights:
///
///   node (i, j, k) += w_k (w_j X_i + w_i Y_j) + w_i w_j Z_k                                            (5)
///   momentum: X_i = w_i m v + h l_i m C e_x - dt/h g_i V tau e_x,  Y_j = h l_j m C e_y - dt/h g_j V tau e_y, ...  (6)
///
/// w: weights, l: levers, g: slopes along that dimension. The impulse has its own factors where it is kept apart.
/// factor[d][k][lane] is the vector of node k along dimension d.
template <int D, class Kernel>
struct Factors {
  NodeVector factor[D][Kernel::width][lanes];
};

/// The factors (6) of momentum, with mass behind it, and of the impulse where it is apart; friction is the last
/// component of either.
template <int D, class Kernel, Scatter S>
struct Spread {
  static constexpr bool arms = S.affine || (S.loaded && !S.apart);  ///< Y and Z of the momentum are not zero
  Factors<D, Kernel> momentum, impulse;

  /// Factors along dimension d of the particles of register r.
  [[gnu::always_inline]] void fill(Batch<D> const& batch, Lanes const* chunk, Load<D> const* load, double dt, int r,
                                   int d, Axis<Kernel> const& axis) {
    Register const m = part(chunk[batch.at.mass], r), arm = m * Register(batch.spacing),
                   push = Register(-dt / batch.spacing);
    Lanes const *velocity = chunk + batch.at.velocity, *gradient = chunk + batch.at.affine;
    Register v[D], C[D], f[D];
#pragma GCC unroll 4
    for (int c = 0; c < D; ++c) {
      if (d == 0) v[c] = m * part(velocity[c], r);
      if constexpr (S.affine) C[c] = arm * part(gradient[c * D + d], r);
      if constexpr (S.loaded) f[c] = push * part(load->force(c, d), r);
    }
#pragma GCC unroll 4
    for (int k = 0; k < Kernel::width; ++k) {
      Register const w = axis.weight[k], l = axis.lever[k], g = axis.slope[k], none(0.0);
      Components moved{none, none, none, none}, pushed{none, none, none, none};
#pragma GCC unroll 4
      for (int c = 0; c < D; ++c) {
        if (d == 0) moved[c] = w * v[c];
        if constexpr (S.affine) moved[c] = d == 0 ? moved[c] + l * C[c] : l * C[c];
        if constexpr (S.loaded && S.apart) pushed[c] = g * f[c];
        if constexpr (S.loaded && !S.apart) moved[c] = d == 0 || S.affine ? moved[c] + g * f[c] : g * f[c];
      }
      if (d == 0) moved[D] = w * m;
      if constexpr (S.friction)
        if (d == 0) (D == 2 ? moved : pushed)[3] = w * m * part(load->friction, r);
      if (d == 0 || arms) to_particles(moved, momentum.factor[d][k] + r * register_lanes);
      if (S.loaded && S.apart) to_particles(pushed, impulse.factor[d][k] + r * register_lanes);
    }
  }
};

/// A particle's weights and factors along the last dimension, in registers: every line of its nodes takes them all.
template <int D, class Kernel, Scatter S>
struct Last {
  static constexpr int width = Kernel::width, vectors = S.apart ? 2 : 1, last = D - 1;
  static constexpr bool arms = Spread<D, Kernel, S>::arms, pushed = S.loaded && S.apart;
  NodeVector weight[width], momentum[width], impulse[width];

  [[gnu::always_inline]] Last(Spread<D, Kernel, S> const& p, Stencil<D, Kernel> const& stencil, int lane) {
#pragma GCC unroll 4
    for (int k = 0; k < width; ++k) {
      weight[k] = in_register(NodeVector(stencil.weight[last][k][lane]));
      if (arms) momentum[k] = in_register(p.momentum.factor[last][k][lane]);
      if (pushed) impulse[k] = in_register(p.impulse.factor[last][k][lane]);
    }
  }
  /// Adds (5) to a line of nodes. w: weight of the line; moved, push: what (5) says of the other dimensions.
  [[gnu::always_inline]] void add(NodeVector* line, NodeVector w, NodeVector moved, NodeVector push) const {
#pragma GCC unroll 4
    for (int k = 0; k < width; ++k) {
      NodeVector* const node = line + k * vectors;
      NodeVector const sum = node[0] + weight[k] * moved;
      node[0] = arms ? sum + w * momentum[k] : sum;
      if (pushed) node[1] = (node[1] + weight[k] * push) + w * impulse[k];
    }
  }
};

/// Adds (5) to the nodes of one particle's stencil, momentum and what is kept apart from it in one go: the weights are
/// the same.
template <int D, class Kernel, Scatter S>
[[gnu::always_inline]] inline void add(Spread<D, Kernel, S> const& p, Stencil<D, Kernel> const& stencil, int lane,
                                       NodeVector* arena) {
  constexpr int width = Kernel::width, edge = Stencil<D, Kernel>::edge;
  using Last = detail::Last<D, Kernel, S>;
  NodeVector* const first = stencil.first(arena, lane, Last::vectors);
  Last const last(p, stencil, lane);
#pragma GCC unroll 4
  for (int i = 0; i < width; ++i) {
    NodeVector const w_i = in_register(NodeVector(stencil.weight[0][i][lane])),
                     X = in_register(p.momentum.factor[0][i][lane]),
                     pushed_X = Last::pushed ? in_register(p.impulse.factor[0][i][lane]) : X;
    if constexpr (D == 2) {
      last.add(first + i * edge * Last::vectors, w_i, X, pushed_X);
    } else {
#pragma GCC unroll 4
      for (int j = 0; j < width; ++j) {
        NodeVector const w_j(stencil.weight[1][j][lane]);
        NodeVector moved = w_j * X, push = w_j * pushed_X;
        if (Last::arms) moved += w_i * p.momentum.factor[1][j][lane];
        if (Last::pushed) push += w_i * p.impulse.factor[1][j][lane];
        last.add(first + (i * edge + j) * edge * Last::vectors, in_register(NodeVector(stencil.pair[i][j][lane])),
                 moved, push);
      }
    }
  }
}

}  // namespace detail

/// Adds chunk c to its block's arena (`load` is unused where S.loaded and S.friction are false).
template <int D, class Kernel, Scatter S>
[[gnu::always_inline]] inline void scatter_chunk(Batch<D> const& batch, int c, Load<D> const* load, double dt,
                                                 NodeVector* arena) {
  Lanes const* chunk = batch.chunk(c);
  Stencil<D, Kernel> stencil;
  detail::Spread<D, Kernel, S> spread;
  auto const along = [&](int r) {
    return [&, r ](int d, Axis<Kernel> const& axis) __attribute__((always_inline)) {
      spread.fill(batch, chunk, load, dt, r, d, axis);
    };
  };
#pragma GCC unroll 2
  for (int r = 0; r < registers; ++r) stencil.place(batch, chunk, r, along(r));
  int const filled = batch.filled(c);
  for (int lane = 0; lane < filled; ++lane) detail::add<D, Kernel, S>(spread, stencil, lane, arena);
}

/// Adds a batch. `loads` has one entry a chunk.
template <int D, class Kernel, Scatter S>
[[gnu::flatten]] void particles_to_grid(Batch<D> const& batch, Load<D> const* loads, double dt, NodeVector* arena) {
  for (int c = 0; c < batch.count; ++c)
    scatter_chunk<D, Kernel, S>(batch, c, S.loaded || S.friction ? loads + c : nullptr, dt, arena);
}

}  // namespace talus
