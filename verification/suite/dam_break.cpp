#include "verification/suite/dam_break.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "verification/suite/shipped.hpp"

namespace talus::verification {

Document dam_break(int n, int per_axis) {
  double const h = heap_height / n;
  return shipped("dam_break_22.json",
                 {fmt::format("/grid/spacing={}", h), fmt::format("/bodies/0/shape/min=[0, {}]", h / 2),
                  fmt::format("/bodies/0/shape/max=[0.2, {}]", heap_height + h / 2),
                  fmt::format(R"(/bodies/0/seeding={{"type": "lattice", "per_axis": {}}})", per_axis)});
}

Ran run_to(Document const& document, double end, std::vector<std::string> const& measures, Cost& cost) {
  Composed const composed = program().compose(document);
  Experiment& experiment = *composed.experiment;
  visit_times(experiment, {end}, cost, [] {});
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
