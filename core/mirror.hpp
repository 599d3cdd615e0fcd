#pragma once
/// Flat walls on a row of nodes that act as mirrors: what lies behind them is the image of what lies before.
///
///   v(x') = w + R (v(x) - w),   x' the image of x,   R = -1 where the wall sticks, 1 - 2 n n^T where it slips       (1)
///
/// for the velocity of the grid, so that it fulfils the wall's condition at the wall itself and not only at nodes, and
/// is as smooth there as inside. With c = (1 - R) w the momentum, mass and impulse that particles send to a node behind
/// are sent by the functions N_i + R N_i', the only ones that (1) leaves:
///
///   m_i += m_i',   (mv)_i += R ((mv)_i' - m_i' c),   f_i += R f_i'                                                (2)
///
/// also of gravity and of body forces. Kernels reach one row behind a wall. Behind two mirrors, at a corner, one is
/// applied after the other. Without mirrors N_i does not vanish on the wall, and the balance of the nodes before it
/// lacks the wall's traction N_i: stress is wrong in the first cell, and an affine transfer, whose C_p does not see the
/// kink at the wall, drags.
///
/// Source: the method of images; derived here for the transfers.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/block_grid.hpp"
#include "core/errors.hpp"
#include "core/wall.hpp"

namespace talus {

/// Where a wall mirrors: the row of nodes along `axis` on which it lies; side: +1 where the material has the larger
/// coordinates, else -1.
struct MirrorPlane {
  int axis = 0, side = 1;
  std::int32_t row = 0;
};

/// Throws InputError where the wall cannot mirror: it must be one flat face across an axis, on a row of nodes for all
/// times. Whether it has other faces elsewhere is the caller's to know.
template <int D>
[[nodiscard]] MirrorPlane mirror_plane(Wall<D> const& wall, double spacing) {
  auto const refuse = [&](std::string const& why) {
    throw InputError("wall '" + wall.name + "': a mirror must lie across an axis on a row of nodes, " + why);
  };
  std::array<Surface<D>, Wall<D>::max_surfaces> faces, later;
  Point<D> const origin = Point<D>::Zero();
  int const count = wall.surfaces(origin, 0, faces);
  wall.surfaces(origin, 1e12, later);
  Point<D> const n = faces[0].normal;
  MirrorPlane plane;
  double const largest = n.cwiseAbs().maxCoeff(&plane.axis);
  if (count != 1 || largest != 1) refuse("its normal along the axis");
  plane.side = n[plane.axis] > 0 ? 1 : -1;
  double const place = -faces[0].distance * plane.side / spacing, row = std::round(place);
  if (!(std::abs(row) < 4.0 * farthest_block))
    refuse("in reach of the grid; it lies at " + std::to_string(place) + " spacings");
  if (!(std::abs(place - row) <= 1e-9 * std::max(1.0, std::abs(row))))
    refuse("a multiple of the spacing from the origin; it lies at " + std::to_string(place) + " spacings");
  if (later[0].distance != faces[0].distance) refuse("and may move along itself only");
  plane.row = static_cast<std::int32_t>(row);
  return plane;
}

/// A node behind one or more mirrors.
template <int D>
struct Image {
  std::size_t node, real;  ///< of the grid: block * nodes of a block + node of the block
  Point<D> sign;           ///< R of (1), or the product of several: it is diagonal
  std::array<int, static_cast<std::size_t>(D)> walls{};
  int count = 0;  ///< mirrors that it lies behind
};

/// What is behind the mirrors of a scene.
template <int D>
class Mirrors {
 public:
  /// Throws InputError as mirror_plane does.
  explicit Mirrors(std::vector<std::unique_ptr<Wall<D>>> const& walls, double spacing) : walls_(walls) {
    for (std::size_t w = 0; w < walls.size(); ++w)
      if (walls[w]->contact.mirrors) planes_.push_back({mirror_plane(*walls[w], spacing), static_cast<int>(w)});
  }

