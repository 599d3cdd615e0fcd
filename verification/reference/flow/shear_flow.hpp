#pragma once
/// Steady shear flows along one coordinate, integrated in three ways that know nothing of each other's numerics.

#include <vector>

#include "verification/reference/flow/gsl.hpp"

namespace talus::reference::flow {

/// What shears between two places [m], from a wall at rest at `from`: u' = gamma(x), u(from) = 0; `to` may be less. Two
/// statements of the same law: how fast it shears, or what the stress of a shear rate lacks of equilibrium.
struct ShearFlow {
  double from, to;
  Function rate;                                    ///< |u'| [1/s] at x [m]
  std::function<double(double, double)> imbalance;  ///< (q(gamma) - q of equilibrium)/(its size) [1] of x and gamma
};

/// u [m/s] at x between `from` and `to`.
///
/// quadrature: of the rate, by GSL. CVODE: u' = rate. KINSOL: the shear rates at the points of a Gauss rule so that the
/// stress balances, from the law as q(gamma) and not as gamma(q), and their sum.
[[nodiscard]] double speed_by_quadrature(ShearFlow const&, double x);
[[nodiscard]] double speed_by_cvode(ShearFlow const&, double x);
[[nodiscard]] double speed_by_kinsol(ShearFlow const&, double x);

}  // namespace talus::reference::flow
