/// The periodic column on a slope: how it comes to its steady flow, where that lies, and what decides its error.
///
/// The column of suite/flow_profile.hpp; then one thing at a time is changed. Compared with the compressible layer, whose
/// height and pressure follow from the model. surface: mean speed of the uppermost 5 % of the mass.
///
/// What was found to decide: the flow rule of the published runs keeps p_c/p = 2 + xi p_c/K, which makes the layer
/// stronger. Particles carry volumes that differ by about 1 % between neighbours, and with them pressures that differ by
/// half and more, since the flowing layer's modulus is xi p and not K; friction is concave in p, so that the layer flows
/// faster. Particles crowd, so that the layer is thinner than its volumes say. See docs/theory/column.md.
///
/// Source: Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figures 26 and 29.

#include <fmt/format.h>

#include <limits>

#include "verification/reference/flow/fluid.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/order.hpp"
#include "verification/suite/settled_column.hpp"

namespace talus::verification::flow_column {

namespace {

using namespace reference::flow;

/// A column that has become steady, on a slope [deg].
struct Ended {
  std::string name;
  double slope;
  FlowProfile flow;  ///< mean from 2 to 3 s
  Cost cost = {};
};

std::vector<double> const steady_times = evenly(2, 3, 20);

/// Begun with the exact surface speed, everything else as the document has it.
Ended of_document(FlowColumn column) {
  column.gradient = SteadyLayer(bead_layer(column.slope)).surface() / FlowColumn::height;
  Ended ended{column.name, column.slope, {}};
  ended.flow = mean_of(profiles_of(FlowColumn::study, column.all_changes(), steady_times, ended.cost));
  return ended;
}

/// The same begun as the exact layer.
Ended settled(std::string const& name, double slope, int cells) {
  auto const layer = bead_layer(slope);
  Ended ended{name, slope, {}};
  ended.flow = mean_of(profiles_of(steady_column(layer, SteadyLayer(layer), cells), steady_times, ended.cost));
  return ended;
}

/// The rows of one steady column; asked: the bar on surface and profile, or 0.
void tell(Findings& findings, Ended const& column, double asked, std::string const& because) {
  SteadyLayer const exact(bead_layer(column.slope));
  FlowProfile const& flow = column.flow;
  compare_with_layer(findings, column.name, flow, exact, asked, because, column.cost);
  if (asked > 0) {
    findings.check(column.name, "mean friction over tan(slope)", flow.friction() / tangent(column.slope),
                   about(1, 0.002), "0.2 %; exact to 3e-4 of elastic shear");
    findings.check(column.name, "mean solid fraction over the exact one",
                   glass_beads(40, 0).solid_fraction() / flow.stretch / exact.solid_fraction, about(1, 5e-4),
                   "0.05 %, which is 2.5 % of strength");
  }
  findings.note(column.name, "thickness over that of the exact layer, less 1", flow.thickness / exact.thickness - 1,
                "by the particles' places");
  findings.note(column.name, "scatter of p between neighbours", flow.scatter, "standard deviation over mean");
}

/// One thing at a time.
std::vector<FlowColumn> variants() {
  auto const law = [](std::string const& type) { return fmt::format(R"(/materials/0/law/type="{}")", type); };
  auto const disordered = [](int per_cell) {
    return fmt::format(R"(/bodies/0/seeding={{"type": "poisson_disk", "per_cell": {}, "seed": 42}})", per_cell);
  };
  return {{.name = "begun without stress, else nothing"},
          {.name = "flow rule of the published runs", .changes = {law("cam_clay_mu_i_two_stage_hardening_flow")}},
          {.name = "coupled map", .changes = {law("cam_clay_mu_i_consistent")}},
          {.name = "wall at nodes only", .changes = {R"(/walls/0/contact={"type": "stick"})"}},
          {.name = "APIC", .changes = {R"(/transfer={"type": "apic"})"}},
          {.name = "pure AFLIP", .changes = {R"(/transfer={"type": "aflip", "alpha": 1})"}},
          {.name = "APIC, half the step", .changes = {R"(/transfer={"type": "apic"})", "/time/safety=0.4"}},
          {.name = "cubic kernel", .changes = {R"(/kernel={"type": "cubic"})"}},
          {.name = "MUSL", .changes = {R"(/integrator={"type": "musl"})"}},
          {.name = "4 particles a cell", .changes = {R"(/bodies/0/seeding/per_axis=2)"}},
          {.name = "16 particles a cell", .changes = {R"(/bodies/0/seeding/per_axis=4)"}},
          {.name = "half the step", .changes = {"/time/safety=0.4"}},
          {.name = "disordered, 6 a cell", .changes = {disordered(6)}},
          {.name = "disordered, 12 a cell", .changes = {disordered(12)}},
          {.name = "disordered, 24 a cell", .changes = {disordered(24)}},
          {.name = "disordered, cubic kernel", .changes = {disordered(12), R"(/kernel={"type": "cubic"})"}},
          {.name = "as published",
           .changes = {law("cam_clay_mu_i_two_stage_hardening_flow"), disordered(20),
                       R"(/walls/0/contact={"type": "stick"})", R"(/transfer={"type": "aflip", "alpha": 0.95})"}}};
}

/// The settled column on finer and finer grids.
void refine_steady(Findings& findings, Plot& plot) {
  SteadyLayer const exact(bead_layer(28));
  std::vector<double> spacings, errors;
  auto const begun_as_layer = [&](int cells, double asked, std::string const& because) {
    Ended const column = settled(fmt::format("steady, h/{}", cells), 28, cells);
    tell(findings, column, asked, because);
    plot.curves.push_back({column.name, column.flow.y, column.flow.u});
    spacings.push_back(FlowColumn::height / cells);
    errors.push_back(profile_error(column.flow, exact.profile));
  };
  begun_as_layer(10, 0, "nothing asked on so coarse a grid");
  begun_as_layer(20, 0.02, "2 % at h/20");
  begun_as_layer(40, 0.005, "0.5 % at h/40");
  plot.curves.push_back({"exact", exact.y, exact.u, true});
  auto const slope = fitted_slope(spacings, errors);
  auto& row =
      findings.check("steady, h/10 to h/40", "order of the profile's error",
                     slope ? slope->value : std::numeric_limits<double>::quiet_NaN(), at_least(1), "at least 1");
  if (slope) row.uncertainty = slope->interval;
}

void run(Findings& findings) {
  (void)check_motion(findings, "28 deg from 4 m/s, h/20", {bead_layer(28), [](double Y) { return 80 * Y; }},
                     {0.1, 0.2, 0.5, 1, 2}, 0.03);
  Plot plot{"Steady column on 28 degrees: u over y", "y [m]", "u [m/s]"};
  refine_steady(findings, plot);
  for (FlowColumn const& variant : variants()) {
    Ended const column = of_document(variant);
    tell(findings, column, 0, "a cause, h/20");
    if (column.name == "as published") plot.curves.push_back({column.name, column.flow.y, column.flow.u});
  }
  findings.plots.push_back(plot);
  for (double const slope : {23.0, 24.0, 26.0, 30.0, 32.0})
    tell(findings, settled(fmt::format("steady, {} deg, h/20", slope), slope, 20), 0.02, "2 % at h/20");
}

}  // namespace

Case const the_case{"flow/column",
                    "The periodic column on a slope comes to its steady flow; what decides its error",
                    "compressible layer: quadrature by GSL, method of lines by CVODE",
                    "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figures 26 and 29",
                    2,
                    1800,
                    run};

}  // namespace talus::verification::flow_column
