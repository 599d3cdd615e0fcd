#pragma once
/// The time step and what limits it.
///
///   elastic   dt <= safety h sqrt(2/q) / c,   c^2 = max(D lambda, 0)/rho + 2 G/rho     (1)
///   crossing  dt <= crossing h / max |v_p|                                             (2)
///   gradient  dt <= gradient / max |L_p|                                               (3)
///
/// (1) is the bound of an isolated particle, which governs free surfaces and spray. Such a particle of mass m and volume
/// V gives its nodes the masses m N_i and the forces -V tau grad N_i. As sum_i grad N_i = 0, its velocity stays; what a
/// step adds to its velocity gradient is
///
///   -dt V/m tau sum_i grad N_i grad N_i^T / N_i = -dt q/(rho h^2) tau,   q = h^2 sum_i N'_i^2 / N_i            (4)
///
/// along each axis alike, for the slopes of different axes have no common moment. Let a strain eps answer with the
/// stress M eps; k = dt^2 q M/(rho h^2).
///
///   Constant mode: the nodes forget that gradient.    eps' = (1 - k) eps                   |1 - k| <= 1: k <= 2   (5)
///   Affine mode: sum_i grad N_i (x_i - x_p)^T = I hands C_p the share h^2/D_p/q of it.
///       C' = C - dt M/(rho D_p) eps,   eps' = eps + dt C - k eps                                                (6)
///       trace 2 - k, determinant 1 - k (1 - h^2/(D_p q)): the eigenvalue -1 comes first, at
///       k (1 - h^2/(2 D_p q)) = 2                                                                                 (7)
///
/// (1) is (5) with q at the worst place in a cell, and (7) with q - h^2/(2 D_p) for q. The stiffest M in D dimensions is
/// D lambda + 2 G, of a change of volume, or 2 G where lambda < 0. Neighbours raise the bound. In the constant mode that
/// follows from the lumped masses: sum_p V M |grad v|_p^2 over sum_p m sum_i N_i v_i^2 is at most its largest value for
/// one particle. In the affine mode it is no proof but was tried on clouds of particles, by eigenvalues. A particle moved
/// back to the nodes before the gradient is taken (MUSL) bears longer steps. Where a kernel has a least mass of a node, the
/// axes are coupled and (1) is 2 % too long in two dimensions; `safety` covers that.
///
/// The stress is elastic at worst: plastic and viscous laws are solved at the end of the step and answer more softly.
/// (1) is linear: a strain so large that it stiffens the law (neo-Hookean stretch) takes from the margin of `safety`.
/// The step is only ever made shorter, so that it lands on the end.
///
/// Derived here.

#include <string_view>

#include "core/scene.hpp"

namespace talus {

/// A step [s] and the limit that set it.
struct TimeStep {
  double dt = 0;
  std::string_view limiter = "elastic";
};

/// The material whose step is the shortest by (1), and c [m/s].
template <int D>
struct Stiffest {
  Material<D> const* material = nullptr;
  double speed = 0;
};
template <int D>
Stiffest<D> stiffest(Scene<D> const& scene) {
  Stiffest<D> found;
  for (auto const& m : scene.materials)
    if (double const speed = std::sqrt(m->stiffest_modulus() / m->density); speed > found.speed)
      found = {m.get(), speed};
  return found;
}

/// The bound (1), over all materials. [s]
template <int D>
double elastic_step(Scene<D> const& scene) {
  return scene.limits.safety * scene.spacing * std::sqrt(2.0 / scene.stages->sharpness) / stiffest(scene).speed;
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
