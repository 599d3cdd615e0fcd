#pragma once
/// Roots and integrals by GSL, with exceptions instead of flags.

#include <functional>
#include <vector>

namespace talus::reference::flow {

using Function = std::function<double(double)>;

/// Root of f between a and b, where it changes sign: Brent's method, to the last digits. Throws std::runtime_error.
[[nodiscard]] double root(Function const& f, double a, double b);

/// Integral of f from a to b, singular at the ends if at all: adaptive Gauss-Kronrod with the epsilon algorithm,
/// relative tolerance 1e-12. Throws std::runtime_error.
[[nodiscard]] double integral(Function const& f, double a, double b);

/// Gauss-Legendre rule of n points on [0, 1].
struct GaussRule {
  std::vector<double> x, w;
};
[[nodiscard]] GaussRule gauss_rule(int n);

}  // namespace talus::reference::flow
