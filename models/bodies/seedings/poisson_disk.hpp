#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/config/parameters.hpp"
#include "core/tensor.hpp"

namespace talus::body {

namespace detail {

/// Uniform numbers in [0, 1), the same with every standard library (std::uniform_real_distribution is not).
class UnitInterval {
 public:
  explicit UnitInterval(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

/// One Poisson-disk sampling of a region, see PoissonDisk.
template <class Region>
class DiskSampling {
 public:
  static constexpr int D = Region::dimension;

  DiskSampling(Region const& region, double radius, int attempts, std::uint64_t seed)
      : region_(region),
        radius_(radius),
        attempts_(attempts),
        cell_(radius / std::sqrt(D) * (1 - 1e-9)),
        random_(seed) {
    std::tie(low_, high_) = region.bounds();
    count_ = ((high_ - low_).array() / cell_).floor().template cast<long long>() + 1;
    for (int axis = 0; axis < D; ++axis) stride_[axis] = axis == 0 ? 1 : stride_[axis - 1] * (count_[axis - 1] + 4);
    sample_in_.assign(static_cast<std::size_t>(stride_[D - 1] * (count_[D - 1] + 4)), none);
    find_neighbours();
  }

  std::vector<Point<D>> run() {
    for (long long place = 0; place < count_.prod(); ++place) {
      Cell cell;
      long long rest = place;
      for (int axis = 0; axis < D; ++axis) {
        cell[axis] = rest % count_[axis];
        rest /= count_[axis];
      }
      if (sample_in_[flat(cell)] == none && add(point_in(cell))) grow();
    }
    return std::move(points_);
  }

 private:
  using Cell = Eigen::Array<long long, D, 1>;
  static constexpr std::uint32_t none = 0xffffffff;

  /// Place of a cell in `sample_in_`, which has two more cells on every side so that no neighbour lies outside.
  [[nodiscard]] std::size_t flat(Cell const& cell) const {
    return static_cast<std::size_t>(((cell + 2) * stride_).sum());
  }
  /// Offsets to the cells that can hold a point closer than the radius, the nearest first.
  void find_neighbours() {
    std::vector<std::pair<long long, long long>> by_distance;
    for (int code = 0; code < (D == 2 ? 25 : 125); ++code) {
      Cell offset;
      for (int axis = 0, rest = code; axis < D; ++axis, rest /= 5) offset[axis] = rest % 5 - 2;
      by_distance.emplace_back(offset.square().sum(), (offset * stride_).sum());
    }
    std::sort(by_distance.begin(), by_distance.end());
    for (auto const& [distance, step] : by_distance) neighbours_.push_back(step);
  }
  /// A point of a cell, within the box around the region.
  Point<D> point_in(Cell const& cell) {
    Point<D> x;
    for (int axis = 0; axis < D; ++axis) {
      double const from = low_[axis] + static_cast<double>(cell[axis]) * cell_;
      x[axis] = from + random_() * std::min(cell_, high_[axis] - from);
    }
    return x;
  }
  /// A point at a distance of one to two radii, every volume of that shell as likely as another.
  Point<D> point_around(Point<D> const& centre) {
    for (;;) {
      Point<D> arm;
      for (int axis = 0; axis < D; ++axis) arm[axis] = 4 * random_() - 2;
      double const square = arm.squaredNorm();
      if (square >= 1 && square < 4) return centre + radius_ * arm;
    }
  }
  /// Takes x as a sample where it lies in the region and no sample is closer than the radius.
  bool add(Point<D> const& x) {
    if ((x.array() < low_.array()).any() || (x.array() > high_.array()).any()) return false;
    std::size_t const here = flat(((x - low_).array() / cell_).template cast<long long>());
    for (long long const step : neighbours_) {
      std::uint32_t const other = sample_in_[here + static_cast<std::size_t>(step)];
      if (other != none && (points_[other] - x).squaredNorm() < radius_ * radius_) return false;
    }
    if (!region_.contains(x)) return false;
    sample_in_[here] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(x);
    return true;
  }
  /// Adds samples around the last one, then around those, until no place is found any more.
  void grow() {
    active_.assign(1, points_.size() - 1);
    while (!active_.empty()) {
      auto const pick = static_cast<std::size_t>(random_() * static_cast<double>(active_.size()));
      bool found = false;
      for (int k = 0; k < attempts_ && !found; ++k) found = add(point_around(points_[active_[pick]]));
      if (found) {
        active_.push_back(points_.size() - 1);
      } else {
        active_[pick] = active_.back();
        active_.pop_back();
      }
    }
  }

  Region const& region_;
  double radius_;
  int attempts_;
  double cell_;  ///< its diagonal is just below the radius: a cell holds one sample at most
  UnitInterval random_;
  Point<D> low_, high_;
  Cell count_, stride_;
  std::vector<std::uint32_t> sample_in_;
  std::vector<long long> neighbours_;
  std::vector<Point<D>> points_;
  std::vector<std::size_t> active_;
};

}  // namespace detail

/// Points that keep a distance r from each other and leave hardly a hole, in no direction regular (blue noise).
///
///   r = (c V/N)^(1/D),  N = n V/h^D,  c = 0.6207 (D = 2), 0.60 (D = 3)     (1)
///
/// One sample starts. Around a random sample still active up to k places at a distance of r to 2 r are tried; the first
/// one that lies in the region and keeps the distance becomes a sample; a sample around which none was found is done.
/// Where this ends, one random place in every cell of the background grid without a sample is tried as a new start:
/// that fills parts of the region that hang together by a neck only, or not at all.
///
/// c was measured with k = 30 in boxes of some 100 r a side. It falls with their size, towards 0.617 and 0.586, because
/// samples gather at the boundary (in a layer of 0.7 r the density is 1.4 of the mean), and it rises with k. So r is
/// corrected by the number that came out, up to three times, until that is within 1.5 % of N, or 1; the nearest is
/// taken. Every particle has the volume V over the number that came out.
///
/// With k = 30 about two places in a thousand are farther than r from every sample. None of a box is farther than 2 r:
/// a cell of which every place is free gets a sample.
///
/// The quadrature is that of random points: do not expect an order of convergence in h.
///
/// Cost: O(N k) time and O(N) memory for regions that fill a fixed part of the box around them.
///
/// Source: Bridson (2007), doi:10.1145/1278780.1278807 (opening read); the restarts and the correction of r are ours.
struct PoissonDisk {
  static constexpr std::string_view name = "poisson_disk", title = "Poisson-disk sampling",
                                    source = "Bridson (2007), doi:10.1145/1278780.1278807";

