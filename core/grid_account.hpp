#pragma once
/// The nodes' part of the ledger: what core/grid_pass.hpp declares.

#include "core/grid_pass.hpp"

namespace talus {

/// momentum: of the sums of the node. pushed: the vector of those sums that the impulse of stress is in.
template <int D>
typename GridPass<D>::Before GridPass<D>::before(std::size_t node, double mass, NodeVector momentum, NodeVector pushed,
                                                 NodeVector free) const {
  Before before{mass, momentum / NodeVector(mass), free, pushed, NodeVector(0.0)};
  if (!scene_.stages->apart) {
    before.old = momenta_[node] / NodeVector(mass);
    before.impulse = momentum - momenta_[node];
  }
  if (scene_.body_force) before.body = body_[node];
  return before;
}

template <int D>
NodeTotals<D> GridPass<D>::account(BlockGrid<D> const& grid, double dt) const {
  std::vector<NodeTotals<D>> blocks(grid.node_blocks());
  for_each_index(static_cast<std::ptrdiff_t>(blocks.size()), [&](std::ptrdiff_t b) {
    blocks[static_cast<std::size_t>(b)] = account_block(grid, static_cast<std::size_t>(b), dt);
  });
  NodeTotals<D> sum;
  for (NodeTotals<D> const& block : blocks) sum += block;
  return sum;
}

template <int D>
NodeTotals<D> GridPass<D>::account_block(BlockGrid<D> const& grid, std::size_t b, double dt) const {
  NodeTotals<D> sum;
  Point<D> const corner = corner_of(grid, b);
  auto const point = [](NodeVector v, int from = 0) {
    Point<D> p;
    for (int d = 0; d < D; ++d) p[d] = v[from + d];
    return p;
  };
  for (int n = 0; n < nodes_per_block; ++n) {
    Before const& node = before_[b * nodes_per_block + static_cast<std::size_t>(n)];
    if (!(node.mass > 0)) continue;
    NodeVector const* told = nodes_.data() + b * node_size() + n * scene_.stages->told;
    double const m = node.mass;
    Point<D> const old = point(node.old), free = point(node.free), moved = point(told[0]);
    Point<D> const straining = !scene_.stages->remaps ? moved : D == 2 ? point(told[0], 2) : point(told[1]);
    Point<D> const x = node_from(corner, n), jolt = m * (moved - free), steady = m * dt * scene_.gravity;
    sum.before += 0.5 * m * old.squaredNorm();
    sum.after += 0.5 * m * moved.squaredNorm();
    sum.walls += 0.5 * jolt.dot(moved + free);
    sum.stepping += point(node.impulse).dot(straining) + (steady + point(node.body)).dot(moved) -
                    0.5 * m * (free - old).dot(free + old);
    sum.spin_before += m * cross<D>(x, old);
    sum.spin_after += m * cross<D>(x, moved);
    sum.wall_torque += cross<D>(x, jolt);
  }
  return sum;
}

}  // namespace talus
