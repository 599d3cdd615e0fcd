/// Where steady flow begins and ends: below mu_1 a column comes to rest, above mu_2 it speeds up without end, between
/// them it keeps its steady speed, or comes to it; the closer to mu_2, the more slowly.
///
/// On a slope below mu_1, friction of mu_1 alone would stop a surface speed U at (1); mu(I) stops it earlier:
///
///   t = U/(g cos(slope) (mu_1 - tan(slope)))                                                                     (1)
///
/// Moving columns are compared with the method of lines.

#include <fmt/format.h>

#include <cmath>

#include "verification/reference/flow/fluid.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/settled_column.hpp"

namespace talus::verification::flow_column_limits {

namespace {

using namespace reference::flow;

constexpr double limiting_angle = 32.76;

void stops(Findings& findings, double slope) {
  constexpr double U = 0.3;
  auto const layer = bead_layer(slope);
  SettledColumn const column{layer, [](double Y) { return U * Y / FlowColumn::height; }};
  double const end =
      U / (gravity * std::cos(layer.layer.slope) * (layer.layer.fluid.friction.mu_1 - std::tan(layer.layer.slope)));
  std::string const name = fmt::format("{} deg, below atan mu_1 = 20.9 deg", slope);
  (void)check_motion(findings, name, column, {0.1, 0.2}, 0.03);
  Cost cost;
  auto const flows = profiles_of(column, {end + 0.5}, cost);
  findings.check(name, "|surface speed| half a second after (1), over the initial one",
                 std::abs(flows.back().surface()) / U, at_most(1e-3), "at rest", cost);
}

/// From a linear profile of 3 m/s.
void moves(Findings& findings, double slope) {
  auto const layer = bead_layer(slope, 0, 0, limiting_angle);
  std::string const name = fmt::format("{} deg of at most 32.76 deg, from 3 m/s", slope);
  Moved const moved = check_motion(findings, name, {layer, [](double Y) { return 60 * Y; }}, {0.5, 1, 1.5, 2}, 0.02);
  double const gained = moved.found[3].surface() - moved.found[2].surface(),
               exact = moved.exact[3].u.back() - moved.exact[2].u.back();
  findings.check(name, "gain of the surface speed from 1.5 to 2 s over the exact one", gained / exact, about(1, 0.05),
                 fmt::format("5 %; exact: {:.3f} m/s", exact));
}

/// Steady between the two limits, where that takes about a second.
void stays(Findings& findings, double slope) {
  auto const layer = bead_layer(slope, 0, 0, limiting_angle);
  SteadyLayer const exact(layer);
  Cost cost;
  FlowProfile const flow = mean_of(profiles_of(steady_column(layer, exact), evenly(2, 3, 20), cost));
  std::string const name = fmt::format("{} deg of at most 32.76 deg, steady", slope);
  compare_with_layer(findings, name, flow, exact, 0.02, "2 % at h/20", cost);
  findings.check(name, "mean friction over tan(slope)", flow.friction() / tangent(slope), about(1, 0.002), "0.2 %");
}

void run(Findings& findings) {
  for (double const slope : {19.0, 20.0, 20.8}) stops(findings, slope);
  for (double const slope : {22.0, 24.0}) stays(findings, slope);
  for (double const slope : {28.0, 31.0, 34.0, 37.0}) moves(findings, slope);
}

}  // namespace

Case const the_case{"flow/column_limits",
                    "Steady flow exists between mu_1 and mu_2",
                    "compressible layer; method of lines by CVODE",
                    "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figure 6",
                    2,
                    600,
                    run};

}  // namespace talus::verification::flow_column_limits
