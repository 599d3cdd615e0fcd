#pragma once
/// The nodes' answer to walls: what core/grid_pass.hpp declares.

#include "core/grid_pass.hpp"

namespace talus {

/// A wall is near where a node that moves no further than one spacing may touch it.
template <int D>
typename GridPass<D>::Near GridPass<D>::near(BlockGrid<D> const& grid, std::size_t b, double t) const {
  Near near;
  near.corner = corner_of(grid, b);
  Point<D> const centre = near.corner + Point<D>::Constant(0.5 * (block_edge - 1) * scene_.spacing);
  double const reach = scene_.spacing * (1 + 0.5 * (block_edge - 1) * std::sqrt(double(D)));
  for (std::size_t w = 0; w < scene_.walls.size(); ++w)
    if (scene_.walls[w]->distance(centre, t) <= reach) near.walls[near.count++] = static_cast<int>(w);
  return near;
}

/// The velocity that the walls leave node n of a block that would move with `velocity`.
template <int D>
NodeVector GridPass<D>::walled(Near const& near, int n, double t, double dt, double mass, double friction,
                               NodeVector velocity, Point<D>* impulses) {
  std::array<Touch<D>, most_touches> touches;
  std::array<Point<D>, most_touches> changes;
  std::array<Surface<D>, Wall<D>::max_surfaces> surfaces;
  std::size_t count = 0;
  Point<D> v;
  for (int d = 0; d < D; ++d) v[d] = velocity[d];
  Point<D> const x = node_from(near.corner, n) + dt * v;
  // a node of next to no mass may be thrown beyond the walls that are near
  bool const far = !(dt * v.norm() <= scene_.spacing);
  std::size_t const candidates = far ? scene_.walls.size() : near.count;
  for (std::size_t k = 0; k < candidates; ++k) {
    int const w = far ? static_cast<int>(k) : near.walls[k];
    Wall<D> const& wall = *scene_.walls[static_cast<std::size_t>(w)];
    double nearest = far_away;  // of the faces that the node does not touch
    auto const touch = [&](Point<D> const& place, double when, double slack) {
      int const faces = wall.surfaces(place, when, surfaces);
      for (int s = 0; s < faces; ++s) {
        Surface<D> const& surface = surfaces[static_cast<std::size_t>(s)];
        if (!(surface.distance <= slack))
          nearest = std::min(nearest, surface.distance);
        else if (count == most_touches)
          crowded_ = true;
        else
          touches[count++] = {surface.normal, wall.velocity(t + dt), wall.contact,
                              wall.contact.material_friction ? friction : wall.contact.friction, w};
      }
    };
    touch(x, t + dt, 0);
    // what pulls as well does not let a node go that it has, and a node on it to rounding it has
    double const rounding = 1e-9 * scene_.spacing;
    if (wall.contact.holds() && nearest <= dt * (v - wall.velocity(t + dt)).norm() + rounding)
      touch(node_from(near.corner, n), t, rounding);
  }
  if (count == 0) return velocity;
  v = resolve<D>(std::span(touches.data(), count), v, std::span(changes.data(), count));
  for (std::size_t k = 0; k < count; ++k) impulses[touches[k].wall] += mass * changes[k];
  for (int d = 0; d < D; ++d) velocity.set(d, v[d]);
  return velocity;
}

}  // namespace talus
