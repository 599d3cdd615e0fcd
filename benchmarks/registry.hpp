#pragma once
/// The benchmarks there are.

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "benchmarks/report/result.hpp"

namespace talus::bench {

/// What the user may change.
struct Options {
  int repeats = 0;            ///< 0: as many as each benchmark thinks right
  std::size_t particles = 0;  ///< 0: likewise
  int threads = 2;            ///< that are compared with one
  std::string filter;         ///< rows whose name it is found in (regular expression); for those that say so
  bool update_baseline = false;

  [[nodiscard]] int repeats_or(int usual) const { return repeats > 0 ? repeats : usual; }
  [[nodiscard]] std::size_t particles_or(std::size_t usual) const { return particles > 0 ? particles : usual; }
};

/// A benchmark cannot run here: a program that it needs is missing.
struct Unavailable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Benchmark {
  std::string_view name, what;
  int seconds;  ///< that it takes, about
  Result (*run)(Options const&);
};

[[nodiscard]] std::span<Benchmark const> benchmarks();

/// Tells people how far it is, on standard error.
void say(std::string_view line);

Result limits(Options const&);
Result stages(Options const&);
Result ratios(Options const&);
Result threads(Options const&);
Result sparse(Options const&);
Result size(Options const&);
Result fused(Options const&);
Result instructions(Options const&);

}  // namespace talus::bench
