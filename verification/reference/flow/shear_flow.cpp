#include "verification/reference/flow/shear_flow.hpp"

#include <algorithm>
#include <cmath>

#include "verification/reference/flow/banded.hpp"

namespace talus::reference::flow {

double speed_by_quadrature(ShearFlow const& flow, double x) {
  return std::abs(integral(flow.rate, flow.from, x));
}

/// In y = (t, u), t the way from the wall over the whole: the rates then depend on the state only.
double speed_by_cvode(ShearFlow const& flow, double x) {
  double const way = x - flow.from;
  if (way == 0) return 0;
  double const size = std::abs(way) * std::max(flow.rate(flow.from), flow.rate(flow.from + 0.5 * way));
  auto const rates = [&](double const* y, double* f) {
    f[0] = 1;
    f[1] = std::abs(way) * flow.rate(flow.from + std::min(y[0], 1.0) * way) / size;
    return std::isfinite(f[1]);
  };
  return size * cvode_banded({2, 1, 1}, rates, {{0, 0}, {1, 1}, 1e-13}, {1.0}).back()[1];
}

/// The places are graded towards both ends, x = x_0 + (x_1 - x_0) s^2 (3 - 2 s): roots become powers there. q(gamma) is
/// concave: Newton's method from rest comes near from below.
double speed_by_kinsol(ShearFlow const& flow, double x) {
  constexpr int n = 64;
  auto const rule = gauss_rule(n);
  double const way = x - flow.from;
  auto const place = [&](double s) { return flow.from + way * s * s * (3 - 2 * s); };
  double largest = 0;
  for (double const s : rule.x) largest = std::max(largest, flow.rate(place(s)));
  if (way == 0 || largest == 0) return 0;
  auto const equations = [&](double const* y, double* out) {
    for (std::size_t k = 0; k < n; ++k) {
      if (!(y[k] >= 0)) return false;
      out[k] = flow.imbalance(place(rule.x[k]), y[k] * largest);
    }
    return true;
  };
  auto const start = std::vector<double>(n, 0.0), sizes = std::vector<double>(n, 1.0);
  auto const y = kinsol_banded({n, 0, 0}, equations, {start, sizes, 1e-14}, NewtonSteps::searched);
  double sum = 0;
  for (std::size_t k = 0; k < n; ++k) sum += rule.w[k] * y[k] * 6 * rule.x[k] * (1 - rule.x[k]);
  return std::abs(way) * largest * sum;
}

}  // namespace talus::reference::flow
