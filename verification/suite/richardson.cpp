#include "verification/suite/richardson.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "verification/reference/linear_algebra.hpp"

namespace talus::verification {

namespace {

constexpr double few_doubts = 1.25, many_doubts = 3;  ///< safety factors

double range(std::vector<double> const& values) {
  auto const [least, most] = std::minmax_element(values.begin(), values.end());
  return *most - *least;
}

/// p of e32 / e21 = r21^p (r32^p - 1) / (r21^p - 1), whose right side rises with p; bisected. Nothing where the ratio is
/// that of no p between 1e-3 and 20.
std::optional<double> observed_order(double r21, double r32, double ratio) {
  auto const ratio_of = [&](double p) {
    return std::pow(r21, p) * std::expm1(p * std::log(r32)) / std::expm1(p * std::log(r21));
  };
  double low = 1e-3, high = 20;
  if (!(ratio > ratio_of(low) && ratio < ratio_of(high))) return {};
  for (int step = 0; step < 60; ++step) {
    double const middle = 0.5 * (low + high);
    (ratio_of(middle) < ratio ? low : high) = middle;
  }
  return low;
}

/// An expansion fitted to all grids, and what the uncertainty asks of it.
struct Expansion {
  double order = 0, limit = 0, deviation = std::numeric_limits<double>::infinity();
  double of_finest = 0;  ///< |phi - fit| on the finest grid
};

/// Least squares of phi0 + sum over k of alpha_k h^(powers_k). sigma has as many degrees of freedom as there are grids
/// beyond the unknowns, of which p is one where it was `searched`.
Expansion fitted(std::vector<double> const& powers, bool searched, bool weighted, std::vector<double> const& h,
                 std::vector<double> const& values) {
  auto const n = static_cast<Eigen::Index>(h.size()), terms = static_cast<Eigen::Index>(powers.size());
  Eigen::VectorXd const phi = Eigen::Map<Eigen::VectorXd const>(values.data(), n);
  Eigen::ArrayXd const spacing = Eigen::Map<Eigen::ArrayXd const>(h.data(), n) / h.front();
  Eigen::MatrixXd design = Eigen::MatrixXd::Ones(n, 1 + terms);
  for (Eigen::Index k = 0; k < terms; ++k)
    design.col(k + 1) = spacing.pow(powers[static_cast<std::size_t>(k)]).matrix();
  Eigen::VectorXd weight = Eigen::VectorXd::Ones(n);
  if (weighted) weight = (spacing.inverse() / spacing.inverse().sum() * static_cast<double>(n)).matrix();
  Eigen::VectorXd const root = weight.cwiseSqrt();
  Eigen::VectorXd const x = reference::least_squares(root.asDiagonal() * design, root.cwiseProduct(phi));
  Eigen::VectorXd const rest = phi - design * x;
  double const freedom = static_cast<double>(n - 1 - terms - (searched ? 1 : 0));
  return {powers.front(), x[0], std::sqrt(weight.dot(rest.cwiseAbs2()) / freedom), std::abs(rest[n - 1])};
}

/// The power whose fit deviates least, out of 0.01 ... 8: scanned, then by ever narrower scans.
Expansion of_best_order(bool weighted, std::vector<double> const& h, std::vector<double> const& values) {
  Expansion best;
  double low = 0.01, high = 8;
  for (int scan = 0; scan < 6; ++scan) {
    constexpr int points = 80;
    double const stride = (high - low) / points;
    for (int k = 0; k <= points; ++k)
      if (auto const fit = fitted({low + k * stride}, true, weighted, h, values); fit.deviation < best.deviation)
        best = fit;
    low = std::max(0.01, best.order - 2 * stride), high = std::min(8., best.order + 2 * stride);
  }
  return best;
}

Expansion better(Expansion const& a, Expansion const& b) {
  return b.deviation < a.deviation ? b : a;
}

}  // namespace

GridConvergence convergence_of_three(std::vector<double> const& spacings, std::vector<double> const& values) {
  std::size_t const n = values.size();
  double const r21 = spacings[n - 2] / spacings[n - 1], r32 = spacings[n - 3] / spacings[n - 2];
  double const e21 = values[n - 2] - values[n - 1], e32 = values[n - 3] - values[n - 2];
  double const wide = many_doubts * range({values.end() - 3, values.end()});
  if (e21 == 0 && e32 == 0) return {Approach::monotone, 0, values.back(), 0};
  if (e21 * e32 < 0) return {Approach::oscillating, 0, values.back(), wide};
  auto const p = observed_order(r21, r32, e32 / e21);
  if (!p) return {Approach::unclear, 0, values.back(), wide};
  double const error = e21 / (std::pow(r21, *p) - 1);
  return {Approach::monotone, *p, values.back() - error, few_doubts * std::abs(error)};
}

GridConvergence convergence_of_two(std::vector<double> const& spacings, std::vector<double> const& values,
                                   double order) {
  std::size_t const n = values.size();
  double const error = (values[n - 2] - values[n - 1]) / (std::pow(spacings[n - 2] / spacings[n - 1], order) - 1);
  return {Approach::monotone, order, values.back() - error, many_doubts * std::abs(error)};
}

GridConvergence convergence_by_least_squares(std::vector<double> const& spacings, std::vector<double> const& values) {
  double const difference = range(values) / static_cast<double>(values.size() - 1);
  if (difference == 0) return {Approach::monotone, 0, values.back(), 0};
  Expansion chosen = better(of_best_order(false, spacings, values), of_best_order(true, spacings, values));
  double const p = chosen.order;
  if (p < 0.5 || p > 2) {
    chosen = {};
    for (bool const weighted : {false, true}) {
      for (double const power : {1., 2.}) chosen = better(chosen, fitted({power}, false, weighted, spacings, values));
      if (p < 0.5) chosen = better(chosen, fitted({1, 2}, false, weighted, spacings, values));
    }
  }
  double const error = std::abs(values.back() - chosen.limit);
  double const safety = p >= 0.5 && p < 2.1 ? few_doubts : many_doubts;
  bool const quiet = chosen.deviation < difference;
  double const uncertainty =
      quiet ? safety * error + chosen.deviation + chosen.of_finest
            : many_doubts * chosen.deviation / difference * (error + chosen.deviation + chosen.of_finest);
  return {quiet ? Approach::monotone : Approach::oscillating, p, chosen.limit, uncertainty};
}

}  // namespace talus::verification
