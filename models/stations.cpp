#include "models/stations.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "models/case.hpp"

namespace talus {

namespace {

std::size_t number_of(AxisChoice const& choice) {
  return choice.visit([]<class A>(std::type_identity<A>, auto const&) { return A::number; });
}

/// phi_0 = rho/rho_s of each material; empty where a law does not tell the density of grains, as its parameter
/// `grain_density`.
std::vector<double> initial_fractions(Case const& document) {
  std::vector<double> fractions;
  for (MaterialEntry const& m : document.materials) {
    nlohmann::json parameters = nlohmann::json::object();
    m.law.write_parameters(parameters);
    auto const grains = parameters.find("grain_density");
    if (grains == parameters.end()) return {};
    fractions.push_back(m.density / grains->get<double>());
  }
  return fractions;
}

/// Mistakes of one station; `where` points at it.
void check_station(StationEntry const& entry, std::string const& where, Case const& document, int D,
                   std::vector<std::string>& wrong) {
  static std::regex const allowed("[A-Za-z][A-Za-z0-9_]*");
  if (!std::regex_match(entry.name, allowed))
    wrong.push_back(where + "/name: '" + entry.name + "'; a letter, then letters, digits and _ are allowed");
  std::size_t const flow = number_of(entry.flow), depth = number_of(entry.depth);
  for (auto const& [member, axis] : {std::pair{"/flow", flow}, std::pair{"/depth", depth}})
    if (axis >= static_cast<std::size_t>(D)) wrong.push_back(where + member + ": there is no third axis in the plane");
  if (flow == depth) wrong.push_back(where + "/depth: is the axis of the flow; it must be another one");
  auto const& periods = document.grid.periods;
  for (std::size_t d = 0; d < static_cast<std::size_t>(D); ++d) {
    std::string const pointer = where + "/max/" + std::to_string(d);
    double const length = entry.max[d] - entry.min[d];
    if (!(length > 0))
      wrong.push_back(pointer + ": " + std::to_string(entry.max[d]) + " m; more than the " +
                      std::to_string(entry.min[d]) + " m of min is needed");
    if (d < periods.size() && periods[d] > 0 && length > periods[d] * (1 + 1e-9))
      wrong.push_back(pointer + ": the station is " + std::to_string(length) + " m long; at most the period of " +
                      std::to_string(periods[d]) + " m is allowed");
  }
}

}  // namespace

std::vector<Station> stations_of(Case const& document) {
  std::vector<Station> stations;
  for (StationEntry const& entry : document.output.stations) {
    Station station{
        entry.name, entry.min.values,           entry.max.values, number_of(entry.flow), number_of(entry.depth),
        1,          initial_fractions(document)};
    bool const exists = station.depth < station.low.size();
    double const cells = exists ? station.extent(station.depth) / document.grid.spacing : 1;
    station.bins = static_cast<int>(entry.bins.value_or(std::llround(std::clamp(cells, 1.0, 1e5))));
    stations.push_back(std::move(station));
  }
  return stations;
}

void check_stations(Case const& document, int D, std::vector<std::string>& wrong) {
  std::set<std::string> seen;
  for (std::size_t k = 0; k < document.output.stations.size(); ++k) {
    StationEntry const& entry = document.output.stations[k];
    std::string const where = "/output/stations/" + std::to_string(k);
    if (!seen.insert(entry.name).second)
      wrong.push_back(where + "/name: '" + entry.name + "' is used twice; every name must be its own");
    check_station(entry, where, document, D, wrong);
  }
}

}  // namespace talus
