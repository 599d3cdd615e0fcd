/// The periodic column on 32 degrees with cohesion: slower with beta, at rest beyond beta*, and with a plug where the
/// surface keeps a strength from before.
///
/// At critical state up to the surface, the profile is Bagnold's with omega = (1 + beta)/(1 - beta) but for the change of
/// volume; it ends at beta* = (tan(slope) - mu_1)/(tan(slope) + mu_1). Where q does not exceed mu_1 S of the strength that
/// the material has, nothing shears and the strength stays: a plug.
///
/// Source: Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figure 16; verification/reference/flow/plugged_layer.hpp.

#include <fmt/format.h>

#include <cmath>

#include "verification/reference/flow/layer.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/settled_column.hpp"

namespace talus::verification::flow_column_cohesive {

namespace {

using namespace reference::flow;

constexpr double slope = 32;

/// Begun in steady flow with that kept strength [Pa]; asked: the bar, or 0.
void steady(Findings& findings, Plot& plot, double beta, double kept, int cells, double asked) {
  auto const layer = bead_layer(slope, beta, kept);
  SteadyLayer const exact(layer);
  Cost cost;
  FlowProfile const flow = mean_of(profiles_of(steady_column(layer, exact, cells), evenly(2, 3, 20), cost));
  std::string const name = fmt::format("beta = {}, {} Pa kept, h/{}", beta, kept, cells);
  compare_with_layer(findings, name, flow, exact, asked,
                     asked > 0 ? fmt::format("{:g} %", 100 * asked) : "nothing asked on so coarse a grid", cost);
  plot.curves.push_back({fmt::format("beta = {}, h/{}", beta, cells), flow.y, flow.u});
  if (asked == 0) return;
  plot.curves.push_back({fmt::format("beta = {}, exact", beta), exact.y, exact.u, true});
  if (kept == 0) return;
  SteadyLayer const without(bead_layer(slope, beta));
  double const u_0 = without.surface();
  findings.note(name, "surface speed that the plug costs over the exact one",
                (u_0 - flow.surface()) / (u_0 - exact.surface()), "1: all of the plug is there");
  findings.note(name, "exact depth of the plug over h_0", 1 - layer.plug_begin() / layer.layer.h_0);
}

/// Towards steady flow, near the largest cohesion.
void flows(Findings& findings, double beta) {
  (void)check_motion(findings, fmt::format("beta = {}, from 0.5 m/s", beta),
                     {bead_layer(slope, beta), [](double Y) { return 10 * Y; }}, {0.5, 1, 2}, 0.03);
}

/// To rest, beyond it.
void stops(Findings& findings, double beta) {
  constexpr double U = 0.5;
  auto const layer = bead_layer(slope, beta);
  Cost cost;
  SettledColumn const column{layer, [](double Y) { return U * Y / FlowColumn::height; }};
  double const surface = profiles_of(column, {3.0}, cost).back().surface();
  double const largest = largest_cohesion(layer.layer.slope, layer.layer.fluid.friction.mu_1);
  findings.check(fmt::format("beta = {}, beta* = {:.4f}", beta, largest),
                 "|surface speed| after 3 s over the initial one", std::abs(surface) / U, at_most(1e-3), "at rest",
                 cost);
}

void run(Findings& findings) {
  for (double const kept : {0.0, 400.0}) {
    Plot plot{fmt::format("Cohesive column on 32 degrees, {} Pa kept: u over y", kept), "y [m]", "u [m/s]"};
    for (double const beta : {0.05, 0.1, 0.2}) {
      steady(findings, plot, beta, kept, 20, kept > 0 ? 0 : 0.02);
      if (kept > 0) steady(findings, plot, beta, kept, 40, 0.02);
    }
    findings.plots.push_back(plot);
  }
  for (double const beta : {0.26, 0.275}) stops(findings, beta);
  flows(findings, 0.22);
}

}  // namespace

Case const the_case{"flow/column_cohesive",
                    "A cohesive column on a slope of 32 degrees",
                    "compressible layer with and without a plug, by quadrature",
                    "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figure 16",
                    2,
                    900,
                    run};

}  // namespace talus::verification::flow_column_cohesive
