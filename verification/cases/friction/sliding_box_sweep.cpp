/// The sliding box of friction/sliding_box at 16 degrees, the slope at which its way is the shortest, over stiffness,
/// grid, kernel and transfer.
///
///   x_n = a t_n (t_n + dt)/2,   a = g (sin theta - mu cos theta),   mu = tan 15 degrees                 (1)
///
/// Every kernel and transfer on four grids at E = 1e6; then E from 1e5 to 1e9 on the coarsest of them. A particle of
/// the softest box crosses too much of a cell in a stable step: its step is half as long.
///
/// Source: the figure of the sliding box in Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643.

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "core/errors.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/sliding_box.hpp"
#include "verification/suite/work_precision.hpp"

namespace talus::verification::friction_sliding_box_sweep {

namespace {

constexpr double end = 5;
constexpr char const* bar = "1e-4, a tenth of what the reference solver asks of itself";

/// The error of (1). A run that has to shorten its step, for it tears itself apart, has none.
double measure(Findings& findings, SlidingBox const& box, bool asked, std::string why) {
  double const cells = std::round(box.length / box.spacing);
  std::string const subject = fmt::format("{}, {} cells, E = {:.0e} Pa", box.scheme.name(), cells, box.young),
                    what = "|x/x_exact - 1| at 5 s";
  Slid slid;
  double off = std::numeric_limits<double>::quiet_NaN();
  try {
    slid = slide(box, settled_sliding(box), end);
    off = std::abs(slid.along / (box.acceleration() * slid.half_square()) - 1);
    findings.work.push_back(
        {"sliding box", "way at 5 s", box.scheme.kernel, box.scheme.transfer, box.per_axis, cells, off, slid.cost});
  } catch (RunError const& error) {
    why += std::string("; stopped: ") + error.what();
  }
  if (asked)
    findings.check(subject, what, off, at_most(1e-4), why, slid.cost);
  else
    findings.note(subject, what, off, why, slid.cost);
  return off;
}

void over_grids(Findings& findings, Plot& plot) {
  for (Scheme const& scheme : all_schemes()) {
    Curve curve{scheme.name()};
    for (int const cells : {4, 8, 12, 16}) {
      SlidingBox box{.scheme = scheme, .angle = 16 * degree};
      box.spacing = box.length / cells;
      bool const linear = scheme.degree() == 1;
      curve.x.push_back(box.spacing);
      curve.y.push_back(measure(findings, box, !linear,
                                linear ? "the gradient of the linear kernel jumps as particles cross cells" : bar));
    }
    plot.curves.push_back(curve);
  }
}

void over_stiffness(Findings& findings, Plot& plot, Scheme const& scheme) {
  Curve curve{scheme.name()};
  for (double const young : {1e5, 1e6, 1e7, 1e8, 1e9}) {
    SlidingBox box{.scheme = scheme, .angle = 16 * degree, .young = young};
    bool const soft = young < 1e6;
    if (soft) box.step = 0.4;
    curve.x.push_back(young);
    curve.y.push_back(measure(findings, box, !soft, soft ? "softer than what the bar is set for: E >= 1e6 Pa" : bar));
  }
  plot.curves.push_back(curve);
}

void run(Findings& findings) {
  Plot grids{"Sliding box: error over the spacing", "h [m]", "|x/x_exact - 1| at 5 s [1]", true, true};
  Plot stiffness{"Sliding box: error over the stiffness", "E [Pa]", "|x/x_exact - 1| at 5 s [1]", true, true};
  over_grids(findings, grids);
  tell_cheapest(findings, findings.work);
  over_stiffness(findings, stiffness, {"quadratic", "apic"});
  over_stiffness(findings, stiffness, {"quadratic", "flip", "usl", 0.95});
  findings.plots.push_back(grids);
  findings.plots.push_back(stiffness);
}

}  // namespace

Case const the_case{"friction/sliding_box_sweep",
                    "The sliding box over stiffness, spacing, kernel and transfer",
                    "the discrete motion under Coulomb friction",
                    "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figure of the sliding box",
                    2,
                    900,
                    run};

}  // namespace talus::verification::friction_sliding_box_sweep
