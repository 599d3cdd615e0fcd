#include "core/log_strain.hpp"

namespace talus::detail {

template Strains<shape::Plane> by_principal_values(Strains<shape::Plane>, Expm1);
template Strains<shape::Plane> by_principal_values(Strains<shape::Plane>, HalfLog1p);
template Strains<shape::Solid> by_principal_values(Strains<shape::Solid>, Expm1);
template Strains<shape::Solid> by_principal_values(Strains<shape::Solid>, HalfLog1p);

}  // namespace talus::detail
