#pragma once
/// Grid to particles: one block gathers velocities from its arena, moves its particles and hands the velocity gradient
/// on.
///
///   v_pic  = sum_i w_ip v_i                                            (1)
///   v_p   <- alpha (v_p + sum_i w_ip (v_i - v_i^old)) + (1 - alpha) v_pic    (2)
///   C_p   <- D_p^-1 sum_i w_ip v_i (x_i - x_p)^T,  D_p = inertia h^2 I (3)   where the transfer is affine
///   L_p    = sum_i v_i grad w_ip                                       (4)   with the weights of the old position
///   x_p   <- x_p + dt v_pic                                            (5)   whatever the blend
///
/// Source: FLIP: Brackbill & Ruppel (1986), doi:10.1016/0021-9991(86)90211-1; APIC: Jiang et al. (2015),
/// doi:10.1145/2766996; AFLIP: Fei et al. (2021), doi:10.1145/3450626.3459678 (none re-read).

#include "core/stencil.hpp"

namespace talus {

/// What a pass gathers. A node has a second vector where `second` says so: the velocity before the step (`old`) or the
/// one that was mapped back from the moved particles (`remapped`: MUSL takes the gradient from it).
struct Gather {
  enum class Second { none, old, remapped };
  bool affine = false, update = true, gradient = true, advect = true;
  Second second = Second::none;
};

namespace detail {

/// Sums of one particle over its nodes.
template <int D, Gather G>
struct Sums {
  NodeVector velocity[lanes], old[lanes], arm[D][lanes], gradient[D][lanes];

