/// What it costs that kernels are chosen at run time, one block at a time.

#include <fmt/format.h>

#include "benchmarks/registry.hpp"
#include "benchmarks/scenes/whole_step.hpp"
#include "benchmarks/timing/paired.hpp"
#include "core/parallel.hpp"

namespace talus::bench {

namespace {

template <int D, class K>
void compare(std::string const& name, Options const& options, Table& table) {
  say("fused: " + name);
  set_thread_count(1);
  Filling filling;
  filling.particles = options.particles_or(filling.particles);
  filling.a_cell = D == 2 ? 6 : 8;
  WholeStep<D, K> step(block<D>(filling));
  auto const times =
      take_turns({{"fused", [&] { return step.fused(), false; }}, {"by block", [&] { return step.by_block(), false; }}},
                 {.count = options.repeats_or(25), .slice = 0.05});
  auto const ns = [&](Course const& course) {
    return fmt::format("{:.1f}", 1e9 / step.particles() * estimate(course).median);
  };
  table.rows.push_back(
      {name, "×", ratio(times[1], times[0]), Bar{.most = 1.07, .stretch = 1.03}, {ns(times[1]), ns(times[0])}});
}

}  // namespace

Result fused(Options const& options) {
  Table table{"A step of three kernels a block over one fused kernel, elastic APIC, one thread",
              {"by block [ns]", "fused [ns]"}};
  compare<3, kernel::Quadratic>("3-D quadratic", options, table);
  compare<3, kernel::Cubic>("3-D cubic", options, table);
  compare<2, kernel::Quadratic>("2-D quadratic", options, table);
  compare<2, kernel::Cubic>("2-D cubic", options, table);
  table.notes = {
      "Both load a block's nodes, gather, strain, stress and scatter its particles and add its arena to the grid, and "
      "move the nodes with their walls; the time step, the sort and the checks of a particle's state are left out."};
  return {{table}, {}};
}

}  // namespace talus::bench
