#pragma once
/// Particles that a body force drives along a motion which is known, and how far they are from it in the end.

#include <functional>
#include <utility>
#include <vector>

#include "verification/exact/elastic.hpp"
#include "verification/manufactured/balance.hpp"
#include "verification/suite/setup.hpp"

namespace talus::manufactured {

using verification::Cost;
using verification::Scheme;

/// A motion of an elastic solid, and the body force of which it is the answer: by the particle's first place and time.
template <int D>
struct Solution {
  exact::Elastic solid;
  std::function<MovedPoint<D>(Point<D> const& X, double t)> at;
  std::function<Point<D>(Point<D> const& X, double t)> force;  ///< [m/s^2]
};

/// With the closed form of the body force: a solver whose law is wrong misses the motion.
template <MotionOfPoints M>
Solution<M::dimension> solution_of(M const& motion, exact::Elastic const& solid) {
  return {solid, [motion](auto const& X, double t) { return moved(motion, X, t); },
          [motion, solid](auto const& X, double t) { return motion.body_force(solid, X, t); }};
}

/// The same in a frame in which everything moves with velocity V as well: the force is the same.
template <int D>
Solution<D> carried(Solution<D> const& solution, Point<D> const& V) {
  return {solution.solid,
          [at = solution.at, V](Point<D> const& X, double t) {
            MovedPoint<D> point = at(X, t);
            point.x += t * V;
            point.v += V;
            return point;
          },
          solution.force};
}

/// Grid, steps and particles that a solution is sought with.
template <int D>
struct Discretisation {
  Scheme scheme;
  double h = 0, dt = 0;  ///< [m], [s]
  long steps = 0;
  BlockIndex<D> periods = {};
  std::vector<Point<D>> places = {};  ///< X_p: where the undeformed particles are [m]
  double volume = 0;                  ///< of each particle, undeformed [m^D]
  /// By how many steps the velocity lags behind the place: half a step in a symplectic scheme that is of second order.
  double lag = 0.5;
  std::function<void(Scene<D>&)> adds = {};                   ///< walls
  std::function<void(Simulation<D> const&)> after_each = {};  ///< step

  [[nodiscard]] double end() const { return double(steps) * dt; }
};

/// The particles by number at the end: displacement from X_p, velocity, elastic strain.
template <int D>
struct Driven {
  std::vector<Point<D>> u, v;
  std::vector<Symmetric<double, ShapeOf<D>>> strain;
  Cost cost;
};

/// Starts on the solution at t = 0, the velocity and its gradient `lag` steps before, and takes the steps.
template <int D>
[[nodiscard]] Driven<D> drive(Solution<D> const& solution, Discretisation<D> const& with);

/// Root mean squares over the particles, of equal volume: displacement [m], velocity [m/s], elastic strain [1], and
/// Kirchhoff stress [Pa], each the norm of a vector or tensor.
struct Errors {
  double u = 0, v = 0, strain = 0, stress = 0;
  Cost cost;
};

/// Distance of the particles from the solution, over those whose X_p is `among`; all where that is empty.
template <int D>
[[nodiscard]] Errors errors_of(Driven<D> const& driven, Solution<D> const& solution, Discretisation<D> const& with,
                               std::function<bool(Point<D> const&)> const& among = {});

}  // namespace talus::manufactured
