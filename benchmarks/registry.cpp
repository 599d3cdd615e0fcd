#include "benchmarks/registry.hpp"

#include <fmt/format.h>

#include <array>

namespace talus::bench {

std::span<Benchmark const> benchmarks() {
  static constexpr std::array list{
      Benchmark{"limits", "what the machine can do: fused multiply-adds, memory bandwidth", 5, limits},
      Benchmark{"stages", "each stage of a step on prepared blocks, in 2-D and 3-D, quadratic and cubic", 10, stages},
      Benchmark{"ratios", "Talus against the textbook solver; transfers, integrators and plastic flow", 160, ratios},
      Benchmark{"threads", "several threads against one, and whether they give the same bits", 25, threads},
      Benchmark{"sparse", "two heaps 1000 cells apart against two heaps side by side", 20, sparse},
      Benchmark{"size", "cost of a particle-step from 20 000 to 2 000 000 particles, and of sorting", 60, size},
      Benchmark{"fused", "a step of kernels chosen at run time, block by block, against one fused kernel", 25, fused},
      Benchmark{"instructions", "instructions of a particle-step, counted by callgrind, against the baseline", 180,
                instructions},
  };
  return list;
}

void say(std::string_view line) {
  fmt::print(stderr, "bench: {}\n", line);
}

}  // namespace talus::bench
