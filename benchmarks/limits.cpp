/// What the machine can do at most: the roofs that rates are compared with.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <barrier>
#include <cstdint>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "benchmarks/peak.hpp"
#include "benchmarks/registry.hpp"
#include "benchmarks/timing/clock.hpp"

namespace talus::bench {

namespace {

/// Runs `work` on several threads at once, again and again; gives the wall time of each round [s].
std::vector<double> together(int threads, int rounds, std::function<void(int)> const& work) {
  std::vector<double> times;
  std::barrier gate(threads);
  auto const run = [&](int thread) {
    work(thread);
    for (int k = 0; k < rounds; ++k) {
      gate.arrive_and_wait();
      double const begin = seconds(Clock::wall);
      work(thread);
      gate.arrive_and_wait();
      if (thread == 0) times.push_back(seconds(Clock::wall) - begin);
    }
  };
  std::vector<std::jthread> others;
  for (int t = 1; t < threads; ++t) others.emplace_back(run, t);
  run(0);
  return times;
}

/// Three arrays of one thread.
struct Arrays {
  std::vector<double> a, b, c;
  explicit Arrays(std::size_t n) : a(n, 0.0), b(n, 1.0), c(n, 2.0) {}
};

/// a <- b + s c, `passes` times.
[[gnu::noinline]] void triad(Arrays& arrays, double s, long passes) {
  double *a = arrays.a.data(), *b = arrays.b.data(), *c = arrays.c.data();
  std::size_t const n = arrays.a.size();
  for (long p = 0; p < passes; ++p) {
    for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + s * c[i];
    benchmark::ClobberMemory();
  }
}

/// Bytes that the triad names, 24 an element; what is read before it is overwritten is not counted [GB/s].
Estimate bandwidth(int threads, std::size_t bytes, double total, int rounds) {
  std::size_t const n = bytes / (3 * sizeof(double));
  long const passes = std::max(1L, static_cast<long>(total / static_cast<double>(bytes)));
  std::vector<std::unique_ptr<Arrays>> arrays(static_cast<std::size_t>(threads));
  auto const work = [&](int thread) {
    auto& own = arrays[static_cast<std::size_t>(thread)];
    if (!own) own = std::make_unique<Arrays>(n);
    triad(*own, 3, passes);
  };
  std::vector<double> rates;
  for (double const time : together(threads, rounds, work))
    rates.push_back(1e-9 * threads * static_cast<double>(passes) * static_cast<double>(n) * 24 / time);
  return estimate(rates);
}

}  // namespace

Result limits(Options const& options) {
  int const rounds = options.repeats_or(15);
  Table table{"What the machine can do at most", {"how"}};
  table.rows.push_back({"FMA in double, 1 thread",
                        "GFLOP/s",
                        scaled(peak_flops(3 * rounds), 1e-9),
                        {},
                        {"packs of 4, 12 independent chains, thread time"}});
  auto const both = together(options.threads, 3 * rounds, [](int) { static_cast<void>(peak_flops(1)); });
  std::vector<double> rates;
  for (double const time : both) rates.push_back(96e-3 * options.threads / time);
  table.rows.push_back(
      {fmt::format("FMA in double, {} threads", options.threads), "GFLOP/s", estimate(rates), {}, {"wall time"}});
  struct Memory {
    std::string name;
    std::size_t bytes;
    double total;
  };
  for (Memory const& memory : {Memory{"DRAM", 384U << 20U, 3e8}, Memory{"L2", 192U << 10U, 3e8}})
    for (int const threads : {1, options.threads})
      table.rows.push_back({fmt::format("triad from {}, {} thread{}", memory.name, threads, threads > 1 ? "s" : ""),
                            "GB/s",
                            bandwidth(threads, memory.bytes, memory.total, rounds),
                            {},
                            {fmt::format("{} KiB a thread, wall time", memory.bytes / 1024)}});
  table.notes = {
      "Bytes of the triad a = b + s c are 24 an element; that a line is read before it is written is not "
      "counted."};
  return {{table}};
}

}  // namespace talus::bench
