/// A box is pushed up a slope, stops, and stays or comes back.
///
///   up:    v' = -a_u,  a_u = g (sin theta + mu cos theta),  stops after v_0^2/(2 a_u)
///   down:  v' = -a_d,  a_d = g (sin theta - mu cos theta),  if tan theta > mu
///
/// Symplectic Euler with v_0 = n a_u dt stops at step n, after a_u dt^2 n (n - 1)/2 = v_0^2/(2 a_u) (1 - 1/n), and from
/// there slides back with a_d. The box starts with the strain of a box that slides up steadily. As it stops, its
/// friction turns from -mu N to mu N, which takes an elastic box the time of a shear wave through its height, 2 H/c_s:
/// so it begins to slide with a velocity that is off by up to 4 mu g cos theta H/c_s, and keeps that. The way back is
/// off by that times t, not a matter of the scheme; what is asked of the way back is its acceleration.
///
/// Source: Coulomb's law; derived here.

#include <cmath>

#include "verification/suite/cases.hpp"
#include "verification/suite/sliding_box.hpp"

namespace talus::verification::friction_upslope {

namespace {

constexpr double speed = 3;  ///< [m/s], about

/// What a box does that starts upslope.
struct Climb {
  double farthest = 0, exact = 0;  ///< [m]
  double acceleration = 0;         ///< from 0.2 s after the stop to the end [m/s^2]
  double lead = 0;                 ///< velocity at the end less that of a rigid box [m/s]
  double last_slip = 0;            ///< way in the last tenth of a second [m]
  Cost cost = {};
};

Climb climb(SlidingBox const& box, double rest) {
  double const up = box.gravity * (std::sin(box.angle) + box.friction * std::cos(box.angle));
  double const dt = elastic_step(scene_of_box(box, box.pull()));
  double const n = std::round(speed / (up * dt));
  auto seeds = settled_sliding(box, true);
  for (auto& seed : seeds) seed.v = -n * up * dt * box.down();
  Climb climb;
  double const stop = n * dt, tail = stop + rest - 0.1;
  double at_tail = 0, early = 0, early_time = 0, late = 0, late_time = 0;
  Slid const slid = slide(box, seeds, stop + rest, [&](Simulation<2> const& simulation) {
    bool const near_the_top = std::abs(simulation.time() - stop) < 0.02;
    if (near_the_top) climb.farthest = std::max(climb.farthest, -mean_way(simulation, seeds, box.down()));
    if (early_time == 0 && simulation.time() >= stop + 0.2) {
      early = mean_velocity(simulation, box.down());
      early_time = simulation.time();
    }
    if (late_time == 0 && simulation.time() >= tail) {
      at_tail = mean_way(simulation, seeds, box.down());
      late = mean_velocity(simulation, box.down());
      late_time = simulation.time();
    }
  });
  climb.exact = 0.5 * up * dt * dt * n * (n - 1);
  climb.acceleration = (late - early) / (late_time - early_time);
  climb.lead = late - box.acceleration() * (late_time - stop);
  climb.last_slip = slid.along - at_tail;
  climb.cost = slid.cost;
  return climb;
}

void run(Findings& findings) {
  for (Scheme const& scheme :
       {Scheme{"quadratic", "apic"}, Scheme{"quadratic", "aflip"}, Scheme{"quadratic", "flip", "usl", 0.95}})
    for (double const slope : {5.0, 10.0, 14.0, 16.0, 20.0, 30.0}) {
      SlidingBox const box{.scheme = scheme, .angle = slope * degree, .young = 1e7};
      Climb const found = climb(box, 1);
      std::string const subject = scheme.name() + ", " + std::to_string(int(slope)) + " deg";
      findings.check(subject, "|x_stop/x_exact - 1|", std::abs(found.farthest / found.exact - 1), at_most(1e-4),
                     "the bar of the sliding box", found.cost);
      if (slope > 15) {
        double const wave = std::sqrt(0.5 * box.young / box.density);
        findings.check(subject, "|a/a_exact - 1| on the way back",
                       std::abs(found.acceleration / box.acceleration() - 1), at_most(1e-4),
                       "the bar of the sliding box");
        findings.check(
            subject, "|v - v_rigid| c_s/(4 mu g cos theta H)",
            std::abs(found.lead) * wave / (4 * box.friction * box.gravity * std::cos(box.angle) * box.height),
            at_most(1), "the shear of the base turns within the time of a wave");
      } else {
        findings.check(subject, "way in the last tenth of a second over the length",
                       std::abs(found.last_slip) / box.length, at_most(1e-6), "it stays: a millionth of the box");
      }
    }
}

}  // namespace

Case const the_case{"friction/upslope",
                    "A box is pushed up a slope, stops, and slides back where tan theta > mu",
                    "the discrete motion under Coulomb friction",
                    "derived in the case's file",
                    1,
                    120,
                    run};

}  // namespace talus::verification::friction_upslope