  struct Parameters {
    int per_cell = 6;
    int seed = 42;
    int attempts = 30;
    static constexpr auto table() {
      return std::tuple{
          parameter(&Parameters::per_cell, "per_cell", "n", "1", "particles in a cell on average", closed(1, 10000)),
          parameter(&Parameters::seed, "seed", "s", "1", "seed of the random numbers", closed(0, 2147483647)),
          parameter(&Parameters::attempts, "attempts", "k", "1", "places tried around a particle", closed(1, 1000))};
    }
  };

  int per_cell, attempts;
  std::uint64_t random_seed;
  explicit PoissonDisk(Parameters const& p)
      : per_cell(p.per_cell), attempts(p.attempts), random_seed(static_cast<std::uint64_t>(p.seed)) {}

  /// Particles a volume [1/m^D] for the grid spacing h [m].
  template <int D>
  [[nodiscard]] double per_volume(double h) const {
    return per_cell / std::pow(h, D);
  }

  /// Points of the region with the distance r [m] or more between them. The same seed gives the same points.
  template <class Region>
  [[nodiscard]] std::vector<Point<Region::dimension>> sample(Region const& region, double r) const {
    return detail::DiskSampling<Region>(region, r, attempts, random_seed).run();
  }

  /// Points of the region, as many as (1) asks for.
  template <class Region>
  [[nodiscard]] std::vector<Point<Region::dimension>> points(Region const& region, double h) const {
    constexpr int D = Region::dimension;
    double const wanted = std::max(1.0, per_volume<D>(h) * region.volume());
    double r = std::pow((D == 2 ? 0.6207 : 0.60) * region.volume() / wanted, 1.0 / D);  // (1)
    auto const miss = [&](auto const& found) { return std::abs(static_cast<double>(found.size()) - wanted); };
    auto best = sample(region, r);
    auto count = static_cast<double>(best.size());
    for (int correction = 0; correction < 3 && miss(best) > std::max(1.0, 0.015 * wanted); ++correction) {
      r *= std::clamp(std::pow(count / wanted, 1.0 / D), 0.8, 2.0);
      auto found = sample(region, r);
      count = static_cast<double>(found.size());
      if (miss(found) < miss(best)) best = std::move(found);
    }
    return best;
  }
};

}  // namespace talus::body
