#pragma once
/// The order p at which errors e fall with the spacing h,  e ~ C h^p, and how sure it is.

#include <optional>
#include <vector>

#include "verification/suite/findings.hpp"

namespace talus::verification {

/// log(e_k / e_k+1) / log(h_k / h_k+1) for each neighbouring pair; NaN where an error is not positive and finite.
/// Pre: as many errors as spacings.
[[nodiscard]] std::vector<double> pairwise_orders(std::vector<double> const& spacings,
                                                  std::vector<double> const& errors);

/// A slope with its 95 % interval.
struct Slope {
  double value;
  Interval interval;  ///< no ends where there are fewer than three points
};

/// Least squares of log e on log h; the interval is Student's with n - 2 degrees of freedom. Nothing where there are
/// fewer than two points or an error is not positive and finite.
[[nodiscard]] std::optional<Slope> fitted_slope(std::vector<double> const& spacings, std::vector<double> const& errors);

/// e = C h^p + e0.
struct FlooredFit {
  double factor, order, floor;  ///< C, p, e0
  double finest;                ///< error on the finest spacing, as measured
  /// Less than that share of the finest error is no floor.
  static constexpr double share = 0.3;
  [[nodiscard]] bool floored() const { return floor > share * finest; }
};

/// Least squares of the relative residuals with 0.2 <= p <= 6 and e0 >= 0: C and e0 are linear and found in closed form at
/// each p, so that only p is searched, from thirty starts. Nothing where there are fewer than three points, an error is
/// not positive and finite, or errors rise as the spacing falls.
[[nodiscard]] std::optional<FlooredFit> fitted_floor(std::vector<double> const& spacings,
                                                     std::vector<double> const& errors);

/// Quantile of Student's distribution: 95 % lie within -+ it.
[[nodiscard]] double student_95(int degrees_of_freedom);

}  // namespace talus::verification
