/// The periodic column on 32 degrees with cohesion: slower with beta, and at rest beyond beta*.
///
/// At critical state the profile is Bagnold's with omega = (1 + beta)/(1 - beta); it ends at
/// beta* = (tan(slope) - mu_1)/(tan(slope) + mu_1). Near the surface, where nothing shears, the strength is not that of
/// critical state but what it was before, so that a plug is to be expected there, which is not in the reference.
///
/// Source: Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figure 16.

#include <fmt/format.h>

#include "verification/reference/flow/compressible_layer.hpp"
#include "verification/reference/flow/layer.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/flow_profile.hpp"

namespace talus::verification {

namespace {

using namespace reference::flow;

FlowColumn column_of(double beta) {
  return {
      .name = fmt::format("beta = {}", beta), .slope = 32, .changes = {fmt::format("/materials/0/law/beta={}", beta)}};
}

void run(Findings& findings) {
  Plot plot{"Cohesive column on 32 degrees: u over y", "y [m]", "u [m/s]"};
  for (double const beta : {0.05, 0.1, 0.2}) {
    FlowColumn const column = column_of(beta);
    CompressibleLayer const layer{glass_beads(40, beta), radians(32), FlowColumn::height};
    auto const exact = profile_by_quadrature(layer, evenly(0, 0.999 * FlowColumn::height, 400));
    std::vector<double> y, u;
    for (auto const& at : exact.at) {
      y.push_back(at.y);
      u.push_back(at.u);
    }
    Cost cost;
    FlowProfile const flow = mean_of(profiles_of(FlowColumn::study, column.all_changes(), evenly(3, 4, 20), cost));
    findings.note(column.name, "error of the surface speed", flow.surface() / exact.surface_speed - 1,
                  "h/20; the reference is at critical state up to the surface", cost);
    findings.note(column.name, "error of the profile", profile_error(flow, y, u));
    plot.curves.push_back({column.name, flow.y, flow.u});
    plot.curves.push_back({column.name + ", exact", y, u, true});
  }
  FlowColumn const column = column_of(0.275);
  Cost cost;
  auto const flows = profiles_of(FlowColumn::study, column.all_changes(), {2.0, 3.0}, cost);
  findings
      .check("beta = 0.275, beyond beta* = 0.241", "surface speed after 3 s", flows.back().surface(), at_most(0.01),
             "at rest: a hundredth of the speed at which it began", cost)
      .unit = "m/s";
  findings.plots.push_back(plot);
}

}  // namespace

Case const flow_column_cohesive{"flow/column_cohesive",
                                "A cohesive column on a slope of 32 degrees",
                                "compressible layer at critical state, by quadrature",
                                "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figure 16",
                                2,
                                300,
                                run};

}  // namespace talus::verification
