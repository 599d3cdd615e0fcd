#include <algorithm>
#include <optional>

#include "models/compose.hpp"
#include "models/walls.hpp"

namespace talus {

namespace {

/// A half-space of the document, and the times at which its motion changes [s].
template <int D>
struct Plane {
  std::unique_ptr<Wall<D>> wall;
  std::vector<double> times;

  [[nodiscard]] Surface<D> surface(double t) const {
    std::array<Surface<D>, Wall<D>::max_surfaces> faces;
    wall->surfaces(Point<D>::Zero(), t, faces);
    return faces[0];
  }
};

template <int D>
Plane<D> plane_of(WallEntry const& entry) {
  Plane<D> plane;
  if (entry.shape.holds<wall::HalfSpace>()) plane.wall = wall_of<D>(entry);
  entry.motion.visit([&]<class M>(std::type_identity<M>, auto const& motion) {
    if constexpr (requires { motion.start; }) plane.times = {motion.start, motion.end};
  });
  return plane;
}

/// The first of the times, at which a motion changes or the run ends, when nothing is left between two planes that face
/// each other.
template <int D>
std::optional<double> closed_at(Plane<D> const& a, Plane<D> const& b, double end) {
  if (a.surface(0).normal.dot(b.surface(0).normal) > -1 + 1e-12) return {};
  std::vector<double> times{0, end};
  for (auto const* more : {&a.times, &b.times})
    for (double const t : *more)
      if (t > 0 && t < end) times.push_back(t);
  std::ranges::sort(times);
  auto const closed =
      std::ranges::find_if(times, [&](double t) { return !(a.surface(t).distance + b.surface(t).distance > 0); });
  return closed == times.end() ? std::nullopt : std::optional(*closed);
}

template <int D>
void check(Case const& document, std::vector<std::string>& wrong) {
  std::vector<Plane<D>> planes;
  for (WallEntry const& entry : document.walls) planes.push_back(plane_of<D>(entry));
  for (std::size_t k = 0; k < planes.size(); ++k)
    for (std::size_t j = 0; j < k; ++j)
      if (planes[j].wall && planes[k].wall)
        if (auto const t = closed_at(planes[j], planes[k], document.time.end))
          wrong.push_back("/walls/" + std::to_string(k) + ": between this wall and '" + document.walls[j].name +
                          "', which face each other, nothing is left at t = " + std::to_string(*t) +
                          " s; move them apart, or let them stop earlier");
}

}  // namespace

void check_gaps(Case const& document, int dimension, std::vector<std::string>& wrong) {
  dimension == 2 ? check<2>(document, wrong) : check<3>(document, wrong);
}

}  // namespace talus
