#pragma once
/// The time step and what limits it.
///
///   elastic   dt <= safety h sqrt(2/q) / sqrt((d_s lambda + 2 G)/rho)      (1)
///   crossing  dt <= crossing h / max |v_p|                                 (2)
///   gradient  dt <= gradient / max |L_p|                                   (3)
///
/// (1) is the bound of an isolated particle, which governs free surfaces and spray: q = h^2 sum_i N'_i^2 / N_i at the
/// worst place in a cell (less h^2/(2 D_p) where the transfer is affine), volumetric mode. The step is only ever made
/// shorter, so that it lands on the end.

#include <string_view>

#include "core/scene.hpp"

namespace talus {

/// A step [s] and the limit that set it.
struct TimeStep {
  double dt = 0;
  std::string_view limiter = "elastic";
};

/// The bound (1), over all materials. [s]
template <int D>
double elastic_step(Scene<D> const& scene) {
  double speed = 0;
  for (auto const& m : scene.materials) speed = std::max(speed, std::sqrt(m->volumetric_modulus() / m->density));
  return scene.limits.safety * scene.spacing * std::sqrt(2.0 / scene.stages->sharpness) / speed;
}

/// The next step: speed [m/s] and gradient [1/s] are the largest of the step before; `left` is the time to the end.
template <int D>
TimeStep next_step(Scene<D> const& scene, double speed, double gradient, double left) {
  TimeStep step{elastic_step(scene), "elastic"};
  auto const limit = [&](double bound, std::string_view name) {
    if (bound < step.dt) step = {bound, name};
  };
  if (speed > 0) limit(scene.limits.crossing * scene.spacing / speed, "crossing");
  if (gradient > 0) limit(scene.limits.gradient / gradient, "gradient");
  limit(left, "end");
  return step;
}

}  // namespace talus
