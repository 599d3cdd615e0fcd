/// What empty space costs: nothing, it should be.

#include <fmt/format.h>

#include "benchmarks/registry.hpp"
#include "benchmarks/scenes/compete.hpp"
#include "benchmarks/scenes/compose.hpp"
#include "benchmarks/scenes/formulations.hpp"
#include "benchmarks/scenes/memory.hpp"

namespace talus::bench {

namespace {

template <int D>
using F = Of<D, kernel::Quadratic>;

/// A scene, and by how much it raised the highest memory of the process [bytes].
template <int D>
struct Built {
  std::unique_ptr<Simulation<D>> simulation;
  double memory;
};

/// Two heaps on one floor, with a gap of so many cells along every other axis.
template <int D>
Built<D> two_heaps(Options const& options, int gap) {
  Filling filling;
  filling.particles = options.particles_or(100'000) / 2;
  filling.a_cell = D == 2 ? 6 : 8;
  auto const near = block<D>(filling);
  // whole blocks away, so that both heaps lie in their blocks as the first one does
  double const size = block_edge * std::ceil((near.high[0] / filling.spacing + gap) / block_edge) * filling.spacing;
  Point<D> place = Point<D>::Constant(size);
  place[1] = 0;
  auto const far = block<D>(filling, place);
  auto const before = forget_peak();
  auto simulation = simulate<F<D>>(setup<F<D>>(filling.spacing), {near, far}, corner<D>(near.low));
  for (int k = 0; k < 3; ++k) advance(*simulation);
  return {std::move(simulation), static_cast<double>(peak_since() - before)};
}

template <int D>
void measure(Options const& options, Table& table) {
  say(fmt::format("sparse: {}-D", D));
  set_thread_count(1);
  static_cast<void>(two_heaps<D>(options, 8));  // what the first one of all needs besides
  auto near = two_heaps<D>(options, 8), far = two_heaps<D>(options, 1000);
  auto const times = take_turns({competitor("far", *far.simulation), competitor("near", *near.simulation)},
                                {.count = options.repeats_or(31), .slice = 0.05});
  auto const row = [&](std::string const& what, Estimate value, std::string const& side, std::string const& apart) {
    table.rows.push_back({fmt::format("{}-D: {}", D, what), "×", value, Bar{.most = 1.05}, {side, apart}});
  };
  double const particles = static_cast<double>(near.simulation->particles().count());
  auto const ns = [&](Course const& course) {
    return fmt::format("{:.1f} ns", 1e9 * estimate(course).median / particles);
  };
  auto const mebibytes = [](double bytes) { return fmt::format("{:.1f} MiB", bytes / 1048576); };
  row("time of a particle-step", ratio(times[0], times[1]), ns(times[1]), ns(times[0]));
  double const a = static_cast<double>(near.simulation->bytes()), b = static_cast<double>(far.simulation->bytes());
  row("memory of particles and nodes", exactly(b / a), mebibytes(a), mebibytes(b));
  row("growth of the process at its peak", exactly(far.memory / near.memory), mebibytes(near.memory),
      mebibytes(far.memory));
}

}  // namespace

Result sparse(Options const& options) {
  Table table{"Two heaps 1000 cells apart over the same two heaps 8 cells apart, elastic APIC, one thread",
              {"side by side", "far apart"}};
  measure<2>(options, table);
  measure<3>(options, table);
  return {{table}};
}

}  // namespace talus::bench
