/// Flow from a reservoir through a gate onto a rough slope. It comes out fast, and slows down along the slope towards the
/// steady flow of a layer of its depth.
///
/// The shipped documents, on a wall that mirrors, with the associated law and particles on a lattice, E = 0.2 MPa (see
/// flow/column_parameters: it hardly matters). What a station finds is compared with the exact steady layer of the depth
/// found there. Particles crowd (docs/theory/column.md): mass over depth tells how much; 4 along an axis of a cell keep it
/// small.
///
/// Source: Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figures 5, 6, 7 and 16.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>

#include "core/cli/program.hpp"
#include "core/io/files.hpp"
#include "verification/reference/flow/interpolated.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/places.hpp"
#include "verification/suite/settled_column.hpp"

namespace talus::verification {

namespace {

using namespace reference::flow;

constexpr double length = 0.2;       // of a station along the slope [m]
constexpr double spacing = 0.00625;  // [m]: 8 cells in the gate
constexpr double E = 2e5;            // [Pa]

/// Means over time of what a station finds: columns of the series by name, and bins of its depth, by mass.
struct Found {
  std::map<std::string, double> of;
  std::vector<double> y, u;
  Cost cost = {};
};

struct Inflow {
  std::string study;
  double slope, beta;  ///< [deg], [1]
  int per_axis;
  double reservoir;  ///< its length [m]
  double station;    ///< its middle [m]
};

std::vector<std::string> changes_of(Inflow const& flow) {
  return {fmt::format("/grid/spacing={}", spacing),
          fmt::format("/gravity/slope_deg={}", flow.slope),
          fmt::format("/materials/0/law/beta={}", flow.beta),
          fmt::format("/materials/0/law/young_modulus={}", E),
          R"(/materials/0/law/type="cam_clay_mu_i_two_stage")",
          R"(/walls/0/contact={"type": "mirrored_stick"})",
          fmt::format(R"(/bodies/0/seeding={{"type": "lattice", "per_axis": {}}})", flow.per_axis),
          fmt::format(R"(/bodies/0/shape={{"type": "box", "min": [-{}, 0.1], "max": [0, 0.2]}})", flow.reservoir),
          fmt::format(R"(/output/stations=[{{"name": "at", "min": [{}, 0], "max": [{}, 0.1], "bins": 40}}])",
                      flow.station - length / 2, flow.station + length / 2),
          R"(/output/ledger={"type": "none"})"};
}

/// Sums of a profile's bins over times.
class BinSums {
 public:
  void add(Profile const& profile) {
    auto const column = [&](std::string const& name) {
      return std::size_t(std::ranges::find(profile.quantities, name, &Quantity::name) - profile.quantities.begin());
    };
    std::size_t const mass = column("mass"), height = column("height"), speed = column("flow_velocity");
    sums_.resize(profile.rows.size());
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      auto const& row = profile.rows[k];
      if (row[mass] > 0)
        sums_[k] = {sums_[k].mass + row[mass], sums_[k].y + row[mass] * row[height],
                    sums_[k].u + row[mass] * row[speed]};
    }
  }
  /// Of the bins that hold at least a tenth of what the fullest holds.
  void tell(Found& found) const {
    double const most = std::ranges::max_element(sums_, {}, &Sum::mass)->mass;
    for (Sum const& sum : sums_)
      if (sum.mass > 0.1 * most) found.y.push_back(sum.y / sum.mass), found.u.push_back(sum.u / sum.mass);
  }

