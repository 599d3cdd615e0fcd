#include "benchmarks/count/rungs.hpp"

namespace talus::bench {

void add_solid(std::vector<Rung>& rungs) {
  add_ladder<3>(rungs);
}

}  // namespace talus::bench
