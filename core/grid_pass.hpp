#pragma once
/// The grid's part of a step: arenas are added to the nodes, nodes are moved, walls answer.
///
///   v_i^old = (mv)_i / m_i,   v_i* = v_i^old + dt f_i / m_i + dt g,   v_i = walls(v_i*)

#include <atomic>
#include <vector>

#include "core/mirror.hpp"
#include "core/parallel.hpp"
#include "core/scene.hpp"

namespace talus {

/// Change of momentum by each wall [kg m/s].
template <int D>
using Impulses = std::vector<Point<D>>;

/// The first two components of a, then those of b.
inline NodeVector beside(NodeVector a, NodeVector b) {
  return NodeVector(__builtin_shufflevector(a.value, b.value, 0, 1, 4, 5));
}

template <int D>
class GridPass {
 public:
  static constexpr int nodes_per_block = talus::nodes_per_block<D>;

  /// Throws InputError where a wall cannot mirror.
  explicit GridPass(Scene<D> const& scene) : scene_(scene), mirrors_(scene.walls, scene.spacing) {}

  /// Sizes the storage for the blocks that exist. particle_mass: the largest mass of a particle [kg].
  void resize(BlockGrid<D> const& grid, double particle_mass) {
    sums_.assign(grid.node_blocks() * sums_size(), NodeVector(0.0));
    nodes_.assign(grid.node_blocks() * node_size(), NodeVector(0.0));
    impulses_.assign(grid.node_blocks() * scene_.walls.size(), Point<D>::Zero());
    auto const nodes = grid.node_blocks() * static_cast<std::size_t>(nodes_per_block);
    body_.assign(scene_.body_force ? nodes : 0, NodeVector(0.0));
    momenta_.assign(scene_.keeps_ledger ? nodes : 0, NodeVector(0.0));
    before_.resize(scene_.keeps_ledger ? nodes : 0);
    mirrors_.find(grid);
    mirrored_.assign(mirrors_.images().empty() ? 0 : nodes, 0);
    mass_floor_ = scene_.stages->mass_floor * particle_mass;
  }

  /// Forgets what was added and not moved.
  void clear() {
    for (auto* sums : {&sums_, &body_, &momenta_}) std::fill(sums->begin(), sums->end(), NodeVector(0.0));
  }

  /// Adds an arena of particle block b to the nodes; the arena is zero afterwards. Not at the same time as another
  /// block of a different colour.
  void add(BlockGrid<D> const& grid, std::size_t b, NodeVector* arena) {
    for_each_node_block(grid, b, [&](int n, std::size_t block) {
      scene_.stages->add_arena(arena, n, sums_.data() + block * sums_size());
    });
  }
  /// The same of arenas of one vector a node: the momentum of moved particles, for `remap`; that of particles which have
  /// not moved, for the ledger; the impulse of the body force.
  void add_moved(BlockGrid<D> const& grid, std::size_t b, NodeVector* arena) {
    add_single(grid, b, arena, sums_, sums_size());
  }
  void add_momentum(BlockGrid<D> const& grid, std::size_t b, NodeVector* arena) {
    add_single(grid, b, arena, momenta_, nodes_per_block);
  }
  void add_body_force(BlockGrid<D> const& grid, std::size_t b, NodeVector* arena) {
    add_single(grid, b, arena, body_, nodes_per_block);
  }

  /// Moves the nodes from t to t + dt; adds the impulse of each wall to `impulses`. What was added is used up.
  void move(BlockGrid<D> const& grid, double t, double dt, Impulses<D>& impulses) {
    if (!mirrors_.images().empty()) fold(t, dt);
    for_each_index(static_cast<std::ptrdiff_t>(grid.node_blocks()), [&](std::ptrdiff_t b) {
      auto const block = static_cast<std::size_t>(b);
      move_block(grid, block, t, dt, sums_.data() + block * sums_size());
    });
    if (!mirrors_.images().empty()) {
      unfold(t + dt);
      account_for_mirrors();
    }
    std::size_t const walls = impulses.size();
    for (std::size_t k = 0; k < impulses_.size(); ++k) impulses[k % walls] += impulses_[k];
  }

  /// Whether more faces touched a node than are resolved together; the velocity of that node is then of no use.
  [[nodiscard]] bool crowded() const { return crowded_; }

  /// MUSL: makes the momentum of the moved particles each node's second velocity, walls applied again.
  void remap(BlockGrid<D> const& grid, double t, double dt) {
    for (Image<D> const& image : mirrors_.images())
      fold_vector(image, mirrors_.shift(image, t + dt), remapped(image.real), remapped(image.node));
    for_each_index(static_cast<std::ptrdiff_t>(grid.node_blocks()), [&](std::ptrdiff_t b) {
      auto const block = static_cast<std::size_t>(b);
      remap_block(grid, block, t, dt, sums_.data() + block * sums_size());
    });
    unfold(t + dt);
  }

