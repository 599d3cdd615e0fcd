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

/// What a pass gathers. A node tells a second velocity where `second` says so: the one before the step (`old`) or the
/// one that was mapped back from the moved particles (`remapped`: MUSL takes the gradient from it). In the plane the two
/// share a vector, in space each has its own; `told` is the number of vectors of a node.
struct Gather {
  enum class Second { none, old, remapped };
  bool affine = false, update = true, gradient = true, advect = true;
  Second second = Second::none;
  int told = 1;
};

/// First component of a node's second velocity in its vector.
template <int D>
inline constexpr int second_component = D == 2 ? 2 : 0;

namespace detail {

/// What a particle gathers from its nodes, first along all dimensions but one:
///
///   S^x_i = sum_jk w_j w_k v_ijk,   S^y_j = sum_ik w_i w_k v_ijk,   S^z_k = sum_ij w_i w_j v_ijk        (6)
///   sum w v = sum_i w_i S^x_i,   sum w v (x - x_p)_d = h sum_k l_k S^d_k,   sum v dw/dx_d = sum_k g_k S^d_k / h  (7)
///
/// w: weights, l: levers, g: slopes. It is the way of the particles to the grid, (5) there, backwards.
/// sum[d][k][lane] is S^d_k of one particle.
template <int D, class Kernel>
struct Lines {
  NodeVector sum[D][Kernel::width][lanes];

  /// Zero from lane `filled` on: what lanes without a particle gather.
  void clear_from(int filled) {
    for (auto& dimension : sum)
      for (auto& line : dimension) std::fill(line + filled, line + lanes, NodeVector(0.0));
  }
};

/// The sums (6) of one particle over its stencil, of the first of each node's `vectors`. all: along every dimension,
/// else the first.
template <int D, class Kernel, int vectors, bool all>
[[gnu::always_inline]] inline void sum_lines(Stencil<D, Kernel> const& stencil, int lane, NodeVector const* arena,
                                             Lines<D, Kernel>& out) {
  constexpr int width = Kernel::width, edge = Stencil<D, Kernel>::edge;
  NodeVector const* const first = stencil.first(arena, lane, vectors);
  NodeVector along_y[width], along_z[width];
#pragma GCC unroll 4
  for (int i = 0; i < width; ++i) {
    NodeVector const w_i(stencil.weight[0][i][lane]);
    NodeVector along_x;
#pragma GCC unroll 4
    for (int j = 0; j < width; ++j) {
      NodeVector const w_j(stencil.weight[1][j][lane]);
      NodeVector line;
      if constexpr (D == 2) {
        line = in_register(first[(i * edge + j) * vectors]);
      } else {
        NodeVector const w_ij(stencil.pair[i][j][lane]);
#pragma GCC unroll 4
        for (int k = 0; k < width; ++k) {
          NodeVector const& node = first[((i * edge + j) * edge + k) * vectors];
          NodeVector const v = all ? in_register(node) : node;  // used twice or once
          NodeVector const w_k(stencil.weight[2][k][lane]);
          line = k == 0 ? w_k * v : line + w_k * v;
          if (all) along_z[k] = i == 0 && j == 0 ? w_ij * v : along_z[k] + w_ij * v;
        }
      }
      along_x = j == 0 ? w_j * line : along_x + w_j * line;
      if (all) along_y[j] = i == 0 ? w_i * line : along_y[j] + w_i * line;
    }
    out.sum[0][i][lane] = along_x;
  }
  if constexpr (all)
#pragma GCC unroll 4
    for (int k = 0; k < width; ++k) {
      out.sum[1][k][lane] = along_y[k];
      if constexpr (D == 3) out.sum[2][k][lane] = along_z[k];
    }
}

/// One chunk on its way from the grid: sums (6), then (7) for all its particles at once.
template <int D, class Kernel, Gather G>
struct Chunk {
  static constexpr bool remapped = G.second == Gather::Second::remapped, old = G.second == Gather::Second::old;
  static constexpr int width = Kernel::width;
  static constexpr bool second_apart = D == 3 && (remapped || old);  ///< the second velocity has sums of its own
  static_assert(!second_apart || G.told == 2);
  using Lines = detail::Lines<D, Kernel>;

  /// Values of a kernel at the nodes k along dimension d, for the particles of register r.
  using Values = Register[registers][D][width];

  Stencil<D, Kernel> stencil;
  Register weight[registers][width];  ///< along the first dimension
  Values slope, lever;
  Lines lines, second;

  [[gnu::always_inline]] Chunk(Batch<D> const& batch, Lanes const* chunk, int filled, NodeVector const* arena) {
    constexpr bool slopes_of_first = G.gradient && !(remapped && second_apart);
#pragma GCC unroll 2
    for (int r = 0; r < registers; ++r)
      stencil.place(
          batch, chunk, r, [&](int d, Axis<Kernel> const& axis) __attribute__((always_inline)) {
#pragma GCC unroll 4
            for (int k = 0; k < width; ++k) {
              if (d == 0) weight[r][k] = axis.weight[k];
              if constexpr (G.gradient) slope[r][d][k] = axis.slope[k];
              if constexpr (G.affine) lever[r][d][k] = axis.lever[k];
            }
          });
    for (int lane = 0; lane < filled; ++lane) {
      sum_lines<D, Kernel, G.told, G.affine || slopes_of_first>(stencil, lane, arena, lines);
      if constexpr (second_apart) sum_lines<D, Kernel, G.told, remapped>(stencil, lane, arena + 1, second);
    }
    if (filled < lanes) [[unlikely]] {
      lines.clear_from(filled);
      if constexpr (second_apart) second.clear_from(filled);
    }
  }

