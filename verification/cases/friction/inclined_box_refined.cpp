/// The box of friction/inclined_box on five grids, with two and three particles to a cell along an axis.
///
/// While the box is slow, nodes that a particle has just reached, of next to no mass, are thrown about by the stress
/// and stick: the friction is less than mu N until the box is faster than that. The velocity so gained counts most
/// where the acceleration is least, at 16 degrees. It falls with the spacing and with more particles, by no fixed
/// order. Asked of are boxes of eight cells and more; those of four and six are two and three cells high, and a kernel
/// reaches three.

#include <cmath>

#include "verification/suite/cases.hpp"
#include "verification/suite/sliding_box.hpp"

namespace talus::verification::friction_inclined_box_refined {

namespace {

constexpr double end = 5;

void refines(Findings& findings, Plot& plot, double slope, int per_axis) {
  std::string const name = std::to_string(slope).substr(0, 5) + " deg, " + std::to_string(per_axis) + " to a cell";
  Curve curve{name};
  for (int const cells : {4, 6, 8, 16, 24}) {
    SlidingBox box{.angle = slope * degree, .lean = slope * degree, .per_axis = per_axis};
    box.spacing = box.length / cells;
    Slid const slid = slide(box, settled_sliding(box), end);
    double const off = std::abs(slid.along / (box.acceleration() * slid.half_square()) - 1);
    std::string const subject = "quadratic, apic, " + name + ", " + std::to_string(cells) + " cells",
                      measure = "|x/x_exact - 1| at 5 s";
    if (cells < 8)
      findings.note(subject, measure, off, "the box is no higher than a kernel reaches", slid.cost);
    else
      findings.check(subject, measure, off, at_most(1e-3), "1e-3, what the reference solver asks of an aligned plane",
                     slid.cost);
    findings.work.push_back(
        {"inclined box", "way at 5 s", "quadratic", "apic", per_axis, double(cells), off, slid.cost});
    curve.x.push_back(box.spacing);
    curve.y.push_back(off);
  }
  plot.curves.push_back(curve);
}

void run(Findings& findings) {
  Plot plot{"Box on an inclined plane: error over the spacing", "h [m]", "|x/x_exact - 1| at 5 s [1]", true, true};
  for (int const per_axis : {2, 3})
    for (double const slope : {16.0, 35.264389682754654, 45.0}) refines(findings, plot, slope, per_axis);
  findings.plots.push_back(plot);
}

}  // namespace

Case const the_case{"friction/inclined_box_refined",
                    "An elastic box slides down planes that cut through grids of five spacings",
                    "the discrete motion under Coulomb friction",
                    "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figure of the sliding box",
                    2,
                    900,
                    run};

}  // namespace talus::verification::friction_inclined_box_refined