 private:
  struct Sum {
    double mass = 0, y = 0, u = 0;
  };
  std::vector<Sum> sums_;
};

Found found_by(Inflow const& flow, std::vector<double> const& times) {
  std::string const file = std::string(studies) + "/" + flow.study;
  Document document = parse(io::read_file(file), file);
  for (std::string const& change : changes_of(flow)) set_value(document, change);
  Composed const composed = program().compose(document);
  Experiment& experiment = *composed.experiment;
  auto const names = experiment.quantities();
  Found found;
  BinSums bins;
  auto const begun = std::chrono::steady_clock::now();
  for (double const t : times) {
    while (experiment.time() < t) experiment.advance(t);
    auto const values = experiment.measure();
    for (std::size_t k = 0; k < names.size(); ++k) found.of[names[k].name] += values[k] / double(times.size());
    bins.add(experiment.profiles().front());
  }
  bins.tell(found);
  found.cost = {std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count(), experiment.steps(),
                double(experiment.steps()) * double(experiment.particles())};
  return found;
}

/// The layer that is `depth` [m] thick.
CompressiblePluggedLayer layer_of(Fluid fluid, double slope, double depth) {
  fluid.elastic.E = E;
  CompressiblePluggedLayer layer{{fluid, radians(slope), depth}, 0};
  for (int k = 0; k < 4; ++k) layer.layer.h_0 *= depth / SteadyLayer(layer).thickness;
  return layer;
}

double error_of(Found const& found, SteadyLayer const& exact) {
  double off = 0, all = 0;
  for (std::size_t k = 0; k < found.y.size(); ++k) {
    double const u = interpolated(exact.y, exact.u, std::min(found.y[k], exact.y.back()));
    off += (found.u[k] - u) * (found.u[k] - u);
    all += u * u;
  }
  return std::sqrt(off / all);
}

void without_cohesion(Findings& findings) {
  Inflow const flow{"inflow_24.json", 24, 0, 4, 1.4, 1.5};
  Found const found = found_by(flow, evenly(6, 7, 20));
  double const depth = found.of.at("at_depth"), mu = found.of.at("at_mobilised_friction");
  Fluid const fluid = glass_beads(32.76, 0);
  SteadyLayer const exact(layer_of(fluid, flow.slope, depth));
  SteadyLayer const local(layer_of(fluid, std::atan(mu) / radians(1), depth));
  std::string const name = "24 deg, 1.5 m from the gate, 6 to 7 s";
  findings.check(name, "mean friction over tan(slope)", mu / tangent(flow.slope), about(1, 0.02),
                 "2 %; still slowing down", found.cost);
  findings.check(name, "solid fraction over that of the layer", found.of.at("at_solid_fraction") / exact.solid_fraction,
                 about(1, 0.01), "1 %");
  findings.check(name, "surface speed over that of the steady layer", found.of.at("at_surface_speed") / exact.surface,
                 about(1, 0.15), "15 %; still slowing down, and particles are disordered");
  findings.note(name, "error of the profile, steady layer", error_of(found, exact), "of the depth found");
  findings.check(name, "error of the profile, layer on a slope of the friction found", error_of(found, local),
                 at_most(0.1), "10 %");
  findings.note(name, "mass over that of the depth: crowding",
                found.of.at("at_mass") * found.of.at("at_volume_ratio") / (fluid.density * length * depth),
                "1: particles fill their volumes");
  findings.plots.push_back(
      {"Inflow on 24 degrees, 1.5 m from the gate: u over y",
       "y [m]",
       "u [m/s]",
       false,
       false,
       {Curve{"bins", found.y, found.u}, Curve{"steady layer of this depth", exact.y, exact.u, true},
        Curve{"layer of the friction found", local.y, local.u, true}}});
}

void with_cohesion(Findings& findings) {
  Plot plot{"Cohesive inflow on 32 degrees, 0.8 m from the gate: u over y", "y [m]", "u [m/s]"};
  double before = std::numeric_limits<double>::infinity();
  for (double const beta : {0.0, 0.1, 0.2}) {
    Found const found = found_by({"inflow_cohesive_32.json", 32, beta, 3, 0.48, 0.8}, evenly(1.6, 2, 10));
    double const speed = found.of.at("at_surface_speed");
    std::string const name = fmt::format("32 deg, beta = {}, 0.8 m from the gate, 1.6 to 2 s", beta);
    if (beta > 0)
      findings.check(name, "surface speed over that with less cohesion", speed / before, at_most(0.99), "falls",
                     found.cost);
    findings.note(name, "surface speed", speed).unit = "m/s";
    findings.note(name, "mean friction over tan(slope)", found.of.at("at_mobilised_friction") / tangent(32));
    plot.curves.push_back({fmt::format("beta = {}", beta), found.y, found.u});
    before = speed;
  }
  findings.plots.push_back(plot);
}

void run(Findings& findings) {
  without_cohesion(findings);
  with_cohesion(findings);
}

}  // namespace

Case const flow_inflow{"flow/inflow",
                       "Inflow through a gate onto a rough slope",
                       "compressible layer of the depth that a station finds, by quadrature",
                       "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figures 5, 6, 7 and 16",
                       2,
                       1200,
                       run};

}  // namespace talus::verification
