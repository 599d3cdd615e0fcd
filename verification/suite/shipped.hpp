#pragma once
/// Shipped documents with some things changed, run to given times.

#include <chrono>
#include <string>
#include <vector>

#include "core/cli/program.hpp"
#include "verification/suite/findings.hpp"

namespace talus::verification {

/// A document of verification/studies; `changes` in the words of --set.
[[nodiscard]] Document shipped(std::string const& study, std::vector<std::string> const& changes);

/// Runs to each of the times [s], in order, and calls f there; adds to the cost what the steps and f took.
template <class F>
void visit_times(Experiment& experiment, std::vector<double> const& times, Cost& cost, F const& f) {
  auto const begun = std::chrono::steady_clock::now();
  for (double const t : times) {
    while (experiment.time() < t) experiment.advance(t);
    f();
  }
  cost += {std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count(), experiment.steps(),
           double(experiment.steps()) * double(experiment.particles())};
}

}  // namespace talus::verification