  /// S^d_k of the particles of register r, k by k.
  [[nodiscard, gnu::always_inline]] std::array<Components, width> along(Lines const& from, int d, int r) const {
    std::array<Components, width> sums;
#pragma GCC unroll 4
    for (int k = 0; k < width; ++k) sums[k] = to_lanes(from.sum[d][k] + r * register_lanes);
    return sums;
  }
};

/// sum_k f_k S_k of (7), from this component of the sums on.
template <int D, std::size_t width>
[[gnu::always_inline]] inline std::array<Register, D> contract(Register const (&factors)[width],
                                                               std::array<Components, width> const& sums,
                                                               int component = 0) {
  std::array<Register, D> total;
#pragma GCC unroll 4
  for (int c = 0; c < D; ++c) {
    total[c] = factors[0] * sums[0][component + c];
#pragma GCC unroll 4
    for (std::size_t k = 1; k < width; ++k) total[c] += factors[k] * sums[k][component + c];
  }
  return total;
}

/// The particles of register r of a chunk take over what they have gathered.
template <int D, class Kernel, Gather G>
struct Update {
  using From = Chunk<D, Kernel, G>;
  Batch<D> const& batch;
  Lanes* chunk;
  From const& from;
  double dt, alpha;
  Matrix<Lanes, D>* dt_gradient;

  /// Returns the largest speed that the particles move with.
  [[gnu::always_inline]] Register operator()(int r) const {
    Register speed(0.0);
#pragma GCC unroll 4
    for (int d = 0; d < D; ++d) {
      asm("" ::: "memory");  // one dimension after the other, or g++ runs out of registers for all of them
      auto const sums = from.along(from.lines, d, r);
      if (d == 0) speed = velocity(sums, r);
      if constexpr (G.update && G.affine) affine(sums, d, r);
      if constexpr (G.gradient && !(From::remapped && From::second_apart))
        gradient(sums, From::remapped ? second_component<D> : 0, d, r);
      if constexpr (G.gradient && From::remapped && From::second_apart)
        gradient(from.along(from.second, d, r), 0, d, r);
    }
    return speed;
  }

 private:
  using Sums = std::array<Components, Kernel::width>;

  [[gnu::always_inline]] Register velocity(Sums const& sums, int r) const {
    auto const pic = contract<D>(from.weight[r], sums);
    Lanes *x = chunk + batch.at.position, *v = chunk + batch.at.velocity;
    if constexpr (G.update && From::old) {
      auto const old = From::second_apart ? contract<D>(from.weight[r], from.along(from.second, 0, r))
                                          : contract<D>(from.weight[r], sums, second_component<D>);
      for (int c = 0; c < D; ++c) part(v[c], r) = Register(alpha) * (part(v[c], r) - old[c]) + pic[c];
    } else if constexpr (G.update) {
      for (int c = 0; c < D; ++c) part(v[c], r) = pic[c];
    }
    Register speed(0.0);
    if constexpr (G.advect)
      for (int c = 0; c < D; ++c) {
        part(x[c], r) += Register(dt) * pic[c];
        speed = max(speed, abs(pic[c]));
      }
    return speed;
  }

  [[gnu::always_inline]] void affine(Sums const& sums, int d, int r) const {
    Register const scale(1.0 / (Kernel::inertia * batch.spacing));
    auto const column = contract<D>(from.lever[r][d], sums);
    for (int c = 0; c < D; ++c) part(chunk[batch.at.affine + c * D + d], r) = scale * column[c];
  }

  [[gnu::always_inline]] void gradient(Sums const& sums, int component, int d, int r) const {
    Register const scale(dt / batch.spacing);
    auto const column = contract<D>(from.slope[r][d], sums, component);
    for (int c = 0; c < D; ++c) part((*dt_gradient)(c, d), r) = scale * column[c];
  }
};

}  // namespace detail

/// The largest speed, and the largest square of the norm of dt L, lane by lane.
struct Largest {
  Register speed{0.0}, gradient{0.0};
};

/// Gathers chunk c from its block's arena; dt_gradient: dt L_p (where G.gradient).
template <int D, class Kernel, Gather G>
[[gnu::always_inline]] inline void gather_chunk(Batch<D> const& batch, int c, NodeVector const* arena, double dt,
                                                double alpha, Matrix<Lanes, D>* dt_gradient, Largest& largest) {
  Lanes* chunk = batch.chunk(c);
  batch.prefetch(c);
  detail::Chunk<D, Kernel, G> const gathered(batch, chunk, batch.filled(c), arena);
  detail::Update<D, Kernel, G> const update{batch, chunk, gathered, dt, alpha, dt_gradient};
#pragma GCC unroll 2
  for (int r = 0; r < registers; ++r) largest.speed = max(largest.speed, update(r));
  if constexpr (G.gradient) {
    Lanes square(0.0);
    for (Lanes const& entry : dt_gradient->entries) square += entry * entry;
    largest.gradient = max(largest.gradient, max(square.low, square.high));
  }
}

/// Gathers a batch. dt_gradient has one entry a chunk.
template <int D, class Kernel, Gather G>
[[gnu::flatten]] void grid_to_particles(Batch<D> const& batch, NodeVector const* arena, double dt, double alpha,
                                        Matrix<Lanes, D>* dt_gradient, Motion& motion) {
  Largest largest;
  for (int c = 0; c < batch.count; ++c)
    gather_chunk<D, Kernel, G>(batch, c, arena, dt, alpha, G.gradient ? dt_gradient + c : nullptr, largest);
  motion.speed = std::max(motion.speed, horizontal_max(largest.speed));
  motion.gradient = std::max(motion.gradient, std::sqrt(horizontal_max(largest.gradient)) / dt);
}

}  // namespace talus
