#pragma once
/// What a scene is filled with: a region of space, seeded with particles that move with an initial velocity.

#include <concepts>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "core/config/choice.hpp"
#include "core/errors.hpp"
#include "core/tensor.hpp"

namespace talus::body {

/// A part of D-dimensional space: whether a point [m] lies in it, its volume [m^D], the corners of a box around it [m].
/// A point on the boundary belongs to one side only, so that bodies that touch share no point.
template <class R>
concept Region = requires(R const region, Point<R::dimension> const& x) {
  { region.contains(x) } -> std::same_as<bool>;
  { region.volume() } -> std::same_as<double>;
  { region.bounds() } -> std::same_as<std::pair<Point<R::dimension>, Point<R::dimension>>>;
};

/// A velocity field [m/s] and its gradient dv_i/dx_j [1/s].
template <class M>
concept VelocityField = requires(M const motion, Point<M::dimension> const& x) {
  { motion.velocity(x) } -> std::same_as<Point<M::dimension>>;
  { motion.gradient(x) } -> std::same_as<Matrix<double, M::dimension>>;
};

namespace detail {
template <class P>
concept Placed = Policy<P> && requires(int D) {
  { P::source } -> std::convertible_to<std::string_view>;
  { P::supports(D) } -> std::same_as<bool>;
};
}  // namespace detail

/// The shape of a body: `In<D>` is the region that the parameters describe, for the dimensions that it supports.
template <class S>
concept BodyShape = detail::Placed<S> && requires(typename S::Parameters const& parameters) {
  { typename S::template In<2>(parameters) } -> Region;
};

/// How a body moves at first: `In<D>` is the motion that the parameters describe.
template <class V>
concept InitialVelocity = detail::Placed<V> && requires(typename V::Parameters const& parameters) {
  { typename V::template In<2>(parameters) } -> VelocityField;
  { typename V::template In<3>(parameters) } -> VelocityField;
};

/// How a region is filled with particles: how many a volume, and where.
template <class S, class R>
concept SeedingOf = Policy<S> && Region<R> && requires(S const seeding, R const& region, double h) {
  { seeding.template per_volume<R::dimension>(h) } -> std::same_as<double>;
  { seeding.points(region, h) } -> std::same_as<std::vector<Point<R::dimension>>>;
};

/// The particles of a body at first.
template <int D>
struct Seeds {
  std::vector<Point<D>> points;  ///< positions [m]
  double volume = 0;             ///< of each particle: the region's over their number [m^D]
};

/// More particles than this are refused.
inline constexpr double most_particles = 2e8;

/// Fills a region with particles; h [m] is the spacing of the grid's nodes.
///
/// Throws InputError when the box around the region would take more than `most_particles` (which bounds memory and time
/// whatever the region's form), and when the region is so small that it holds none.
template <Region R, SeedingOf<R> Seeding>
[[nodiscard]] Seeds<R::dimension> seed(R const& region, Seeding const& seeding, double h) {
  constexpr int D = R::dimension;
  if (!(h > 0)) throw InputError("the spacing of the grid must be positive");
  auto const [low, high] = region.bounds();
  double const expected = (high - low).prod() * seeding.template per_volume<D>(h);
  if (!(expected <= most_particles)) {
    constexpr double bytes = 8 * (2 * D + 1 + D * (D + 1) / 2);  // position, velocity, mass, strain
    std::ostringstream text;
    text << "to fill the box around the body takes about " << expected << " particles and at least "
         << expected * bytes / 1e9 << " GB; at most " << most_particles
         << " particles are allowed: take a coarser grid or fewer particles a cell";
    throw InputError(text.str());
  }
  Seeds<D> seeds{seeding.points(region, h), 0};
  if (seeds.points.empty())
    throw InputError("the body holds no particle: it is smaller than the distance between them");
  seeds.volume = region.volume() / static_cast<double>(seeds.points.size());
  return seeds;
}

}  // namespace talus::body
