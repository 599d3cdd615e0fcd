#include "core/log_strain.hpp"

namespace talus::detail {

template Strains<shape::Plane> by_principal_values(Strains<shape::Plane>, decltype(expm1_of));
template Strains<shape::Plane> by_principal_values(Strains<shape::Plane>, decltype(half_log1p_of));
template Strains<shape::Solid> by_principal_values(Strains<shape::Solid>, decltype(expm1_of));
template Strains<shape::Solid> by_principal_values(Strains<shape::Solid>, decltype(half_log1p_of));

}  // namespace talus::detail
