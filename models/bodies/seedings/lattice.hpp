#pragma once

#include <cmath>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/config/parameters.hpp"
#include "core/tensor.hpp"

namespace talus::body {

/// A regular lattice along the axes, commensurate with the grid: n particles a cell and direction.
///
///   x_k = x_low + (k + 1/2) h/n,  k = 0, 1, ...                        (1)
///
/// x_low is the lower corner of the box around the region. Where that corner is a node and the region is a box of whole
/// cells, every cell holds the same n^D particles and a constant stress exerts no force inside, to rounding.
///
/// Source: usual practice; what the quadrature of particles costs: Steffen, Kirby & Berzins (2008),
/// doi:10.1002/nme.2360 (abstract read).
struct Lattice {
  static constexpr std::string_view name = "lattice", title = "Regular lattice commensurate with the grid",
                                    source = "Steffen, Kirby & Berzins (2008), doi:10.1002/nme.2360";

  struct Parameters {
    int per_axis = 2;
    static constexpr auto table() {
      return std::tuple{parameter(&Parameters::per_axis, "per_axis", "n", "1", "particles in a cell along each axis",
                                  closed(1, 100))};
    }
  };

  int per_axis;
  explicit Lattice(Parameters const& p) : per_axis(p.per_axis) {}

  /// Particles a volume [1/m^D] for the grid spacing h [m].
  template <int D>
  [[nodiscard]] double per_volume(double h) const {
    return std::pow(per_axis / h, D);
  }

  /// The points (1) in the region, the last axis fastest. Cost: one look at every point of the box around it.
  template <class Region>
  [[nodiscard]] std::vector<Point<Region::dimension>> points(Region const& region, double h) const {
    constexpr int D = Region::dimension;
    auto const [low, high] = region.bounds();
    double const spacing = h / per_axis;
    Eigen::Array<long long, D, 1> const count = ((high - low).array() / spacing).ceil().template cast<long long>();
    std::vector<Point<D>> found;
    for (long long place = 0; place < count.prod(); ++place) {
      Point<D> x;
      long long rest = place;
      for (int axis = D - 1; axis >= 0; --axis) {
        x[axis] = low[axis] + (static_cast<double>(rest % count[axis]) + 0.5) * spacing;  // (1)
        rest /= count[axis];
      }
      if (region.contains(x)) found.push_back(x);
    }
    return found;
  }
};

}  // namespace talus::body
