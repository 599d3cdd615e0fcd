/// The steady column on 28 degrees with other elasticity and hardening: each parameter by itself, over decades where it
/// has them. Steady flow hardly depends on any; what it depends on, the change of volume, is in the reference. Besides,
/// disordered particles with less hardening than in flow/column.
///
/// Source: Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figure 26.

#include <fmt/format.h>

#include "verification/reference/flow/layer.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/settled_column.hpp"

namespace talus::verification::flow_column_parameters {

namespace {

using namespace reference::flow;

/// One parameter of the fluid, and what it is set to.
struct Sweep {
  std::string name;
  double& (*parameter)(Fluid&);
  std::vector<double> values;
};

std::vector<Sweep> sweeps() {
  return {{"E", [](Fluid& f) -> double& { return f.elastic.E; }, {1e5, 3e5, 1e6, 1e7}},
          {"nu", [](Fluid& f) -> double& { return f.elastic.nu; }, {0, 0.4, 0.45}},
          {"p_c0", [](Fluid& f) -> double& { return f.hardening.p_c0; }, {10, 50, 400, 1e4}},
          {"xi", [](Fluid& f) -> double& { return f.hardening.xi; }, {20, 30, 100, 200}}};
}

/// Disordered particles: differences of volume between neighbours are of pressure, xi times as large.
void disordered(Findings& findings) {
  for (double const xi : {15.0, 30.0}) {
    auto layer = bead_layer(28);
    layer.layer.fluid.hardening.xi = xi;
    SteadyLayer const exact(layer);
    FlowColumn const column{.name = fmt::format("xi = {}, disordered, 12 particles a cell", xi),
                            .gradient = exact.surface() / FlowColumn::height,
                            .changes = {R"(/bodies/0/seeding={"type": "poisson_disk", "per_cell": 12, "seed": 42})",
                                        fmt::format("/materials/0/law/xi={}", xi)}};
    Cost cost;
    FlowProfile const flow = mean_of(profiles_of(FlowColumn::study, column.all_changes(), evenly(2, 3, 20), cost));
    compare_with_layer(findings, column.name, flow, exact, 0, "h/20; flow/column has xi = 50", cost);
    findings.note(column.name, "scatter of p between neighbours", flow.scatter, "standard deviation over mean");
  }
}

void sweep_over(Findings& findings, Sweep const& sweep) {
  Plot plot{"Column on 28 degrees, other " + sweep.name + ": u over y", "y [m]", "u [m/s]"};
  for (double const value : sweep.values) {
    auto layer = bead_layer(28);
    sweep.parameter(layer.layer.fluid) = value;
    SteadyLayer const exact(layer);
    Cost cost;
    FlowProfile const flow = mean_of(profiles_of(steady_column(layer, exact), evenly(2, 3, 20), cost));
    std::string const name = fmt::format("{} = {:g}", sweep.name, value);
    compare_with_layer(findings, name, flow, exact, 0.02, "2 % at h/20", cost);
    findings.note(name, "exact surface speed over that of the incompressible layer",
                  exact.top_speed / bagnold_surface_speed({layer.layer.fluid, layer.layer.slope, layer.layer.h_0}));
    plot.curves.push_back({name, flow.y, flow.u});
    plot.curves.push_back({name + ", exact", exact.y, exact.u, true});
  }
  findings.plots.push_back(plot);
}

void run(Findings& findings) {
  for (Sweep const& sweep : sweeps()) sweep_over(findings, sweep);
  disordered(findings);
}

}  // namespace

Case const the_case{"flow/column_parameters",
                    "The steady column with other elasticity and hardening",
                    "compressible layer, by quadrature",
                    "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figure 26",
                    2,
                    600,
                    run};

}  // namespace talus::verification::flow_column_parameters