  [[nodiscard]] bool empty() const { return planes_.empty(); }
  /// Sorted by their real nodes.
  [[nodiscard]] std::vector<Image<D>> const& images() const { return images_; }

  /// Finds the images among the nodes of a grid.
  void find(BlockGrid<D> const& grid) {
    images_.clear();
    for (std::size_t b = 0; b < grid.node_blocks() && !empty(); ++b)
      if (reaches_behind(grid.node_block(b)))
        for (int n = 0; n < nodes_per_block<D>; ++n) add(grid, b, n);
    std::ranges::sort(images_, [](Image<D> const& a, Image<D> const& b) {
      return a.real != b.real ? a.real < b.real : a.node < b.node;
    });
  }

  /// c of (1): what the velocity of a node behind is besides R times that of the real one [m/s].
  [[nodiscard]] Point<D> shift(Image<D> const& image, double t) const {
    Point<D> c = Point<D>::Zero();
    for (int k = 0; k < image.count; ++k) {
      Bound const& bound = planes_[static_cast<std::size_t>(image.walls[static_cast<std::size_t>(k)])];
      Point<D> const R = sign_of(bound), w = walls_[static_cast<std::size_t>(bound.wall)]->velocity(t);
      c = R.cwiseProduct(c - w) + w;
    }
    return c;
  }
  /// Number of the wall that answers for an image.
  [[nodiscard]] int wall(Image<D> const& image) const { return planes_[static_cast<std::size_t>(image.walls[0])].wall; }

 private:
  struct Bound {
    MirrorPlane plane;
    int wall;
  };
  [[nodiscard]] Point<D> sign_of(Bound const& bound) const {
    if (walls_[static_cast<std::size_t>(bound.wall)]->contact.sticks) return Point<D>::Constant(-1);
    Point<D> sign = Point<D>::Ones();
    sign[bound.plane.axis] = -1;
    return sign;
  }
  [[nodiscard]] bool reaches_behind(BlockIndex<D> const& block) const {
    return std::ranges::any_of(planes_, [&](Bound const& bound) {
      std::int32_t const first = block_edge * block[static_cast<std::size_t>(bound.plane.axis)];
      std::int32_t const behind = bound.plane.row - bound.plane.side;
      return first <= behind && behind < first + block_edge;
    });
  }
  void add(BlockGrid<D> const& grid, std::size_t b, int n) {
    BlockIndex<D> place = grid.node_block(b), within{};
    for (int d = D - 1, rest = n; d >= 0; --d, rest /= block_edge)
      place[static_cast<std::size_t>(d)] = block_edge * place[static_cast<std::size_t>(d)] + rest % block_edge;
    Image<D> image{b * nodes_per_block<D> + static_cast<std::size_t>(n), 0, Point<D>::Ones()};
    for (std::size_t k = 0; k < planes_.size(); ++k) {
      MirrorPlane const& plane = planes_[k].plane;
      auto& coordinate = place[static_cast<std::size_t>(plane.axis)];
      if (coordinate != plane.row - plane.side) continue;
      coordinate = plane.row + plane.side;
      image.sign = image.sign.cwiseProduct(sign_of(planes_[k]));
      image.walls[static_cast<std::size_t>(image.count++)] = static_cast<int>(k);
    }
    if (image.count == 0) return;
    for (std::size_t d = 0; d < D; ++d) {
      within[d] = ((place[d] % block_edge) + block_edge) % block_edge;
      place[d] = (place[d] - within[d]) / block_edge;
    }
    std::ptrdiff_t const block = grid.find_node_block(place);
    if (block < 0) return;
    image.real = static_cast<std::size_t>(block) * nodes_per_block<D>;
    std::size_t inner = 0;
    for (std::size_t d = 0; d < D; ++d) inner = inner * block_edge + static_cast<std::size_t>(within[d]);
    image.real += inner;
    images_.push_back(image);
  }

  std::vector<std::unique_ptr<Wall<D>>> const& walls_;
  std::vector<Bound> planes_;
  std::vector<Image<D>> images_;
};

}  // namespace talus
