/// Where steady flow begins and ends: below mu_1 a column comes to rest, above mu_2 it speeds up without end, between
/// them, close to either, it keeps its steady speed.
///
/// Moving columns are compared with the method of lines; what is slower than mu_1 lets it be has stopped, whatever mu(I),
/// by
///
///   t = U/(g cos(slope) (mu_1 - tan(slope)))                                                                     (1)
///
/// and the excess of a slope beyond mu_2 is what acceleration tends to:  a = g cos(slope) (tan(slope) - mu_2).    (2)

#include <fmt/format.h>

#include <cmath>

#include "verification/reference/flow/motion.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/settled_column.hpp"

namespace talus::verification {

namespace {

using namespace reference::flow;

double pull(CompressibleLayer const& layer, double mu) {
  return gravity * std::cos(layer.slope) * (std::tan(layer.slope) - mu);
}

void stops(Findings& findings, double slope) {
  constexpr double U = 0.3;
  auto const layer = bead_layer(slope);
  SettledColumn const column{layer, [](double Y) { return U * Y / FlowColumn::height; }};
  double const end = -U / pull(layer.layer, layer.layer.fluid.friction.mu_1);
  Cost cost;
  auto const flows = profiles_of(column, evenly(0.1 * end, end + 0.5, 40), cost);
  std::string const name = fmt::format("{} deg, below atan mu_1 = 20.9 deg", slope);
  findings.check(name, "|surface speed| half a second after (1), over the initial one",
                 std::abs(flows.back().surface()) / U, at_most(1e-3), "at rest", cost);
}

void speeds_up(Findings& findings, double slope) {
  auto layer = bead_layer(slope);
  layer.layer.fluid = glass_beads(32.76, 0);
  auto const start = [](double Y) { return 60 * Y; };
  std::vector<double> const times{0.5, 1, 1.5, 2};
  reference::flow::Motion const motion{layer.layer.fluid,
                                       layer.layer.slope,
                                       FlowColumn::height,
                                       reference::flow::Motion::Volume::critical,
                                       start,
                                       false};
  auto const exact = extrapolated_motion(motion, 100, times, 1e-9);
  Cost cost;
  auto const flows = profiles_of(SettledColumn{layer, start}, times, cost);
  std::string const name = fmt::format("{} deg, beyond atan mu_2 = 32.76 deg", slope);
  Plot plot{"Column on " + name + ": u over y", "y [m]", "u [m/s]"};
  for (std::size_t k = 0; k < times.size(); ++k) {
    findings.check(name, fmt::format("error of the profile at {} s", times[k]),
                   profile_error(flows[k], exact.at[k].y, exact.at[k].u), at_most(0.02),
                   "2 %; method of lines by CVODE, extrapolated", k == 0 ? cost : Cost{});
    plot.curves.push_back({fmt::format("{} s", times[k]), flows[k].y, flows[k].u});
    plot.curves.push_back({fmt::format("exact, {} s", times[k]), exact.at[k].y, exact.at[k].u, true});
  }
  double const gained = (flows[3].surface() - flows[2].surface()) / 0.5;
  findings.check(name, "acceleration of the surface over (2), from 1.5 to 2 s",
                 gained / pull(layer.layer, layer.layer.fluid.friction.mu_2), at_least(1),
                 "tends to 1 from above: mu < mu_2");
  findings.plots.push_back(plot);
}

/// Steady between the two limits.
void stays(Findings& findings, double slope) {
  auto layer = bead_layer(slope);
  layer.layer.fluid = glass_beads(32.76, 0);
  SteadyLayer const exact(layer);
  Cost cost;
  FlowProfile const flow = mean_of(profiles_of(steady_column(layer, exact), evenly(2, 3, 20), cost));
  std::string const name = fmt::format("{} deg, between", slope);
  findings.check(name, "error of the profile", profile_error(flow, exact.y, exact.u), at_most(0.02), "2 % at h/20",
                 cost);
  findings.check(name, "mean friction over tan(slope)", flow.friction() / tangent(slope), about(1, 0.005), "0.5 %");
}

void run(Findings& findings) {
  for (double const slope : {19.0, 20.0, 20.8}) stops(findings, slope);
  for (double const slope : {22.0, 24.0, 28.0, 31.0}) stays(findings, slope);
  for (double const slope : {34.0, 37.0}) speeds_up(findings, slope);
}

}  // namespace

Case const flow_column_limits{"flow/column_limits",
                              "Steady flow exists between mu_1 and mu_2",
                              "compressible layer; method of lines by CVODE; the balance of forces",
                              "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figure 6",
                              2,
                              600,
                              run};

}  // namespace talus::verification