  /// Copies the nodes that particle block b reaches into `arena`.
  void load(BlockGrid<D> const& grid, std::size_t b, NodeVector* arena) const {
    for_each_node_block(grid, b, [&](int n, std::size_t block) {
      scene_.stages->load_arena(nodes_.data() + block * node_size(), n, arena);
    });
  }

  /// What the ledger asks of the nodes after a step of dt, once they hold what the particles are told.
  [[nodiscard]] NodeTotals<D> account(BlockGrid<D> const& grid, double dt) const;

  /// Vectors of an arena that particles scatter into, and of one that they gather from.
  [[nodiscard]] std::size_t summed_size() const {
    return static_cast<std::size_t>(scene_.stages->arena_nodes * scene_.stages->summed);
  }
  [[nodiscard]] std::size_t told_size() const {
    return static_cast<std::size_t>(scene_.stages->arena_nodes * scene_.stages->told);
  }
  [[nodiscard]] std::size_t bytes() const {
    return (sums_.size() + nodes_.size() + body_.size() + momenta_.size()) * sizeof(NodeVector) +
           before_.size() * sizeof(Before);
  }

 private:
  [[nodiscard]] std::size_t sums_size() const {
    return static_cast<std::size_t>(nodes_per_block * scene_.stages->summed);
  }
  [[nodiscard]] std::size_t node_size() const {
    return static_cast<std::size_t>(nodes_per_block * scene_.stages->told);
  }

  /// Calls f(n, node block) for the blocks around particle block b.
  template <class F>
  void for_each_node_block(BlockGrid<D> const& grid, std::size_t b, F const& f) const {
    auto const& blocks = grid.nodes_around(b);
    for (int n = 0; n < neighbour_count<D>; ++n) f(n, static_cast<std::size_t>(blocks[static_cast<std::size_t>(n)]));
  }
  void add_single(BlockGrid<D> const& grid, std::size_t b, NodeVector* arena, std::vector<NodeVector>& sums,
                  std::size_t pitch) {
    for_each_node_block(
        grid, b, [&](int n, std::size_t block) { scene_.stages->add_single(arena, n, sums.data() + block * pitch); });
  }

  /// A node before the walls answered: for the ledger.
  struct Before {
    double mass = 0;
    NodeVector old, free;      ///< v^old and v* [m/s]
    NodeVector impulse, body;  ///< of stress, and of the body force [kg m/s]
  };
  [[nodiscard]] Before before(std::size_t node, double mass, NodeVector momentum, NodeVector pushed,
                              NodeVector free) const;
  [[nodiscard]] NodeTotals<D> account_block(BlockGrid<D> const& grid, std::size_t b, double dt) const;

  /// The walls that a block's nodes may touch.
  struct Near {
    Point<D> corner;  ///< place of the block's first node
    std::array<int, most_walls> walls;
    std::size_t count = 0;
  };
  [[nodiscard]] Point<D> corner_of(BlockGrid<D> const& grid, std::size_t b) const {
    Point<D> corner;
    for (int d = 0; d < D; ++d)
      corner[d] = scene_.spacing * block_edge * grid.node_block(b)[static_cast<std::size_t>(d)];
    return corner;
  }
  /// Place of node n of the block that begins at x.
  [[nodiscard]] Point<D> node_from(Point<D> x, int n) const {
    for (int d = D - 1; d >= 0; --d, n /= block_edge) x[d] += scene_.spacing * (n % block_edge);
    return x;
  }
  [[nodiscard]] Near near(BlockGrid<D> const& grid, std::size_t b, double t) const;

  void move_block(BlockGrid<D> const& grid, std::size_t b, double t, double dt, NodeVector* sums);
  void remap_block(BlockGrid<D> const& grid, std::size_t b, double t, double dt, NodeVector* sums);
  NodeVector walled(Near const& near, int n, double t, double dt, double mass, double friction, NodeVector velocity,
                    Point<D>* impulses);

  /// What a node got of the particles before the mirrors folded it.
  struct Sent {
    double mass = 0;
    Point<D> momentum = Point<D>::Zero();  ///< with the step's impulses, but for the share that particles keep [kg m/s]
  };
  void fold(double t, double dt);
  [[nodiscard]] Sent sent(std::size_t node, double dt);
  static void fold_vector(Image<D> const& image, Point<D> const& shift, NodeVector& real, NodeVector& image_sum);
  void unfold(double t);
  void account_for_mirrors();
  [[nodiscard]] NodeVector* sums_of(std::size_t node) {
    return sums_.data() + node * static_cast<std::size_t>(scene_.stages->summed);
  }
  [[nodiscard]] NodeVector& remapped(std::size_t node) {
    return sums_[node / nodes_per_block * sums_size() + node % nodes_per_block];
  }

