/// A bead slides without friction down the inside of a bowl, a circle of radius R, from 60 degrees to the bottom:
///
///   v^2 = 2 g (fall of its centre)                                                                      (1)
///
/// The bead is a disc of radius r, some cells across; it does not roll, for nothing turns it. A wall acts on the nodes
/// within it, on all that a kernel ties to the bead: over a length b of about sqrt(2 r (1.5 h)) to either side of the
/// point of contact. Ahead of it the bowl rises against the motion and the nodes' normal velocity is lost; behind it
/// they leave, and the wall does not pull. The force so leans back by a part of b/R, and (1) is missed by as much:
/// order 1 in the size of a bead that keeps its number of cells. For the bead is a point only in the limit, it is
/// refined that way.
///
/// Source: conservation of energy; derived here.

#include <cmath>
#include <memory>

#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/laws/hencky.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/disc.hpp"

namespace talus::verification::friction_bead {

namespace {

constexpr double bowl_radius = 1, g = 9.81, pi = 3.14159265358979324;
constexpr int cells = 4, per_axis = 2;  ///< to the radius; to a cell

/// The material is within a circle about the origin; free slip and separation.
class Bowl final : public Wall<2> {
 public:
  Bowl() : Wall<2>("bowl", {}) {}
  int surfaces(Point<2> const& x, double t, std::span<Surface<2>> out) const override {
    out[0] = {distance(x, t), -x.normalized()};
    return 1;
  }
  [[nodiscard]] double distance(Point<2> const& x, double /*t*/) const override { return bowl_radius - x.norm(); }
  [[nodiscard]] Point<2> velocity(double /*t*/) const override { return Point<2>::Zero(); }
};

/// |v|/sqrt(2 g fall) - 1 as the bead passes the bottom.
double missed(Scheme const& scheme, double radius, Cost& cost) {
  Scene<2> scene = scene_of<kinematics::PlaneStrainReduced, law::Hencky>(scheme, radius / cells, 1000, {1e6, 0});
  scene.walls.push_back(std::make_unique<Bowl>());
  scene.gravity = {0, -g};
  scene.limits.safety = 0.8;
  set_step(scene, elastic_step(scene));
  double const q = bowl_radius - radius, from = pi / 3;
  auto const seeds = disc(q * Point<2>(-std::sin(from), -std::cos(from)), radius, radius / cells / per_axis, 1000);
  auto const simulation = begin(std::move(scene), seeds);
  RigidMotion const start = rigid_motion(*simulation);
  RigidMotion now = start;
  while (now.centre[0] < 0 && simulation->time() < 1) {
    take_steps(*simulation, 10, cost);
    now = rigid_motion(*simulation);
  }
  // the velocity is that of half a step ago
  double const half = 0.5 * simulation->last_step().dt;
  return now.velocity.norm() / std::sqrt(2 * g * (start.centre[1] - now.centre[1] + half * now.velocity[1])) - 1;
}

void refine(Findings& findings, Plot& plot, Scheme const& scheme) {
  Curve curve{scheme.name()};
  Cost cost;
  for (double const radius : {0.01, 0.005, 0.0025, 0.00125}) {
    Cost own;
    curve.x.push_back(radius / bowl_radius);
    curve.y.push_back(std::abs(missed(scheme, radius, own)));
    findings.work.push_back({"bead in a bowl", "speed at the bottom", scheme.kernel, scheme.transfer, per_axis,
                             cells * bowl_radius / radius, curve.y.back(), own});
    cost += own;
  }
  findings.check(scheme.name(), "order in r/R of |v/v_exact - 1|",
                 std::log(curve.y.front() / curve.y.back()) / std::log(curve.x.front() / curve.x.back()), {0.9, 1.2},
                 "1, the length over which the wall acts over its radius", cost);
  std::string const measure = "|v/v_exact - 1| at r = R/800";
  if (scheme.transfer == "pic" || scheme.alpha < 1)
    findings.note(scheme.name(), measure, curve.y.back(), "the transfer takes out what the wall makes spin and ring");
  else
    findings.check(scheme.name(), measure, curve.y.back(), at_most(1e-4),
                   "1e-4, the tighter of the two bars of the reference solver's own tests");
  plot.curves.push_back(curve);
}

void run(Findings& findings) {
  Plot plot{"Bead in a bowl: error over its size", "r/R [1]", "|v/v_exact - 1| [1]", true, true};
  for (Scheme const& scheme :
       {Scheme{"quadratic", "apic"}, Scheme{"quadratic", "aflip"}, Scheme{"quadratic", "flip"},
        Scheme{"quadratic", "flip", "usl", 0.95}, Scheme{"quadratic", "pic"}, Scheme{"cubic", "apic"}})
    refine(findings, plot, scheme);
  findings.plots.push_back(plot);
}

}  // namespace

Case const the_case{"friction/bead",
                    "A bead slides down a bowl without friction",
                    "conservation of energy",
                    "derived in the case's file",
                    2,
                    300,
                    run};

}  // namespace talus::verification::friction_bead
