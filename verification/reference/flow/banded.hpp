#pragma once
/// Banded systems by SUNDIALS: rates by CVODE, residuals by IDA, equations by KINSOL.

#include <functional>
#include <vector>

namespace talus::reference::flow {

/// n unknowns; equation i depends on the unknowns i - lower ... i + upper only.
struct Band {
  int n, lower, upper;
};

/// y' = f(y). False where the rates are not defined: the integrator then tries a shorter step.
using Rates = std::function<bool(double const* y, double* f)>;
/// F(y, y') = 0. As above.
using Residual = std::function<bool(double const* y, double const* dy, double* out)>;
/// F(y) = 0. As above.
using Equations = std::function<bool(double const* y, double* out)>;

/// What is known at t = 0, and how exact the rest shall be. sizes: of which the relative tolerance is the absolute one.
struct Start {
  std::vector<double> y, sizes;
  double tolerance;
};

/// y at each of those times [s], which rise from at least 0: BDF of variable order, Newton with a banded matrix by
/// difference quotients. Throws std::runtime_error.
[[nodiscard]] std::vector<std::vector<double>> cvode_banded(Band const&, Rates const&, Start const&,
                                                            std::vector<double> const& times);

/// The same of a residual. slopes: y' at t = 0; differential: whether y'_i occurs. Pre: F(y, slopes) = 0.
[[nodiscard]] std::vector<std::vector<double>> ida_banded(Band const&, Residual const&, Start const&,
                                                          std::vector<double> const& slopes,
                                                          std::vector<bool> const& differential,
                                                          std::vector<double> const& times);

/// Whether Newton's steps are shortened until |F| falls enough, or taken as they are, as piecewise linear F ask for.
enum class NewtonSteps { searched, full };

/// A root near y, where all F are smaller than the tolerance. F is to be scaled to 1.
[[nodiscard]] std::vector<double> kinsol_banded(Band const&, Equations const&, Start const&, NewtonSteps);

}  // namespace talus::reference::flow
