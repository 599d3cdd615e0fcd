/// talus-count: runs one composition for a few steps, for callgrind to count them. Without a name it lists them all, a
/// line each: name, tab, the one that it adds to.

#include <cstdio>
#include <exception>

#include "benchmarks/count/rungs.hpp"

int main(int argc, char** argv) {
  using namespace talus;
  std::vector<bench::Rung> rungs;
  bench::add_plane(rungs);
  bench::add_solid(rungs);
  if (argc < 2) {
    for (auto const& rung : rungs) std::printf("%s\t%s\n", rung.name.c_str(), rung.base.c_str());
    return 0;
  }
  try {
    set_thread_count(1);
    for (auto const& rung : rungs) {
      if (rung.name != argv[1]) continue;
      auto const counted = rung.run();
      std::printf("%zu %d %d\n", counted.particles, counted.steps, counted.bytes);
      return 0;
    }
    std::fprintf(stderr, "talus-count: there is no '%s'\n", argv[1]);
  } catch (std::exception const& error) {
    std::fprintf(stderr, "talus-count: %s\n", error.what());
  }
  return 1;
}
