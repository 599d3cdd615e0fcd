#pragma once
/// The grid's part of a step: arenas are summed into nodes, nodes are moved, walls answer.
///
///   v_i^old = (mv)_i / m_i,   v_i* = v_i^old + dt f_i / m_i + dt g,   v_i = walls(v_i*)

#include <vector>

#include "core/parallel.hpp"
#include "core/scene.hpp"

namespace talus {

/// Change of momentum by each wall [kg m/s].
template <int D>
using Impulses = std::vector<Point<D>>;

template <int D>
class GridPass {
 public:
  static constexpr int nodes_per_block = D == 2 ? block_edge * block_edge : block_edge * block_edge * block_edge;

  explicit GridPass(Scene<D> const& scene) : scene_(scene) {}

  /// Sizes the storage for the blocks that exist. particle_mass: the largest mass of a particle [kg].
  void resize(BlockGrid<D> const& grid, double particle_mass) {
    arenas_.assign(grid.particle_blocks() * arena_size(), NodeVector(0.0));
    nodes_.assign(grid.node_blocks() * node_size(), NodeVector(0.0));
    impulses_.assign(grid.node_blocks() * scene_.walls.size(), Point<D>::Zero());
    mass_floor_ = scene_.stages->mass_floor * particle_mass;
  }

  /// Arena of particle block b, set to zero.
  NodeVector* cleared_arena(std::size_t b) {
    NodeVector* arena = arenas_.data() + b * arena_size();
    std::fill_n(arena, arena_size(), NodeVector(0.0));
    return arena;
  }

  /// Sums the arenas and moves the nodes from t to t + dt. Returns the impulse of each wall.
  Impulses<D> move(BlockGrid<D> const& grid, double t, double dt) {
    pass(grid, t, dt, false);
    return summed();
  }
  /// MUSL: sums the momentum of the moved particles into each node's second vector, walls applied again.
  void remap(BlockGrid<D> const& grid, double t, double dt) { pass(grid, t, dt, true); }

  /// Copies the nodes that particle block b reaches into `arena`.
  void load(BlockGrid<D> const& grid, std::size_t b, NodeVector* arena) const;

  [[nodiscard]] std::size_t arena_size() const {
    return static_cast<std::size_t>(scene_.stages->arena_nodes() * scene_.stages->vectors);
  }
  [[nodiscard]] std::size_t bytes() const { return (arenas_.size() + nodes_.size()) * sizeof(NodeVector); }

 private:
  struct Sum {
    NodeVector first{0.0}, second{0.0};
  };
  [[nodiscard]] std::size_t node_size() const {
    return static_cast<std::size_t>(nodes_per_block * scene_.stages->vectors);
  }

  /// Nodes of the overlap of arena and node block when the block is neighbour `step` of the arena's: [begin, end) in
  /// the node block; the arena's own number is node + shift.
  struct Overlap {
    int begin, end, shift;
  };
  [[nodiscard]] Overlap overlap(int step) const {
    int const shift = block_edge * step + 1;
    return {std::max(0, -shift), std::min(block_edge, scene_.stages->arena_edge - shift), shift};
  }

  /// Calls f(node in block, node in arena) for the overlap with neighbour number n.
  template <class F>
  void for_each_shared(int n, F const& f) const {
    BlockIndex<D> const step = neighbour_step<D>(n);
    int const edge = scene_.stages->arena_edge;
    Overlap const x = overlap(step[0]), y = overlap(step[1]);
    for (int i = x.begin; i < x.end; ++i)
      for (int j = y.begin; j < y.end; ++j) {
        int const node = i * block_edge + j, own = (i + x.shift) * edge + j + y.shift;
        if constexpr (D == 2) f(node, own);
        if constexpr (D == 3) {
          Overlap const z = overlap(step[2]);
          for (int k = z.begin; k < z.end; ++k) f(node * block_edge + k, own * edge + k + z.shift);
        }
      }
  }

  void pass(BlockGrid<D> const& grid, double t, double dt, bool again) {
    for_each_index(static_cast<std::ptrdiff_t>(grid.node_blocks()), [&](std::ptrdiff_t b) {
      std::array<Sum, nodes_per_block> sums{};
      gather(grid, static_cast<std::size_t>(b), again ? 1 : scene_.stages->vectors, sums.data());
      move_block(grid, static_cast<std::size_t>(b), t, dt, again, sums.data());
    });
  }

  void gather(BlockGrid<D> const& grid, std::size_t b, int vectors, Sum* sums) const {
    auto const& blocks = grid.particles_around(b);
    for (int n = 0; n < neighbour_count<D>; ++n) {
      if (blocks[static_cast<std::size_t>(n)] < 0) continue;
      NodeVector const* arena =
          arenas_.data() + static_cast<std::size_t>(blocks[static_cast<std::size_t>(n)]) * arena_size();
      for_each_shared(n, [&](int node, int own) {
        sums[node].first += arena[own * vectors];
        if (vectors == 2) sums[node].second += arena[own * vectors + 1];
      });
    }
  }

  void move_block(BlockGrid<D> const& grid, std::size_t b, double t, double dt, bool again, Sum const* sums);
  void apply_walls(std::span<int const> near, Point<D> const& x, double t, double dt, double mass, double friction,
                   Point<D>& v, Point<D>* impulses) const;
  int walls_near(Point<D> const& centre, double t, std::span<int> near) const;

