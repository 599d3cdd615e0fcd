/// Whether a particle costs the same in every crowd.

#include <fmt/format.h>

#include "benchmarks/registry.hpp"
#include "benchmarks/scenes/compete.hpp"
#include "benchmarks/scenes/compose.hpp"
#include "benchmarks/scenes/formulations.hpp"

namespace talus::bench {

namespace {

using F = Of<3, kernel::Quadratic>;

auto scene(std::size_t particles) {
  Filling filling;
  filling.particles = particles;
  auto const cloud = block<3>(filling);
  return simulate<F>(setup<F>(cloud.spacing), {cloud}, corner<3>(cloud.low));
}

/// Scenes of all sizes, timed in turns, with what their sorts cost.
struct Crowds {
  std::vector<std::unique_ptr<Simulation<3>>> simulations;
  std::vector<SortCost> sorts;
  std::vector<Course> times;
  explicit Crowds(Options const& options) {
    set_thread_count(1);
    std::vector<Competitor> competitors;
    for (std::size_t const particles : {20'000, 63'000, 200'000, 630'000, 2'000'000}) {
      say(fmt::format("size: setting {} particles up", particles));
      simulations.push_back(scene(particles));
      sorts.push_back(measure_sort(*simulations.back(), Clock::thread, 6));
      competitors.push_back(competitor("", *simulations.back()));
    }
    say("size: timing them in turns");
    times = take_turns(competitors, {.count = options.repeats_or(11), .slice = 0.1});
  }
  [[nodiscard]] double particles(std::size_t k) const {
    return static_cast<double>(simulations[k]->particles().count());
  }
};

/// Cost of a particle-step of size k over the mean of all sizes, round by round.
Estimate over_mean(Crowds const& crowds, std::size_t k) {
  std::vector<double> values;
  for (std::size_t round = 0; round < crowds.times[k].size(); ++round) {
    double mean = 0;
    for (std::size_t j = 0; j < crowds.times.size(); ++j)
      mean += crowds.times[j][round] / crowds.particles(j) / static_cast<double>(crowds.times.size());
    values.push_back(crowds.times[k][round] / crowds.particles(k) / mean);
  }
  return estimate(values);
}

}  // namespace

Result size(Options const& options) {
  Crowds const crowds(options);
  Table cost{"Cost of a particle-step, 3-D quadratic, elastic APIC with walls and sorts, one thread"};
  Table even{"The same over the mean of all sizes"};
  Table sorts{"Share of time that goes into sorting", {"one sort [ns a particle]", "steps between sorts"}};
  Curve curve{"measured"};
  for (std::size_t k = 0; k < crowds.times.size(); ++k) {
    double const particles = crowds.particles(k);
    std::string const name = fmt::format("{:.0f} particles", particles);
    Estimate const ns = scaled(estimate(crowds.times[k]), 1e9 / particles);
    SortCost const& sort = crowds.sorts[k];
    cost.rows.push_back({name, "ns", ns});
    even.rows.push_back({name, "×", over_mean(crowds, k), Bar{.least = 0.9, .most = 1.1}});
    sorts.rows.push_back(
        {name,
         "%",
         exactly(100 * sort.per_step() / estimate(crowds.times[k]).median),
         Bar{.most = 3},
         {fmt::format("{:.1f}", 1e9 * sort.seconds / particles), fmt::format("{:.0f}", sort.steps_between)}});
    curve.x.push_back(particles);
    curve.y.push_back(ns.median);
    curve.low.push_back(1e9 / particles * quantile(crowds.times[k], 0.25));
    curve.high.push_back(1e9 / particles * quantile(crowds.times[k], 0.75));
  }
  sorts.notes = {
      "One sort: what it takes, with the making of the grid and the step after it, more than a usual step. Steps "
      "between "
      "sorts follow from the largest speed: particles may drift half a cell."};
  return {{cost, even, sorts},
          {{"size",
            "Cost of a particle-step by number of particles",
            "particles",
            "ns a particle-step",
            {},
            {curve},
            {},
            true}}};
}

}  // namespace talus::bench
