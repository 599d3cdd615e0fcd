/// Flow from a reservoir through a gate onto a rough slope. It comes out fast, and slows down along the slope towards the
/// steady flow of a layer of its mass.
///
/// The shipped documents, on a wall that mirrors, with the associated law and particles on a lattice, E = 0.1 MPa (see
/// flow/column_parameters: it hardly matters). What a station finds is compared with the exact layer of the mass found
/// there, on a slope of the friction found there, by share of the mass below: as long as the flow slows down, friction is
/// above tan(slope). Particles crowd (docs/theory/column.md): the depth is less than the mass asks for.
///
/// Source: Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figures 5, 6, 7 and 16.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "verification/suite/cases.hpp"
#include "verification/suite/settled_column.hpp"
#include "verification/suite/shipped.hpp"

namespace talus::verification::flow_inflow {

namespace {

using namespace reference::flow;

constexpr double length = 0.2;       // of a station along the slope [m]
constexpr double spacing = 0.00625;  // [m]: 8 cells in the gate
constexpr double E = 1e5;            // [Pa]

/// Means over time of what a station finds: columns of the series by name, and bins of its depth: the share of the mass
/// that lies below a bin's middle, its own share, and its speed [m/s].
struct Found {
  std::map<std::string, double> of;
  std::vector<double> below, share, u;
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
    std::size_t const mass = column("mass"), speed = column("flow_velocity");
    sums_.resize(profile.rows.size());
    for (std::size_t k = 0; k < sums_.size(); ++k)
      if (auto const& row = profile.rows[k]; row[mass] > 0)
        sums_[k] = {sums_[k].mass + row[mass], sums_[k].momentum + row[mass] * row[speed]};
  }
  void tell(Found& found) const {
    double all = 0, below = 0;
    for (Sum const& sum : sums_) all += sum.mass;
    for (Sum const& sum : sums_) {
      if (sum.mass == 0) continue;
      found.below.push_back((below + sum.mass / 2) / all);
      found.share.push_back(sum.mass / all);
      found.u.push_back(sum.momentum / sum.mass);
      below += sum.mass;
    }
  }

 private:
  struct Sum {
    double mass = 0, momentum = 0;
  };
  std::vector<Sum> sums_;
};

Found found_by(Inflow const& flow, std::vector<double> const& times) {
  Composed const composed = program().compose(shipped(flow.study, changes_of(flow)));
  Experiment& experiment = *composed.experiment;
  auto const names = experiment.quantities();
  Found found;
  BinSums bins;
  visit_times(experiment, times, found.cost, [&] {
    auto const values = experiment.measure();
    for (std::size_t k = 0; k < names.size(); ++k) found.of[names[k].name] += values[k] / double(times.size());
    bins.add(experiment.profiles().front());
  });
  bins.tell(found);
  return found;
}

/// sqrt(sum w (u - u_exact)^2 / sum w u_exact^2) over the bins, w their shares of the mass.
double error_of(Found const& found, SteadyLayer const& exact) {
  double off = 0, all = 0;
  for (std::size_t k = 0; k < found.u.size(); ++k) {
    double const u = exact.speed(found.below[k]);
    off += found.share[k] * (found.u[k] - u) * (found.u[k] - u);
    all += found.share[k] * u * u;
  }
  return std::sqrt(off / all);
}

/// The rows of a station that do not ask anything.
void against_layer(Findings& findings, std::string const& name, Fluid fluid, Found const& found) {
  fluid.elastic.E = E;
  double const mu = found.of.at("at_mobilised_friction"), mass = found.of.at("at_mass");
  SteadyLayer const exact({{fluid, std::atan(mu), mass / (fluid.density * length)}, 0});
  findings.note(name, "surface speed over that of the layer", found.of.at("at_surface_speed") / exact.surface(),
                "not steady, and particles crowd", found.cost);
  findings.note(name, "error of the profile", error_of(found, exact), "not steady, and particles crowd");
  findings.note(name, "solid fraction over that of the layer", found.of.at("at_solid_fraction") / exact.solid_fraction,
                "by the particles' volumes");
  findings.note(name, "volumes of the particles over that of the depth",
                mass * found.of.at("at_volume_ratio") / (fluid.density * length * found.of.at("at_depth")),
                "1: they do not crowd");
  std::vector<double> u;
  for (double const below : found.below) u.push_back(exact.speed(below));
  findings.plots.push_back({name,
                            "share of the mass below",
                            "u [m/s]",
                            false,
                            false,
                            {Curve{"bins", found.below, found.u}, Curve{"layer", found.below, u, true}}});
}

void without_cohesion(Findings& findings) {
  Inflow const flow{"inflow_24.json", 24, 0, 4, 1.4, 1.5};
  Found const found = found_by(flow, evenly(6, 7, 20));
  std::string const name = "24 deg, 1.5 m from the gate, 6 to 7 s";
  findings.check(name, "mean friction over tan(slope)", found.of.at("at_mobilised_friction") / tangent(flow.slope),
                 about(1, 0.02), "2 %; still slowing down");
  against_layer(findings, name, glass_beads(32.76, 0), found);
}

void with_cohesion(Findings& findings) {
  double before = std::numeric_limits<double>::infinity();
  for (double const beta : {0.0, 0.05, 0.1}) {
    Inflow const flow{"inflow_cohesive_32.json", 32, beta, 3, 0.48, 0.5};
    Found const found = found_by(flow, evenly(1.6, 2, 10));
    double const speed = found.of.at("at_surface_speed");
    std::string const name = fmt::format("32 deg, beta = {}, 0.5 m from the gate, 1.6 to 2 s", beta);
    if (beta > 0)
      findings.check(name, "surface speed over that with less cohesion", speed / before, at_most(0.99), "falls");
    findings.note(name, "mean friction over tan(slope)", found.of.at("at_mobilised_friction") / tangent(32));
    against_layer(findings, name, glass_beads(40, beta), found);
    before = speed;
  }
}

void run(Findings& findings) {
  without_cohesion(findings);
  with_cohesion(findings);
}

}  // namespace

Case const the_case{"flow/inflow",
                    "Inflow through a gate onto a rough slope",
                    "compressible layer of the mass and friction that a station finds, by quadrature",
                    "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figures 5, 6, 7 and 16",
                    2,
                    900,
                    run};

}  // namespace talus::verification::flow_inflow
