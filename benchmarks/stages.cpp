/// The stages of a step by themselves, timed by Google Benchmark.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>

#include "benchmarks/registry.hpp"
#include "benchmarks/scenes/prepared.hpp"

namespace talus::bench {

namespace {

/// Nanoseconds a particle of every repetition, by the name of the row.
class Collect final : public benchmark::BenchmarkReporter {
 public:
  std::map<std::string, std::vector<double>> values;

  bool ReportContext(Context const&) override { return true; }
  void ReportRuns(std::vector<Run> const& runs) override {
    for (Run const& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      auto const at = run.counters.find("particles");
      if (at == run.counters.end()) continue;
      values[run.run_name.function_name].push_back(run.GetAdjustedCPUTime() / at->second.value);
    }
  }
};

/// The stages to be timed, registered with Google Benchmark under their names, in this order.
class Catalogue {
 public:
  std::vector<std::string> names;

  /// `stage` on the blocks of `prepared`, which lives as long as the registration.
  template <int D>
  void add(std::string const& name, std::shared_ptr<Prepared<D>> prepared, void (Prepared<D>::*stage)()) {
    names.push_back(name);
    benchmark::RegisterBenchmark(name.c_str(), [prepared, stage](benchmark::State& state) {
      for (auto _ : state) ((*prepared).*stage)();
      state.counters["particles"] = static_cast<double>(prepared->particles());
    });
  }
};

template <Formulation F>
auto prepare() {
  constexpr int D = F::Kinematics::dimension;
  Filling filling;
  filling.particles = D == 2 ? 1536 : 4096;  // 4 x 4 and 2 x 2 x 2 blocks
  filling.a_cell = D == 2 ? 6 : 8;
  auto const cloud = block<D>(filling);
  return std::make_shared<Prepared<D>>(simulate<F>(setup<F>(cloud.spacing), {cloud}, corner<D>(cloud.low)));
}

template <int D, class K>
void add_transfers(Catalogue& stages, std::string const& where) {
  auto const apic = prepare<Of<D, K>>();
  auto const aflip = prepare<Of<D, K, transfer::Aflip>>();
  stages.add(where + ", particles to grid, APIC", apic, &Prepared<D>::scatter);
  stages.add(where + ", particles to grid, AFLIP", aflip, &Prepared<D>::scatter);
  stages.add(where + ", grid to particles, APIC", apic, &Prepared<D>::gather);
  stages.add(where + ", grid to particles, AFLIP", aflip, &Prepared<D>::gather);
  stages.add(where + ", add, move and load, APIC", apic, &Prepared<D>::grid_pass);
  stages.add(where + ", sort", apic, &Prepared<D>::sort);
}

template <int D, class L>
void add_law(Catalogue& stages, std::string const& name) {
  auto const prepared = prepare<Of<D, kernel::Quadratic, transfer::Apic, L>>();
  prepared->shear(0, 0);
  stages.add(name + ", stress", prepared, &Prepared<D>::load);
  stages.add(name + ", trial strain and return map, at rest", prepared, &Prepared<D>::law);
  if constexpr (L::State::count > 0) {
    auto const sheared = prepare<Of<D, kernel::Quadratic, transfer::Apic, L>>();
    sheared->shear(1e-5, -1e-5);  // under pressure first, then on at constant volume
    for (int k = 0; k < 300; ++k) sheared->law();
    sheared->shear(1e-4, 0);
    for (int k = 0; k < 300; ++k) sheared->law();
    stages.add(name + ", trial strain and return map, flowing", sheared, &Prepared<D>::law);
  }
}

template <int D>
void add_laws(Catalogue& stages, std::string const& where) {
  add_law<D, law::Hencky>(stages, where + ", Hencky");
  add_law<D, law::DruckerPrager>(stages, where + ", Drucker-Prager");
  add_law<D, law::CamClay>(stages, where + ", Cam-Clay");
  add_law<D, law::CamClayMuI>(stages, where + ", Cam-Clay mu(I)");
}

/// Google Benchmark takes its options from a command line.
void start(int repeats) {
  std::vector<std::string> words{"talus-bench", "--benchmark_min_time=0.01",
                                 fmt::format("--benchmark_repetitions={}", repeats),
                                 "--benchmark_enable_random_interleaving=true"};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
}

/// The transfers and the grid's part, side by side for every dimension and kernel.
Chart chart_of(std::map<std::string, std::vector<double>> const& values) {
  Chart chart{"stages", "Cost of the stages of a step, APIC", "", "ns a particle"};
  chart.labels = {"2-D quadratic", "2-D cubic", "3-D quadratic", "3-D cubic"};
  for (std::string const stage : {"particles to grid, APIC", "grid to particles, APIC", "add, move and load, APIC"}) {
    Curve curve{stage};
    for (std::string const& label : chart.labels) {
      auto const found = values.find(label + ", " + stage);
      curve.y.push_back(found == values.end() ? std::nan("") : estimate(found->second).median);
    }
    chart.curves.push_back(curve);
  }
  return chart;
}

}  // namespace

Result stages(Options const& options) {
  set_thread_count(1);
  Catalogue all;
  add_transfers<2, kernel::Quadratic>(all, "2-D quadratic");
  add_transfers<2, kernel::Cubic>(all, "2-D cubic");
  add_transfers<3, kernel::Quadratic>(all, "3-D quadratic");
  add_transfers<3, kernel::Cubic>(all, "3-D cubic");
  add_laws<2>(all, "2-D");
  add_laws<3>(all, "3-D");
  start(options.repeats_or(11));
  Collect collect;
  benchmark::RunSpecifiedBenchmarks(&collect, options.filter.empty() ? "." : options.filter);
  benchmark::ClearRegisteredBenchmarks();
  Table table{"Cost of each stage by itself, blocks in the near cache, one thread"};
  for (std::string const& name : all.names)
    if (auto const found = collect.values.find(name); found != collect.values.end())
      table.rows.push_back({name, "ns a particle", estimate(found->second)});
  table.notes = {
      "Thread time, by Google Benchmark, the stages interleaved at random. 'at rest': no strain comes; "
      "'flowing': every particle has been compressed and is sheared by 1e-4 a call. The sort also makes the arenas "
      "anew."};
  return {{table}, {chart_of(collect.values)}};
}

}  // namespace talus::bench
