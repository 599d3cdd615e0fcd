/// A layer without rate dependence on a slope, which stops or speeds up: closed form against the elastic, perfectly
/// plastic layer in implicit steps by KINSOL.

#include <fmt/format.h>

#include "verification/reference/flow/rate_independent.hpp"
#include "verification/suite/agreement.hpp"
#include "verification/suite/cases.hpp"

namespace talus::verification::flow_oracles_rate_independent {

namespace {

using namespace reference::flow;

constexpr double h = 0.05, U = 4, step = 0.0025;
constexpr int cells = 200;
std::vector<double> const times{0.1, 0.5, 1.0, 2.0, 2.5, 2.7, 2.75, 3.0};

/// Largest |u - u of the closed form| over U, above the lowest cell.
double distance(RateIndependentLayer const& layer, std::vector<std::vector<double>> const& states) {
  double most = 0;
  for (std::size_t t = 0; t < times.size(); ++t)
    for (std::size_t k = 1; k < states[t].size(); ++k) {
      double const y = layer.h * static_cast<double>(k) / static_cast<double>(states[t].size() - 1);
      most = std::max(most, std::abs(states[t][k] - layer.speed(y, times[t])) / layer.U);
    }
  return most;
}

void layer(Findings& findings, double angle) {
  RateIndependentLayer const layer{radians(28), h, tangent(angle), U};
  Fluid const beads = glass_beads(40, 0);
  std::string const name = fmt::format("friction of {} degrees", angle);
  findings.note(name, "acceleration [m/s^2]", layer.acceleration());
  if (layer.acceleration() < 0) findings.note(name, "comes to rest at [s]", layer.end());
  auto const soft = rate_independent_steps(layer, beads.density, beads.elastic.G(), cells, step, times);
  if (layer.acceleration() < 0) {
    findings.check(name, "u from closed form over U, E = 1 MPa", distance(layer, soft), at_most(1e-5),
                   "elastic shear of what comes to rest, whose speed is g(sin - mu cos) h/U over that of shear waves");
    auto const stiff = rate_independent_steps(layer, beads.density, 100 * beads.elastic.G(), cells, step, times);
    findings.check(name, "u from closed form over U, E = 100 MPa", distance(layer, stiff), at_most(1e-5), "as before");
  } else
    findings.check(name, "u from closed form over U", distance(layer, soft), at_most(1e-11), "all of it shears");
  Plot plot{"Without rate dependence: " + name, "u [m/s]", "y [m]", false, false, {}};
  for (std::size_t t = 0; t < times.size(); t += 2) {
    auto const exact = [&](double y) { return layer.speed(y, times[t]); };
    plot.curves.push_back(profile(fmt::format("closed form, t = {} s", times[t]), exact, places(1e-6, h, 101), true));
    plot.curves.push_back({fmt::format("KINSOL, t = {} s", times[t]), soft[t], places(0, h, cells + 1), false});
  }
  findings.plots.push_back(plot);
}

void run(Findings& findings) {
  layer(findings, 35);
  layer(findings, 21);
}

}  // namespace

Case const the_case{"flow/oracles_rate_independent",
                    "A layer without rate dependence stops or speeds up",
                    "closed form; elastic, perfectly plastic layer by KINSOL",
                    "problem: Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figure 31; closed form derived",
                    0,
                    10,
                    run};

}  // namespace talus::verification::flow_oracles_rate_independent
