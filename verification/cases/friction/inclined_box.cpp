/// The sliding box on a plane that is not aligned with the grid: gravity is vertical, a half-space leans by theta.
///
///   a = g (sin theta - mu cos theta),   x_n = a t_n (t_n + dt)/2,   mu = tan 15 degrees                 (1)
///
/// The walls act on nodes, and the nodes inside of the plane change as the box passes them. The box begins at rest with
/// the strain of steady sliding, as in friction/sliding_box, but that strain belongs to the place on the grid in which
/// it was found: under way the box sinks by a part of a cell (y < 0: x grows by mu |y|), the load on a node is not
/// constant, and nodes that a particle has just reached stick. So (1) holds to the grid's noise and not to rounding.
///
/// Source: the figure of the sliding box in Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643.

#include <cmath>

#include "verification/suite/cases.hpp"
#include "verification/suite/sliding_box.hpp"

namespace talus::verification::friction_inclined_box {

namespace {

constexpr double end = 5;
constexpr char const* bar = "1e-3, what the reference solver asks of an aligned plane";

/// tan theta is no ratio of small numbers at any of them but 45 degrees, and 1/sqrt(2) at the last but one.
std::vector<double> const slopes{16, 23, 30, 35.264389682754654, 45};

void slides(Findings& findings, Plot& plot, Scheme const& scheme) {
  Curve curve{scheme.name()};
  for (double const slope : slopes) {
    SlidingBox const box{.scheme = scheme, .angle = slope * degree, .lean = slope * degree};
    Slid const slid = slide(box, settled_sliding(box), end);
    double const exact = box.acceleration() * slid.half_square(), off = std::abs(slid.along / exact - 1);
    std::string subject = scheme.name() + ", " + std::to_string(slope).substr(0, 5) + " deg";
    findings.check(subject, "|x/x_exact - 1| at 5 s", off, at_most(1e-3), bar, slid.cost);
    findings.check(subject, "largest T/(mu N) - 1 of a step", slid.excess, at_most(1e-10),
                   "Coulomb's law is never exceeded");
    findings.note(subject, "mean shortfall of T below mu N over the mean mu N", slid.short_by);
    findings.note(subject, "rise y over h", slid.away / box.spacing);
    curve.x.push_back(slope);
    curve.y.push_back(off);
  }
  plot.curves.push_back(curve);
}

void sticks(Findings& findings, Scheme const& scheme) {
  SlidingBox const box{.scheme = scheme, .angle = 14 * degree, .lean = 14 * degree};
  Slid const slid = slide(box, settled_sticking(box), end);
  findings.check(scheme.name() + ", 14 deg", "net slip of the base at 5 s over the length", slid.base_slip / box.length,
                 at_most(1e-6), "it stays: a millionth of the box", slid.cost);
}

void run(Findings& findings) {
  Plot plot{"Box on an inclined plane: error over the slope", "slope [deg]", "|x/x_exact - 1| at 5 s [1]", false, true};
  for (Scheme const& scheme : {Scheme{"quadratic", "apic"}, Scheme{"quadratic", "aflip"},
                               Scheme{"quadratic", "flip", "usl", 0.95}, Scheme{"quadratic", "pic"}}) {
    slides(findings, plot, scheme);
    sticks(findings, scheme);
  }
  findings.plots.push_back(plot);
}

}  // namespace

Case const the_case{"friction/inclined_box",
                    "An elastic box slides down planes that cut through the grid",
                    "the discrete motion under Coulomb friction",
                    "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figure of the sliding box",
                    1,
                    180,
                    run};

}  // namespace talus::verification::friction_inclined_box
