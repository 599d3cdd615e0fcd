#include "core/experiment_of.hpp"

namespace talus {

template class ExperimentOf<2>;
template class ExperimentOf<3>;

}  // namespace talus
