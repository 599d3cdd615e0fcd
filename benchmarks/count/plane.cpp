#include "benchmarks/count/rungs.hpp"

namespace talus::bench {

void add_plane(std::vector<Rung>& rungs) {
  add_ladder<2>(rungs);
}

}  // namespace talus::bench
