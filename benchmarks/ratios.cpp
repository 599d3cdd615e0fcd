/// Talus against the textbook solver, and its parts against each other.

#include <fmt/format.h>

#include <random>
#include <utility>

#include "benchmarks/flow.hpp"
#include "benchmarks/naive/solver.hpp"
#include "benchmarks/naive/splines.hpp"
#include "benchmarks/peak.hpp"
#include "benchmarks/registry.hpp"
#include "benchmarks/scenes/compete.hpp"
#include "benchmarks/scenes/compose.hpp"
#include "benchmarks/scenes/formulations.hpp"

namespace talus::bench {

namespace {

/// One dimension and kernel: what it should reach, and what it computes.
struct Setting {
  std::string name;
  double least, stretch;  ///< of the ratio to the baseline
  double flops;           ///< a particle-step, counted by hand; 0: not counted
};

/// What the settings fill.
struct Tables {
  Table baseline{"Talus over the textbook solver, elastic APIC with walls and sorts, one thread",
                 {"fastest slices", "over the baseline in the order of the lattice", "fastest slices"}};
  Table parts{"Rates of other parts over elastic APIC, one thread"};
  Table rates{"Cost of a particle-step, elastic APIC with walls and sorts, one thread",
              {"M particle-steps/s", "baseline [ns]", "in the order of the lattice [ns]", "share of FMA peak",
               "share of sorts", "particles"}};
};

template <int D>
Cloud<D> scene(Options const& options) {
  Filling filling;
  filling.particles = options.particles_or(filling.particles);
  filling.a_cell = D == 2 ? 6 : 8;
  return block<D>(filling);
}

template <Formulation F, int D>
auto elastic(Cloud<D> const& cloud) {
  return simulate<F>(setup<F>(cloud.spacing), {cloud}, corner<D>(cloud.low));
}

/// The same particles in an arbitrary order: what flow leaves of any order in a solver that never sorts.
template <int D>
Cloud<D> mixed(Cloud<D> cloud) {
  std::mt19937_64 random(7);
  for (std::size_t k = cloud.count() - 1; k > 0; --k) {
    std::size_t const other = std::uniform_int_distribution<std::size_t>(0, k)(random);
    std::swap(cloud.places[k], cloud.places[other]);
    std::swap(cloud.velocities[k], cloud.velocities[other]);
  }
  return cloud;
}

/// The baseline, with the time step that Talus takes.
template <class Spline, int D>
naive::Solver<D, Spline> baseline(Cloud<D> const& cloud) {
  law::Hencky const law(law::Hencky::Parameters{});
  return {cloud, {density, law.lambda, law.G}, down<D>()};
}

template <int D, class K, class Spline>
void against_baseline(Setting const& setting, Cloud<D> const& cloud, Options const& options, double peak,
                      Tables& tables) {
  using F = Of<D, K>;
  auto talus = elastic<F>(cloud);
  set_thread_count(1);
  auto const sort = measure_sort(*talus, Clock::thread);
  auto naive = baseline<Spline>(mixed(cloud)), ordered = baseline<Spline>(cloud);
  double const dt = talus->next(1).dt, particles = static_cast<double>(cloud.count());
  std::vector<Competitor> const all{{"baseline", [&naive, dt] { return naive.step(dt), false; }},
                                    competitor("Talus", *talus),
                                    {"ordered", [&ordered, dt] { return ordered.step(dt), false; }}};
  auto const times = take_turns(all, {.count = options.repeats_or(25), .slice = 0.1});
  tables.baseline.rows.push_back({setting.name,
                                  "×",
                                  ratio(times[0], times[1]),
                                  Bar{.least = setting.least, .stretch = setting.stretch},
                                  {fmt::format("{:.2f}", quantile(times[0], 0) / quantile(times[1], 0)),
                                   fmt::format("{:.2f}", ratio(times[2], times[1]).median),
                                   fmt::format("{:.2f}", quantile(times[2], 0) / quantile(times[1], 0))}});
  Estimate const ns = scaled(estimate(times[1]), 1e9 / particles);
  tables.rates.rows.push_back(
      {setting.name,
       "ns",
       ns,
       {},
       {fmt::format("{:.2f}", 1e3 / ns.median), fmt::format("{:.0f}", 1e9 / particles * estimate(times[0]).median),
        fmt::format("{:.0f}", 1e9 / particles * estimate(times[2]).median),
        setting.flops > 0 ? fmt::format("{:.0f} %", 100 * setting.flops / (1e-9 * ns.median) / peak) : "",
        fmt::format("{:.1f} %", 100 * sort.per_step() / estimate(times[1]).median), fmt::format("{}", cloud.count())}});
}

/// Rate of formulation F over that of elastic APIC.
template <class F, int D, class K>
Estimate rate_over_apic(Cloud<D> const& cloud, Options const& options) {
  auto apic = elastic<Of<D, K>>(cloud);
  auto other = elastic<F>(cloud);
  auto const times = take_turns({competitor("APIC", *apic), competitor("other", *other)},
                                {.count = options.repeats_or(41), .slice = 0.04});
  return ratio(times[0], times[1]);
}

template <int D, class K>
void parts(Setting const& setting, Cloud<D> const& cloud, Options const& options, Table& table) {
  auto const row = [&](std::string const& name, Estimate value, std::optional<Bar> bar = {}) {
    table.rows.push_back({setting.name + ": " + name, "×", value, bar});
  };
  row("AFLIP", rate_over_apic<Of<D, K, transfer::Aflip>, D, K>(cloud, options), Bar{.least = 0.8});
  row("FLIP", rate_over_apic<Of<D, K, transfer::Flip>, D, K>(cloud, options));
  row("MUSL", rate_over_apic<Of<D, K, transfer::Apic, law::Hencky, integrator::Musl>, D, K>(cloud, options));
  row("APIC itself (noise floor)", rate_over_apic<Of<D, K>, D, K>(cloud, options));
}

template <int D, class K, class Spline>
void measure(Setting const& setting, Options const& options, Tables& tables) {
  Cloud<D> const cloud = scene<D>(options);
  say(fmt::format("ratios: {}, {} particles", setting.name, cloud.count()));
  double const peak = peak_flops(15).median;
  against_baseline<D, K, Spline>(setting, cloud, options, peak, tables);
  parts<D, K>(setting, cloud, options, tables.parts);
}

}  // namespace

Result ratios(Options const& options) {
  Tables tables;
  measure<3, kernel::Quadratic, naive::Quadratic>({"3-D quadratic", 10, 14, 1800}, options, tables);
  measure<3, kernel::Cubic, naive::Cubic>({"3-D cubic", 12, 15, 3100}, options, tables);
  measure<2, kernel::Quadratic, naive::Quadratic>({"2-D quadratic", 5.5, 8, 450}, options, tables);
  measure<2, kernel::Cubic, naive::Cubic>({"2-D cubic", 6.5, 8, 0}, options, tables);
  tables.rates.notes = {
      "Flops are counted by hand for the algorithm: 1800 (3-D quadratic), 3100 (3-D cubic), 450 "
      "(2-D quadratic) a particle-step; the peak is that of packs of four doubles, measured in the same sitting."};
  tables.baseline.notes = {
      "Paired: slices of 0.1 s at least in turns, the ratio of each pair, median of the ratios. A core that is shared "
      "with another virtual machine slows a solver that keeps its units busy more than one that waits: beside the "
      "median "
      "stands the ratio of the fastest slice of each.",
      "The baseline's particles are in an arbitrary order, as in a textbook solver once its material has flowed: it "
      "never sorts. The last column is against the same solver with particles that still lie in the order of the "
      "lattice."};
  Chart chart{"ratios", "Talus over the textbook solver", "", "ratio of times"};
  Curve measured{"measured"}, wanted{"bar"};
  for (Row const& row : tables.baseline.rows) {
    chart.labels.push_back(row.name);
    measured.y.push_back(row.value.median);
    wanted.y.push_back(*row.bar->least);
  }
  chart.curves = {measured, wanted};
  return {{tables.baseline, tables.rates, tables.parts, flow(options)}, {chart}};
}

}  // namespace talus::bench
