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

#include <cmath>

#include "verification/reference/flow/motion.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/order.hpp"
#include "verification/suite/settled_column.hpp"

namespace talus::verification {

namespace {

using namespace reference::flow;

void start_up(Findings& findings) {
  std::vector<double> const times{0.1, 0.2, 0.5, 1, 2};
  reference::flow::Motion const motion{glass_beads(40, 0),
                                       radians(28),
                                       FlowColumn::height,
                                       reference::flow::Motion::Volume::critical,
                                       [](double Y) { return 80 * Y; },
                                       false};
  auto const exact = extrapolated_motion(motion, 100, times, 1e-9);
  Cost cost;
  auto const flows = profiles_of(SettledColumn{bead_layer(28), [](double Y) { return 80 * Y; }}, times, cost);
  Plot plot{"Column on 28 degrees from 4 m/s: u over y", "y [m]", "u [m/s]"};
  for (std::size_t k = 0; k < times.size(); ++k) {
    findings.check("start-up, h/20", fmt::format("error of the profile at {} s", times[k]),
                   profile_error(flows[k], exact.at[k].y, exact.at[k].u), at_most(0.03),
                   "3 %; method of lines by CVODE, extrapolated", k == 0 ? cost : Cost{});
    plot.curves.push_back({fmt::format("{} s", times[k]), flows[k].y, flows[k].u});
    plot.curves.push_back({fmt::format("exact, {} s", times[k]), exact.at[k].y, exact.at[k].u, true});
  }
  findings.plots.push_back(plot);
}

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
  column.gradient = SteadyLayer(bead_layer(column.slope)).surface / FlowColumn::height;
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
FlowProfile steady(Findings& findings, Ended const& column, double asked, std::string const& because) {
  SteadyLayer const exact(bead_layer(column.slope));
  FlowProfile const& flow = column.flow;
  Cost const& cost = column.cost;
  double const surface = flow.surface() / exact.surface - 1, profile = profile_error(flow, exact.y, exact.u);
  if (asked > 0) {
    findings.check(column.name, "|error of the surface speed|", std::abs(surface), at_most(asked), because, cost);
    findings.check(column.name, "error of the profile", profile, at_most(asked), because);
    findings.check(column.name, "mean friction over tan(slope)", flow.friction() / tangent(column.slope),
                   about(1, 0.005), "0.5 %; Kirchhoff stress, by mass");
    findings.check(column.name, "mean solid fraction over the exact one",
                   glass_beads(40, 0).solid_fraction() / flow.stretch / exact.solid_fraction, about(1, 0.005), "0.5 %");
  } else {
    findings.note(column.name, "error of the surface speed", surface, because, cost);
    findings.note(column.name, "error of the profile", profile, because);
  }
  findings.note(column.name, "thickness over that of the exact layer, less 1", flow.thickness / exact.thickness - 1,
                "by the particles' places");
  findings.note(column.name, "scatter of p between neighbours", flow.scatter, "standard deviation over mean");
  return flow;
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

void run(Findings& findings) {
  start_up(findings);
  Plot plot{"Steady column on 28 degrees: u over y", "y [m]", "u [m/s]"};
  SteadyLayer const exact(bead_layer(28));
  std::vector<double> spacings, errors;
  for (int const cells : {10, 20, 40}) {
    Ended const column = settled(fmt::format("steady, h/{}", cells), 28, cells);
    double const asked = cells == 10 ? 0 : cells == 20 ? 0.02 : 0.005;
    FlowProfile const flow = steady(findings, column, asked, "2 % at h/20, 0.5 % at h/40");
    plot.curves.push_back({column.name, flow.y, flow.u});
    spacings.push_back(FlowColumn::height / cells);
    errors.push_back(profile_error(flow, exact.y, exact.u));
  }
  findings.check("steady, h/10 to h/40", "order of the profile's error", fitted_slope(spacings, errors)->value,
                 at_least(1), "at least 1");
  for (FlowColumn const& column : variants()) {
    FlowProfile const flow = steady(findings, of_document(column), 0, "a cause, h/20");
    if (column.name == "as published") plot.curves.push_back({column.name, flow.y, flow.u});
  }
  plot.curves.push_back({"exact", exact.y, exact.u, true});
  findings.plots.push_back(plot);
  for (double const slope : {23.0, 24.0, 26.0, 30.0, 32.0})
    (void)steady(findings, settled(fmt::format("steady, {} deg, h/20", slope), slope, 20), 0.02, "2 % at h/20");
}

}  // namespace

Case const flow_column{"flow/column",
                       "The periodic column on a slope comes to its steady flow; what decides its error",
                       "compressible layer: quadrature by GSL, method of lines by CVODE",
                       "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figures 26 and 29",
                       2,
                       900,
                       run};

}  // namespace talus::verification
