/// The periodic column on a slope: how it comes to its steady flow, where that lies, and what decides its error.
///
/// The shipped study (h = 0.05 m, mu_2 = tan 40 deg, E = 1 MPa) with the associated flow rule on a wall that mirrors; then
/// one thing at a time is changed. Compared with the compressible layer, whose height and pressure follow from the model,
/// at the heights of 20 slices of equal mass:
///
///   error of the profile = sqrt(sum (u - u_exact)^2 / sum u_exact^2),   surface: the uppermost 5 % of the mass      (1)
///
/// Three things were found to decide. The flow rule of the published runs keeps p_c/p = 2 + xi p_c/K, which makes the
/// layer stronger. Particles carry volumes that differ by about 1 % between neighbours, and with them pressures that
/// differ by more than half, since the flowing layer's modulus is xi p and not K; friction is concave in p, so that the
/// layer flows faster. And particles crowd, so that the layer is thinner than its volumes say. See also docs/theory/column.md.
///
/// Source: Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figures 26 and 29.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "core/cli/program.hpp"
#include "core/io/files.hpp"
#include "verification/reference/flow/compressible_layer.hpp"
#include "verification/reference/flow/interpolated.hpp"
#include "verification/reference/flow/motion.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/places.hpp"

namespace talus::verification {

namespace {

using namespace reference::flow;

constexpr double height = 0.05;  // unstrained [m]
constexpr int slices = 20;

/// What may be changed, in the words of the document.
struct Column {
  std::string name = "as recommended";
  int cells = 20;        ///< in the height
  double slope = 28;     ///< [deg]
  double gradient = 20;  ///< of the initial velocity [1/s]
  std::vector<std::string> changes = {};
};

Composed composed(Column const& column) {
  std::string const file = std::string(studies) + "/bagnold_column.json";
  Document document = parse(io::read_file(file), file);
  double const h = height / column.cells, width = 12 * h;
  for (std::string const& change :
       {fmt::format("/grid/spacing={}", h), fmt::format("/grid/periods=[{}, 0]", width),
        fmt::format("/gravity/slope_deg={}", column.slope), std::string(R"(/bodies/0/shape/min=[0, 0])"),
        fmt::format("/bodies/0/shape/max=[{}, {}]", width, height), std::string(R"(/bodies/0/seeding/per_cell=12)"),
        std::string("/bodies/0/velocity/origin=[0, 0]"),
        fmt::format("/bodies/0/velocity/gradient=[[0, {}], [0, 0]]", column.gradient),
        std::string(R"(/materials/0/law/type="cam_clay_mu_i_two_stage")"), std::string(R"(/transfer={"type": "apic"})"),
        std::string(R"(/walls/0/contact={"type": "mirrored_stick"})"), std::string(R"(/output/stations=[])"),
        std::string(R"(/output/ledger={"type": "none"})"), std::string("/expect=[]")})
    set_value(document, change);
  for (std::string const& change : column.changes) set_value(document, change);
  return program().compose(document);
}

/// Means over slices of equal mass, from the base on, and over the whole layer.
struct Flow {
  std::vector<double> y = std::vector<double>(slices), u = y, p = y;  ///< [m], [m/s], [Pa]
  double surface = 0, thickness = 0;                                  ///< of the uppermost 5 %; twice the mean height
  double scatter = 0;  ///< standard deviation of p in a slice over its mean, mean of the inner slices [1]
};

NamedColumn const& named(talus::Snapshot const& snapshot, std::string const& name) {
  return *std::ranges::find(snapshot.columns, name, &NamedColumn::name);
}

Flow flow_of(talus::Snapshot const& snapshot, double K) {
  auto const &x = named(snapshot, "position").values, &v = named(snapshot, "velocity").values,
             &strain = named(snapshot, "elastic_strain").values;
  std::size_t const n = x.size() / 2, size = strain.size() / n;
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](std::size_t p) { return x[2 * p + 1]; });
  Flow flow;
  std::vector<double> square(slices), count(slices);
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t const p = order[k], s = k * slices / n;
    double const pressure = -K * (strain[size * p] + strain[size * p + 1]);
    flow.y[s] += x[2 * p + 1];
    flow.u[s] += v[2 * p];
    flow.p[s] += pressure;
    square[s] += pressure * pressure;
    count[s] += 1;
    flow.thickness += 2 * x[2 * p + 1] / double(n);
  }
  for (std::size_t s = 0; s < slices; ++s) {
    for (auto* list : {&flow.y, &flow.u, &flow.p, &square}) (*list)[s] /= count[s];
    if (s >= 2 && s < slices - 2) flow.scatter += std::sqrt(square[s] / (flow.p[s] * flow.p[s]) - 1) / (slices - 4);
  }
  flow.surface = flow.u.back();
  return flow;
}

/// The flow at these times, or their mean.
std::vector<Flow> flows_at(Column const& column, std::vector<double> const& times, Cost& cost) {
  Composed const composed = verification::composed(column);
  Experiment& experiment = *composed.experiment;
  double const K = glass_beads(40, 0).elastic.K();
  auto const begun = std::chrono::steady_clock::now();
  std::vector<Flow> flows;
  for (double const t : times) {
    while (experiment.time() < t) experiment.advance(t);
    flows.push_back(flow_of(experiment.state(), K));
  }
  cost.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  cost.steps += experiment.steps();
  cost.particle_steps += double(experiment.steps()) * double(experiment.particles());
  return flows;
}

