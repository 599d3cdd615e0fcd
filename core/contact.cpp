#include "core/contact.hpp"

#include <algorithm>
#include <optional>

#include "core/closed_walls.hpp"

namespace talus {
namespace {

/// Whether an answer penetrates no wall, lets none pull, and is the sum of its parts. (Friction that loads the walls
/// without bound leaves pushes so large that the sum is lost.)
template <int D>
bool holds(Touches<D> const& touches, Point<D> const& v, Answer<D> const& answer) {
  constexpr double sum_is_kept = 1e6;  // times round-off
  auto const faces = touches.constraints();
  double const scale = scale_of(faces, v);
  if ((answer.velocity - v).template lpNorm<Eigen::Infinity>() > farthest * scale) return false;
  double const tolerance = 4 * round_off * std::max(scale, answer.velocity.template lpNorm<Eigen::Infinity>());
  Point<D> sum = v;
  for (std::size_t k = 0; k < touches.count; ++k) {
    sum += answer.pushes[k] * faces[k].normal + answer.drags[k];
    bool const pulls = !faces[k].is_plane && !(answer.pushes[k] >= 0);
    if (pulls || !faces[k].holds(answer.velocity, tolerance)) return false;
  }
  return (sum - answer.velocity).template lpNorm<Eigen::Infinity>() <= sum_is_kept * tolerance;
}

/// Friction of one wall may load or lift another that moves differently. Tried are the faces that are closed without
/// friction, then all sets of faces, small ones first; of several answers with as many faces the one nearest to v.
template <int D>
Answer<D> with_friction(Touches<D> const& touches, Point<D> const& v, Answer<D> const& without) {
  auto const tried = [&](ActiveSet<D> const& closed) {
    auto answer = Closed<D>(touches, closed, v).solve();
    if (answer && !holds(touches, v, *answer)) answer.reset();
    return answer;
  };
  ActiveSet<D> loaded;
  for (std::size_t k = 0; k < touches.count && loaded.size < D; ++k)
    if (without.pushes[k] != 0) loaded.add(k);
  std::optional<Answer<D>> best = tried(loaded);
  for (std::size_t size = 1; !best && size <= std::min(std::size_t{D}, touches.count); ++size) {
    auto closed = ActiveSet<D>::first(size);
    do {
      auto const answer = tried(closed);
      if (answer && (!best || (answer->velocity - v).norm() < (best->velocity - v).norm())) best = answer;
    } while (closed.next(touches.count));
  }
  return best.value_or(without);
}

/// Each of the walls that stick does its part of the way to the mean of their velocities.
template <int D>
Point<D> stick(Touches<D> const& touches, Point<D> const& v, std::span<Point<D>> changes) {
  Point<D> sum = Point<D>::Zero();
  double count = 0;
  for (std::size_t k = 0; k < touches.count; ++k)
    if (touches.sorted[k].rule.sticks) {
      sum += touches.sorted[k].wall_velocity;
      ++count;
    }
  for (std::size_t k = 0; k < touches.count; ++k)
    changes[touches.listed[k]] = touches.sorted[k].rule.sticks ? Point<D>((touches.sorted[k].wall_velocity - v) / count)
                                                               : Point<D>(Point<D>::Zero());
  return sum / count;
}

}  // namespace

template <int D>
Point<D> resolve_together(std::span<Touch<D> const> listed, Point<D> const& v, std::span<Point<D>> changes) {
  Touches<D> const touches(listed);
  bool sticks = false, rubs = false;
  for (Touch<D> const& touch : listed) {
    sticks = sticks || touch.rule.sticks;
    rubs = rubs || touch.friction > 0;
  }
  if (sticks) return stick(touches, v, changes);
  Answer<D> answer(v);
  answer.velocity = project(touches.constraints(), v, answer.pushes);
  if (rubs) answer = with_friction(touches, v, answer);
  for (std::size_t k = 0, end = 0; k < touches.count; k = end) {
    Point<D> sum = Point<D>::Zero();
    for (end = k; end < touches.count && touches.same(k, end); ++end)
      sum += answer.pushes[end] * touches.sorted[end].normal + answer.drags[end];
    for (std::size_t same = k; same < end; ++same) changes[touches.listed[same]] = sum / static_cast<double>(end - k);
  }
  return answer.velocity;
}

template Point<2> resolve_together<2>(std::span<Touch<2> const>, Point<2> const&, std::span<Point<2>>);
template Point<3> resolve_together<3>(std::span<Touch<3> const>, Point<3> const&, std::span<Point<3>>);

}  // namespace talus
