#include "benchmarks/peak.hpp"

#include <benchmark/benchmark.h>

#include <array>

#include "benchmarks/timing/clock.hpp"
#include "core/pack.hpp"

namespace talus::bench {

namespace {

/// a_k <- a_k x + y for twelve independent a_k: more than two units with a latency of four or five cycles can take, and
/// with x and y no more than 16 registers hold. x and y are unknown to the compiler and the sum of all is used, so that
/// nothing can be left out.
[[gnu::noinline]] double multiply_and_add(long loops, double factor, double summand) {
  constexpr int chains = 12;
  using P = Pack<4>;
  std::array<P, chains> a;
  for (int k = 0; k < chains; ++k) a[static_cast<std::size_t>(k)] = P(1 + 0.01 * k);
  P const x(factor), y(summand);
  for (long n = 0; n < loops; ++n)
    for (P& one : a) one = one * x + y;
  P sum(0.0);
  for (P const& one : a) sum += one;
  return sum[0] + sum[1] + sum[2] + sum[3];
}

}  // namespace

Estimate peak_flops(int repeats) {
  constexpr long loops = 1'000'000;
  constexpr double flops = 2.0 * 4 * 12 * loops;
  double factor = 0.999, summand = 0.001;
  std::vector<double> rates;
  for (int k = 0; k < repeats; ++k) {
    benchmark::DoNotOptimize(factor);
    benchmark::DoNotOptimize(summand);
    double const begin = seconds(Clock::thread);
    double result = multiply_and_add(loops, factor, summand);
    double const time = seconds(Clock::thread) - begin;
    benchmark::DoNotOptimize(result);
    rates.push_back(flops / time);
  }
  return estimate(rates);
}

}  // namespace talus::bench