Flow mean_of(std::vector<Flow> const& flows) {
  Flow mean;
  double const share = 1.0 / double(flows.size());
  for (Flow const& flow : flows) {
    for (std::size_t s = 0; s < slices; ++s) {
      mean.y[s] += share * flow.y[s];
      mean.u[s] += share * flow.u[s];
      mean.p[s] += share * flow.p[s];
    }
    mean.surface += share * flow.surface;
    mean.thickness += share * flow.thickness;
    mean.scatter += share * flow.scatter;
  }
  return mean;
}

/// (1), where y and u are the exact profile.
double profile_error(Flow const& flow, std::vector<double> const& y, std::vector<double> const& u) {
  double off = 0, all = 0;
  for (std::size_t s = 0; s < slices; ++s) {
    double const exact = interpolated(y, u, std::min(flow.y[s], y.back()));
    off += (flow.u[s] - exact) * (flow.u[s] - exact);
    all += exact * exact;
  }
  return std::sqrt(off / all);
}

/// The steady layer on a slope: heights, speeds; and the speed of its uppermost 5 %.
struct Steady {
  std::vector<double> y, u;
  double surface = 0, thickness = 0;

  explicit Steady(double slope) {
    CompressibleLayer const layer{glass_beads(40, 0), radians(slope), height};
    constexpr int places = 400;
    std::vector<double> Y;
    for (int k = 0; k < places; ++k) Y.push_back(height * (k + 0.5) / places);
    auto const profile = profile_by_quadrature(layer, Y);
    for (auto const& at : profile.at) {
      y.push_back(at.y);
      u.push_back(at.u);
      thickness += 2 * at.y / places;
    }
    y.push_back(profile.h);
    u.push_back(profile.surface_speed);
    surface = std::accumulate(u.end() - 1 - places / 20, u.end() - 1, 0.0) / (places / 20);
  }
};

void start_up(Findings& findings) {
  std::vector<double> const times{0.1, 0.2, 0.5, 1, 2};
  reference::flow::Motion const motion{glass_beads(40, 0),
                                       radians(28),
                                       height,
                                       reference::flow::Motion::Volume::critical,
                                       [](double Y) { return 80 * Y; },
                                       false};
  auto const exact = extrapolated_motion(motion, 100, times, 1e-9);
  Cost cost;
  auto const flows = flows_at({.gradient = 80}, times, cost);
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

/// The rows of one steady column; asked: the bar on surface and profile, or 0.
Flow steady(Findings& findings, Column const& column, double asked, std::string const& because) {
  Steady const exact(column.slope);
  Cost cost;
  std::vector<double> times;
  for (int k = 0; k <= 20; ++k) times.push_back(2 + 0.05 * k);
  Flow const flow = mean_of(flows_at(column, times, cost));
  double const surface = flow.surface / exact.surface - 1, profile = profile_error(flow, exact.y, exact.u);
  if (asked > 0) {
    findings.check(column.name, "|error of the surface speed|", std::abs(surface), at_most(asked), because, cost);
    findings.check(column.name, "error of the profile", profile, at_most(asked), because);
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
std::vector<Column> variants() {
  auto const law = [](std::string const& type) { return fmt::format(R"(/materials/0/law/type="{}")", type); };
  return {{.name = "flow rule of the published runs", .changes = {law("cam_clay_mu_i_two_stage_hardening_flow")}},
          {.name = "coupled map", .changes = {law("cam_clay_mu_i_consistent")}},
          {.name = "wall at nodes only", .changes = {R"(/walls/0/contact={"type": "stick"})"}},
          {.name = "AFLIP 0.95", .changes = {R"(/transfer={"type": "aflip", "alpha": 0.95})"}},
          {.name = "cubic kernel", .changes = {R"(/kernel={"type": "cubic"})"}},
          {.name = "MUSL", .changes = {R"(/integrator={"type": "musl"})"}},
          {.name = "6 particles a cell", .changes = {"/bodies/0/seeding/per_cell=6"}},
          {.name = "24 particles a cell", .changes = {"/bodies/0/seeding/per_cell=24"}},
          {.name = "half the step", .changes = {"/time/safety=0.4"}},
          {.name = "on a lattice, 9 a cell", .changes = {R"(/bodies/0/seeding={"type": "lattice", "per_axis": 3})"}},
          {.name = "as published",
           .changes = {law("cam_clay_mu_i_two_stage_hardening_flow"), R"(/walls/0/contact={"type": "stick"})",
                       R"(/transfer={"type": "aflip", "alpha": 0.95})"}}};
}

void run(Findings& findings) {
  start_up(findings);
  Plot plot{"Steady column on 28 degrees: u over y", "y [m]", "u [m/s]"};
  for (int const cells : {20, 40}) {
    Column const column{.name = fmt::format("steady, h/{}", cells), .cells = cells};
    double const asked = cells == 20 ? 0.02 : 0.005;
    Flow const flow = steady(findings, column, asked, "2 % at h/20, 0.5 % at h/40");
    plot.curves.push_back({column.name, flow.y, flow.u});
  }
  for (Column const& column : variants()) {
    Flow const flow = steady(findings, column, 0, "a cause, h/20");
    if (column.name == "as published") plot.curves.push_back({column.name, flow.y, flow.u});
  }
  Steady const exact(28);
  plot.curves.push_back({"exact", exact.y, exact.u, true});
  findings.plots.push_back(plot);
  for (double const slope : {24.0, 26.0, 30.0, 32.0})
    steady(findings, {.name = fmt::format("steady, {} deg", slope), .slope = slope}, 0, "h/20");
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
