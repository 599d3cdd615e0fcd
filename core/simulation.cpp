#include "core/simulation.hpp"

namespace talus {

template class Simulation<2>;
template class Simulation<3>;

}  // namespace talus