  Impulses<D> summed() const {
    Impulses<D> sum(scene_.walls.size(), Point<D>::Zero());
    for (std::size_t k = 0; k < impulses_.size(); ++k) sum[k % sum.size()] += impulses_[k];
    return sum;
  }

  Scene<D> const& scene_;
  std::vector<NodeVector> arenas_, nodes_;
  std::vector<Point<D>> impulses_;
  double mass_floor_ = 0;
};

template <int D>
void GridPass<D>::load(BlockGrid<D> const& grid, std::size_t b, NodeVector* arena) const {
  auto const& blocks = grid.nodes_around(b);
  int const vectors = scene_.stages->vectors;
  for (int n = 0; n < neighbour_count<D>; ++n) {
    NodeVector const* nodes =
        nodes_.data() + static_cast<std::size_t>(blocks[static_cast<std::size_t>(n)]) * node_size();
    for_each_shared(n, [&](int node, int own) {
      arena[own * vectors] = nodes[node * vectors];
      if (vectors == 2) arena[own * vectors + 1] = nodes[node * vectors + 1];
    });
  }
}

template <int D>
int GridPass<D>::walls_near(Point<D> const& centre, double t, std::span<int> near) const {
  int count = 0;
  double const reach = scene_.spacing * (1 + 0.5 * (block_edge - 1) * std::sqrt(double(D)));
  for (std::size_t w = 0; w < scene_.walls.size(); ++w)
    if (scene_.walls[w]->distance(centre, t) <= reach) near[static_cast<std::size_t>(count++)] = static_cast<int>(w);
  return count;
}

template <int D>
void GridPass<D>::apply_walls(std::span<int const> near, Point<D> const& x, double t, double dt, double mass,
                              double friction, Point<D>& v, Point<D>* impulses) const {
  std::array<Touch<D>, most_touches> touches;
  std::array<Point<D>, most_touches> changes;
  std::array<Surface<D>, Wall<D>::max_surfaces> surfaces;
  std::size_t count = 0;
  for (int w : near) {
    Wall<D> const& wall = *scene_.walls[static_cast<std::size_t>(w)];
    int const n = wall.surfaces(x + dt * v, t + dt, surfaces);
    for (int s = 0; s < n && count < most_touches; ++s)
      if (Surface<D> const& surface = surfaces[static_cast<std::size_t>(s)]; surface.distance <= 0)
        touches[count++] = {surface.normal, wall.velocity(t + dt), wall.contact,
                            wall.contact.material_friction ? friction : wall.contact.friction, w};
  }
  if (count == 0) return;
  v = resolve<D>(std::span(touches.data(), count), v, std::span(changes.data(), count));
  for (std::size_t k = 0; k < count; ++k) impulses[touches[k].wall] += mass * changes[k];
}

template <int D>
void GridPass<D>::move_block(BlockGrid<D> const& grid, std::size_t b, double t, double dt, bool again,
                             Sum const* sums) {
  int const vectors = scene_.stages->vectors;
  NodeVector* nodes = nodes_.data() + b * node_size();
  Point<D>* impulses = impulses_.data() + b * scene_.walls.size();
  if (!again) std::fill_n(impulses, scene_.walls.size(), Point<D>::Zero());
  std::vector<Point<D>> ignored;  // a remap moves no momentum
  BlockIndex<D> const place = grid.node_block(b);
  Point<D> corner;
  for (int d = 0; d < D; ++d) corner[d] = scene_.spacing * block_edge * place[static_cast<std::size_t>(d)];
  std::array<int, most_walls> near_buffer;
  int const near_count =
      walls_near(corner + Point<D>::Constant(0.5 * (block_edge - 1) * scene_.spacing), t + dt, near_buffer);
  std::span<int const> const near(near_buffer.data(), static_cast<std::size_t>(near_count));
  if (again) ignored.assign(scene_.walls.size(), Point<D>::Zero());

  for (int n = 0; n < nodes_per_block; ++n) {
    Sum const& sum = sums[n];
    double const mass = sum.first[D];
    NodeVector& out = nodes[n * vectors + (again ? 1 : 0)];
    if (!(mass > 0)) {
      out = NodeVector(0.0);
      if (!again && vectors == 2) nodes[n * vectors + 1] = NodeVector(0.0);
      continue;
    }
    Point<D> x = corner, v, old;
    int index = n;
    for (int d = D - 1; d >= 0; --d, index /= block_edge) x[d] += scene_.spacing * (index % block_edge);
    for (int d = 0; d < D; ++d) old[d] = sum.first[d] / mass;
    v = old;
    if (!again) {
      for (int d = 0; d < D; ++d) v[d] += sum.second[d] / std::max(mass, mass_floor_) + dt * scene_.gravity[d];
    }
    if (near_count > 0) apply_walls(near, x, t, dt, mass, sum.second[D] / mass, v, again ? ignored.data() : impulses);
    out = NodeVector(0.0);
    for (int d = 0; d < D; ++d) out.set(d, v[d]);
    if (!again && vectors == 2) {
      nodes[n * vectors + 1] = NodeVector(0.0);
      for (int d = 0; d < D; ++d) nodes[n * vectors + 1].set(d, old[d]);
    }
  }
}

}  // namespace talus
