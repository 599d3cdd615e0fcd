#include "core/experiment_balances.hpp"
#include "core/experiment_explain.hpp"
#include "core/experiment_measure.hpp"
#include "core/experiment_restore.hpp"

namespace talus {

template class ExperimentOf<2>;
template class ExperimentOf<3>;

}  // namespace talus
