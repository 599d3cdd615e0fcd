#pragma once

#include <vector>

#include "verification/reference/path.hpp"

namespace talus::reference {

/// The states at `times` [s] of a material point that starts in `start` and follows `path`: CVODE's backward
/// differentiation formulas, which find the events at which the law changes between elastic and plastic and start anew
/// there.
///
/// Throws std::runtime_error with SUNDIALS' message where it gives up.
/// Source: Hindmarsh et al. (2005), doi:10.1145/1089014.1089020.
[[nodiscard]] std::vector<Row> cvode_path(RateLaw const&, State const& start, Path const&,
                                          std::vector<double> const& times);

}  // namespace talus::reference
