#include "verification/suite/dam_break.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "core/io/files.hpp"
#include "verification/suite/places.hpp"

namespace talus::verification {

Document dam_break(int n, int per_axis) {
  std::string const file = std::string(studies) + "/dam_break_22.json";
  Document document = parse(io::read_file(file), file);
  double const h = heap_height / n;
  set_value(document, fmt::format("/grid/spacing={}", h));
  set_value(document, fmt::format("/bodies/0/shape/min=[0, {}]", h / 2));
  set_value(document, fmt::format("/bodies/0/shape/max=[0.2, {}]", heap_height + h / 2));
  set_value(document, fmt::format(R"(/bodies/0/seeding={{"type": "lattice", "per_axis": {}}})", per_axis));
  return document;
}

Ran run_to(Document const& document, double end, std::vector<std::string> const& measures, Cost& cost) {
  Composed const composed = program().compose(document);
  Experiment& experiment = *composed.experiment;
  auto const begun = std::chrono::steady_clock::now();
  while (experiment.time() < end) experiment.advance(end);
  cost += {std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count(), experiment.steps(),
           double(experiment.steps()) * double(experiment.particles())};
  auto const quantities = experiment.quantities();
  auto const all = experiment.measure();
  Ran ran{{}, experiment.balances()};
  for (std::string const& name : measures) {
    auto const at = std::find_if(quantities.begin(), quantities.end(), [&](auto const& q) { return q.name == name; });
    ran.values.push_back(all[static_cast<std::size_t>(at - quantities.begin())]);
  }
  return ran;
}

}  // namespace talus::verification
