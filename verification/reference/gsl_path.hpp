#pragma once

#include <vector>

#include "verification/reference/path.hpp"

namespace talus::reference {

/// As cvode_path, by another method and library: GSL's explicit Runge-Kutta of order 8 (Prince & Dormand), with the
/// events found by halving the step in which the sign changes.
///
/// Throws std::runtime_error with GSL's message where it gives up.
/// Source: Galassi et al., GNU Scientific Library Reference Manual; Prince & Dormand (1981),
/// doi:10.1016/0771-050X(81)90010-3.
[[nodiscard]] std::vector<Row> gsl_path(RateLaw const&, State const& start, Path const&,
                                        std::vector<double> const& times);

}  // namespace talus::reference
