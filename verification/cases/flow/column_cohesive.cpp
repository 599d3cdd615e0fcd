/// The periodic column on 32 degrees with cohesion: slower with beta, at rest beyond beta*, and with a plug where the
/// surface keeps a strength from before.
///
/// At critical state up to the surface, the profile is Bagnold's with omega = (1 + beta)/(1 - beta) but for the change of
/// volume; it ends at beta* = (tan(slope) - mu_1)/(tan(slope) + mu_1). Strength is a state: where it has been p_c, and
/// mu_1 S is not exceeded, nothing shears, and it stays p_c. Above that lies a plug.
///
/// Source: Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figure 16; verification/reference/flow/plugged_layer.hpp.

#include <fmt/format.h>

#include <cmath>

#include "verification/reference/flow/layer.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/settled_column.hpp"

namespace talus::verification {

namespace {

using namespace reference::flow;

constexpr double slope = 32;

/// Begun in steady flow with that kept strength [Pa].
FlowProfile flows(Findings& findings, double beta, double kept, int cells) {
  auto const layer = bead_layer(slope, beta, kept);
  SteadyLayer const exact(layer);
  Cost cost;
  FlowProfile const flow = mean_of(profiles_of(steady_column(layer, exact, cells), evenly(2, 3, 20), cost));
  std::string const name = fmt::format("beta = {}, {} Pa kept, h/{}", beta, kept, cells);
  findings.check(name, "|error of the surface speed|", std::abs(flow.surface() / exact.surface - 1), at_most(0.02),
                 "2 %", cost);
  findings.check(name, "error of the profile", profile_error(flow, exact.y, exact.u), at_most(0.02), "2 %");
  if (kept > 0) findings.note(name, "exact depth of the plug over h_0", 1 - layer.plug_begin() / layer.layer.h_0);
  return flow;
}

void with_plug(Findings& findings, double kept, int cells) {
  Plot plot{fmt::format("Cohesive column on 32 degrees, {} Pa kept: u over y", kept), "y [m]", "u [m/s]"};
  for (double const beta : {0.05, 0.1, 0.2}) {
    FlowProfile const flow = flows(findings, beta, kept, cells);
    SteadyLayer const exact(bead_layer(slope, beta, kept));
    plot.curves.push_back({fmt::format("beta = {}", beta), flow.y, flow.u});
    plot.curves.push_back({fmt::format("beta = {}, exact", beta), exact.y, exact.u, true});
  }
  findings.plots.push_back(plot);
}

/// From a linear profile towards rest or flow on either side of beta*.
void stops(Findings& findings, double beta, bool at_rest) {
  constexpr double U = 0.5;
  auto const layer = bead_layer(slope, beta);
  Cost cost;
  auto const column = SettledColumn{layer, [](double Y) { return U * Y / FlowColumn::height; }};
  double const surface = profiles_of(column, {3.0}, cost).back().surface();
  double const least = largest_cohesion(layer.layer.slope, layer.layer.fluid.friction.mu_1);
  findings.check(fmt::format("beta = {}, beta* = {:.4f}", beta, least), "surface speed after 3 s over the initial one",
                 surface / U, at_rest ? at_most(1e-3) : at_least(0.02), at_rest ? "at rest" : "flows", cost);
}

void run(Findings& findings) {
  with_plug(findings, 0, 20);
  with_plug(findings, 100, 20);
  with_plug(findings, 400, 40);  // the plug ends within a cell
  stops(findings, 0.275, true);
  stops(findings, 0.26, true);
  stops(findings, 0.22, false);
}

}  // namespace

Case const flow_column_cohesive{"flow/column_cohesive",
                                "A cohesive column on a slope of 32 degrees",
                                "compressible layer with and without a plug, by quadrature",
                                "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figure 16",
                                2,
                                900,
                                run};

}  // namespace talus::verification