  /// Zero from lane `filled` on: what lanes without a particle gather.
  void clear_from(int filled) {
    for (int lane = filled; lane < lanes; ++lane) {
      velocity[lane] = old[lane] = NodeVector(0.0);
      for (int d = 0; d < D; ++d) arm[d][lane] = gradient[d][lane] = NodeVector(0.0);
    }
  }
};

/// A line of nodes, summed with the weights, slopes and arms of the last dimension.
template <Gather G>
struct Line {
  NodeVector velocity{0.0}, old{0.0}, gradient{0.0}, arm{0.0}, source{0.0};
};

template <int D, class Kernel, Gather G>
[[gnu::always_inline]] inline void gather_one(Stencil<D, Kernel> const& stencil, int lane, NodeVector const* arena,
                                              Sums<D, G>& out) {
  constexpr int width = Kernel::width, edge = Stencil<D, Kernel>::edge;
  constexpr bool two = G.second != Gather::Second::none, remapped = G.second == Gather::Second::remapped;
  constexpr bool old = G.update && G.second == Gather::Second::old;
  constexpr int vectors = two ? 2 : 1;
  auto const w = [&](int d, int k) { return NodeVector(stencil.weight[d][k][lane]); };
  auto const g = [&](int d, int k) { return NodeVector(stencil.slope[d][k][lane]); };
  auto const r = [&](int d, int k) { return NodeVector(stencil.arm[d][k][lane]); };
  // A line along the last dimension. `source` is what gradients across the line are taken of.
  auto const line = [&](NodeVector const* node) {
    Line<G> s;
    for (int k = 0; k < width; ++k, node += vectors) {
      NodeVector const weighted = w(D - 1, k) * node[0];
      s.velocity += weighted;
      if constexpr (old) s.old += w(D - 1, k) * node[1];
      if constexpr (G.affine) s.arm += r(D - 1, k) * weighted;
      if constexpr (G.gradient) s.gradient += g(D - 1, k) * node[remapped ? 1 : 0];
      if constexpr (G.gradient && remapped) s.source += w(D - 1, k) * node[1];
    }
    if constexpr (!remapped) s.source = s.velocity;
    return s;
  };
  NodeVector velocity(0.0), before(0.0), arm[D], gradient[D];
  for (int d = 0; d < D; ++d) arm[d] = gradient[d] = NodeVector(0.0);
  for (int i = 0; i < width; ++i) {
    Line<G> x;
    NodeVector arm_y(0.0), gradient_y(0.0);
    if constexpr (D == 2) {
      x = line(arena + (stencil.node[lane] + i * edge) * vectors);
    } else {
      for (int j = 0; j < width; ++j) {
        Line<G> const y = line(arena + (stencil.node[lane] + (i * edge + j) * edge) * vectors);
        x.velocity += w(1, j) * y.velocity;
        x.source += w(1, j) * y.source;
        if constexpr (old) x.old += w(1, j) * y.old;
        if constexpr (G.affine) x.arm += w(1, j) * y.arm;
        if constexpr (G.affine) arm_y += w(1, j) * r(1, j) * y.velocity;
        if constexpr (G.gradient) x.gradient += w(1, j) * y.gradient;
        if constexpr (G.gradient) gradient_y += g(1, j) * y.source;
      }
    }
    velocity += w(0, i) * x.velocity;
    if constexpr (old) before += w(0, i) * x.old;
    if constexpr (G.affine) {
      arm[0] += w(0, i) * r(0, i) * x.velocity;
      if constexpr (D == 3) arm[1] += w(0, i) * arm_y;
      arm[D - 1] += w(0, i) * x.arm;
    }
    if constexpr (G.gradient) {
      gradient[0] += g(0, i) * x.source;
      if constexpr (D == 3) gradient[1] += w(0, i) * gradient_y;
      gradient[D - 1] += w(0, i) * x.gradient;
    }
  }
  out.velocity[lane] = velocity;
  out.old[lane] = before;
  for (int d = 0; d < D; ++d) {
    out.arm[d][lane] = arm[d];
    out.gradient[d][lane] = gradient[d];
  }
}

/// Writes what was gathered to a chunk; returns the largest speed that particles were moved with.
template <int D, class Kernel, Gather G>
[[gnu::always_inline]] inline Lanes update_chunk(Batch<D> const& batch, Lanes* chunk, Sums<D, G> const& sums, double dt,
                                                 double alpha, Matrix<Lanes, D>* dt_gradient) {
  auto const pic = to_lanes(sums.velocity);
  Lanes speed(0.0);
  if constexpr (G.update) {
    auto const old = to_lanes(sums.old);
    Lanes* v = chunk + batch.at.velocity;
    for (int d = 0; d < D; ++d)
      v[d] = G.second == Gather::Second::none ? pic[d] : Lanes(alpha) * (v[d] - old[d]) + pic[d];
    if constexpr (G.affine) {
      Lanes const inverse(1.0 / (Kernel::inertia * batch.spacing * batch.spacing));
      for (int d = 0; d < D; ++d) {
        auto const column = to_lanes(sums.arm[d]);
        for (int i = 0; i < D; ++i) chunk[batch.at.affine + i * D + d] = inverse * column[i];
      }
    }
  }
  if constexpr (G.gradient)
    for (int d = 0; d < D; ++d) {
      auto const column = to_lanes(sums.gradient[d]);
      for (int i = 0; i < D; ++i) (*dt_gradient)(i, d) = Lanes(dt) * column[i];
    }
  if constexpr (G.advect)
    for (int d = 0; d < D; ++d) {
      chunk[batch.at.position + d] += Lanes(dt) * pic[d];
      speed = max(speed, abs(pic[d]));
    }
  return speed;
}

}  // namespace detail

/// Gathers a batch from its block's arena. dt_gradient: dt L_p, one a chunk (where G.gradient).
template <int D, class Kernel, Gather G>
[[gnu::flatten]] void grid_to_particles(Batch<D> const& batch, NodeVector const* arena, double dt, double alpha,
                                        Matrix<Lanes, D>* dt_gradient, Motion& motion) {
  Lanes speed(0.0), gradient(0.0);
  detail::Sums<D, G> sums;
  for (int c = 0; c < batch.count; ++c) {
    Lanes* chunk = batch.chunk(c);
    __builtin_prefetch(chunk + batch.stride);
    Stencil<D, Kernel> const stencil(batch, chunk + batch.at.position);
    int const filled = batch.filled(c);
    for (int lane = 0; lane < filled; ++lane) detail::gather_one<D, Kernel, G>(stencil, lane, arena, sums);
    sums.clear_from(filled);
    speed = max(speed, detail::update_chunk<D, Kernel, G>(batch, chunk, sums, dt, alpha, dt_gradient + c));
    if constexpr (G.gradient) {
      Lanes square(0.0);
      for (Lanes const& entry : dt_gradient[c].entries) square += entry * entry;
      gradient = max(gradient, square);
    }
  }
  motion.speed = std::max(motion.speed, horizontal_max(speed));
  motion.gradient = std::max(motion.gradient, std::sqrt(horizontal_max(gradient)) / dt);
}

}  // namespace talus
