#pragma once
/// The particles that every scene of the benchmarks begins with: a block that sloshes in a box.

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

#include "core/tensor.hpp"

namespace talus::bench {

/// A block of material in the corner of a box: the walls are the coordinate planes through `low`.
template <int D>
struct Cloud {
  double spacing = 0;                        ///< h [m]
  double volume = 0;                         ///< of each particle [m^D]
  Point<D> low = Point<D>::Zero();           ///< the corner [m]
  Point<D> high = Point<D>::Zero();          ///< upper corner of the block [m]
  std::vector<Point<D>> places, velocities;  ///< [m], [m/s]

  [[nodiscard]] std::size_t count() const { return places.size(); }
};

/// How a block is filled: about `particles` of them, `a_cell` in a cell in 2-D as 2 x 3 for six, each displaced by
/// `jitter` of its share of a cell, moving with `speed` [m/s] in one vortex of the block's size.
struct Filling {
  std::size_t particles = 150'000;
  int a_cell = 8;  ///< 8 in 3-D, 6 in 2-D
  double spacing = 0.01, jitter = 0.8, speed = 0.5;
  unsigned seed = 1;
};

/// A cube of whole cells. Throws nothing; the number of particles is the least that fills whole cells.
template <int D>
[[nodiscard]] Cloud<D> block(Filling const& filling, Point<D> const& low = Point<D>::Zero()) {
  // particles a cell along each axis
  Eigen::Array<int, D, 1> n = Eigen::Array<int, D, 1>::Constant(2);
  n[D - 1] = filling.a_cell / (D == 2 ? 2 : 4);
  double const cells = std::pow(static_cast<double>(filling.particles) / filling.a_cell, 1.0 / D);
  int const edge = static_cast<int>(std::ceil(cells - 1e-9));
  Cloud<D> cloud;
  cloud.spacing = filling.spacing;
  cloud.volume = std::pow(filling.spacing, D) / filling.a_cell;
  cloud.low = low;
  cloud.high = low + Point<D>::Constant(edge * filling.spacing);
  std::mt19937_64 random(filling.seed);
  std::uniform_real_distribution<double> shift(-0.5 * filling.jitter, 0.5 * filling.jitter);
  Eigen::Array<long, D, 1> const count = n.template cast<long>() * edge;
  for (long number = 0; number < count.prod(); ++number) {
    Point<D> x, v = Point<D>::Zero();
    long rest = number;
    for (int d = D - 1; d >= 0; --d) {
      x[d] = low[d] + filling.spacing / n[d] * (double(rest % count[d]) + 0.5 + shift(random));
      rest /= count[d];
    }
    Point<D> const u = std::numbers::pi / (edge * filling.spacing) * (x - low);
    v[0] = filling.speed * std::sin(u[0]) * std::cos(u[1]);
    v[1] = -filling.speed * std::cos(u[0]) * std::sin(u[1]);
    cloud.places.push_back(x);
    cloud.velocities.push_back(v);
  }
  return cloud;
}

}  // namespace talus::bench
