/// An elastic disc rolls down a slope, or slips where the friction is too small:
///
///   tan theta <= 3 mu:   a = 2/3 g sin theta,                      omega R = v                          (1)
///   else:                a = g (sin theta - mu cos theta)                                               (2)
///
/// A wall acts on all that a kernel ties to the nodes within it, some 1.5 h high. So the disc rolls on a radius that is
/// larger than R by up to 1.5 h: by (1) with R' for the lever of friction, a = g sin theta/(1 + R^2/(2 R'^2)), its
/// acceleration is uncertain by h/R. And it is held over a length b = sqrt(3 R h) to either side of the point of
/// contact, pushed ahead of it and not pulled behind: a resistance to rolling, which keeps a disc with tan theta < b/R
/// from turning at all. Asked for is h/R on slopes of tan theta > b/R; this is what a wall of nodes can do, and no
/// more.
///
/// Source: rigid-body mechanics; derived here.

#include <cmath>

#include "models/boundaries/contacts/coulomb.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/boundaries/motions/fixed.hpp"
#include "models/boundaries/shapes/half_space.hpp"
#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/laws/hencky.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/disc.hpp"
#include "verification/suite/sliding_box.hpp"

namespace talus::verification::friction_rolling_disc {

namespace {

constexpr double radius = 0.1, g = 9.81, angle = 30 * degree, begun = 0.2, ended = 0.8;

void roll(Findings& findings, Plot& plot, Scheme const& scheme, int cells, double friction) {
  Scene<2> scene = scene_of<kinematics::PlaneStrainReduced, law::Hencky>(scheme, radius / cells, 1000, {1e5, 0.3});
  scene.walls.push_back(
      make_wall<2, wall::HalfSpace, wall::Coulomb, wall::Fixed>("plane", {{0, 0}, {0, 1}}, {friction}, {}));
  scene.gravity = {g * std::sin(angle), -g * std::cos(angle)};
  scene.limits.safety = 0.8;
  set_step(scene, elastic_step(scene));
  auto const simulation = begin(std::move(scene), disc({0, radius}, radius, radius / cells / 2, 1000));
  double const dt = simulation->next(1).dt;
  auto const until = [&](double t, Cost& cost) {
    take_steps(*simulation, std::lround((t - simulation->time()) / dt), cost);
    return rigid_motion(*simulation);
  };
  bool const rolls = std::tan(angle) <= 3 * friction;
  double const exact = rolls ? 2.0 / 3 * g * std::sin(angle) : g * (std::sin(angle) - friction * std::cos(angle));
  Cost cost;
  RigidMotion const first = until(begun, cost);
  double const from = simulation->time();
  Curve curve{(rolls ? "rolls, R/h = " : "slips, R/h = ") + std::to_string(cells)};
  RigidMotion last;
  for (int k = 1; k <= 12; ++k) {
    last = until(begun + k * (ended - begun) / 12, cost);
    curve.x.push_back(simulation->time());
    curve.y.push_back((last.velocity[0] - first.velocity[0]) / (simulation->time() - from) / exact);
  }
  std::string const subject = scheme.name() + ", " + curve.name;
  findings.check(subject, "|a/a_exact - 1|", std::abs(curve.y.back() - 1), at_most(1.0 / cells),
                 "h/R, the reach of a wall", cost);
  findings.note(subject, "-omega R/v", -last.spin * radius / last.velocity[0],
                rolls ? "1 for a rigid disc that rolls" : "2 mu g cos theta/a for a rigid disc");
  findings.note(subject, "rise over h", (last.centre[1] - radius) / radius * cells);
  plot.curves.push_back(curve);
}

void run(Findings& findings) {
  Plot plot{"Disc on a slope of 30 degrees: mean acceleration since 0.2 s", "t [s]", "a/a_exact [1]"};
  for (int const cells : {20, 40})
    for (double const friction : {std::tan(15 * degree), 0.1})
      roll(findings, plot, {"quadratic", "apic"}, cells, friction);
  roll(findings, plot, {"quadratic", "aflip"}, 20, std::tan(15 * degree));
  findings.plots.push_back(plot);
}

}  // namespace

Case const the_case{"friction/rolling_disc",
                    "A disc rolls down a slope, or slips",
                    "the motion of a rigid disc",
                    "derived in the case's file",
                    2,
                    300,
                    run};

}  // namespace talus::verification::friction_rolling_disc