  Scene<D> const& scene_;
  Mirrors<D> mirrors_;
  std::vector<char> mirrored_;  ///< by node: whether a mirror folded it
  std::vector<Sent> sent_;      ///< of each image
  std::vector<Sent> sent_to_real_,
      free_;                         ///< of each image's node, at its first image; free_: after folding, g applied
  std::vector<NodeVector> sums_;     ///< of momentum and mass, and what else a node sums; zero between steps
  std::vector<NodeVector> nodes_;    ///< velocities
  std::vector<NodeVector> body_;     ///< impulses of the body force, where there is one
  std::vector<NodeVector> momenta_;  ///< momentum and mass, where the ledger is kept
  std::vector<Before> before_;       ///< likewise
  std::vector<Point<D>> impulses_;   ///< of each node block and wall
  double mass_floor_ = 0;
  std::atomic<bool> crowded_ = false;
};

template <int D>
void GridPass<D>::move_block(BlockGrid<D> const& grid, std::size_t b, double t, double dt, NodeVector* sums) {
  Stages<D> const& stages = *scene_.stages;
  Near const near = this->near(grid, b, t + dt);
  Point<D>* impulses = impulses_.data() + b * scene_.walls.size();
  std::fill_n(impulses, scene_.walls.size(), Point<D>::Zero());
  NodeVector g(0.0);
  for (int d = 0; d < D; ++d) g.set(d, dt * scene_.gravity[d]);
  bool const walls = !scene_.walls.empty(), extras = scene_.body_force || scene_.keeps_ledger;
  auto const fast = [&, limit = scene_.spacing / dt](NodeVector v) {
    double square = 0;
    for (int d = 0; d < D; ++d) square += v[d] * v[d];
    return !(square <= limit * limit);
  };

  auto const folded = [&](int n) {
    return !mirrored_.empty() && mirrored_[b * nodes_per_block + static_cast<std::size_t>(n)] != 0;
  };

  for (int n = 0; n < nodes_per_block; ++n) {
    NodeVector const momentum = sums[n * stages.summed];
    double const mass = momentum[D];
    NodeVector* out = nodes_.data() + b * node_size() + n * stages.told;
    if (!(mass > 0)) {
      std::fill_n(out, stages.told, NodeVector(0.0));
      if (scene_.keeps_ledger && !folded(n)) before_[b * nodes_per_block + static_cast<std::size_t>(n)] = {};
      continue;
    }
    NodeVector const old = momentum / NodeVector(mass);
    NodeVector v = old + g;
    double friction = 0;
    if (stages.apart) {
      NodeVector const impulse = sums[n * stages.summed + 1];
      v += impulse / NodeVector(std::max(mass, mass_floor_));
      if (stages.friction) friction = (D == 2 ? momentum[3] : impulse[3]) / mass;
    } else if (stages.friction) {
      friction = old[3];
    }
    if (extras) [[unlikely]] {
      std::size_t const node = b * nodes_per_block + static_cast<std::size_t>(n);
      if (scene_.body_force) v += body_[node] / NodeVector(std::max(mass, mass_floor_));
      if (scene_.keeps_ledger && !folded(n))
        before_[node] = before(node, mass, momentum, sums[(n + 1) * stages.summed - 1], v);
    }
    if (near.count > 0 || (walls && fast(v))) v = walled(near, n, t, dt, mass, friction, v, impulses);
    out[0] = D == 2 ? beside(v, stages.incremental ? old : v) : v;
    if (stages.told == 2) out[1] = old;
  }
  std::fill_n(sums, sums_size(), NodeVector(0.0));
  for (auto* more : {&body_, &momenta_})
    if (!more->empty()) std::fill_n(more->data() + b * nodes_per_block, nodes_per_block, NodeVector(0.0));
}

template <int D>
void GridPass<D>::remap_block(BlockGrid<D> const& grid, std::size_t b, double t, double dt, NodeVector* sums) {
  Near const near = this->near(grid, b, t + dt);
  Point<D> ignored[most_walls];  // a remap moves no momentum
  for (int n = 0; n < nodes_per_block; ++n) {
    NodeVector* out = nodes_.data() + b * node_size() + n * scene_.stages->told;
    double const mass = sums[n][D];
    NodeVector v(0.0);
    if (mass > 0) v = sums[n] / NodeVector(mass);
    if (mass > 0 && !scene_.walls.empty()) v = walled(near, n, t, dt, mass, 0, v, ignored);
    if constexpr (D == 2) out[0] = beside(out[0], v);
    if constexpr (D == 3) out[1] = v;
  }
  std::fill_n(sums, sums_size(), NodeVector(0.0));
}

}  // namespace talus

#include "core/grid_account.hpp"
#include "core/grid_mirror.hpp"
#include "core/grid_walls.hpp"
