#include "verification/suite/order.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

namespace talus::verification {

namespace {

bool all_positive(std::vector<double> const& errors) {
  return std::all_of(errors.begin(), errors.end(), [](double e) { return e > 0 && std::isfinite(e); });
}

std::vector<double> logarithms(std::vector<double> const& values) {
  std::vector<double> logs;
  for (double const value : values) logs.push_back(std::log(value));
  return logs;
}

double mean(std::vector<double> const& values) {
  double sum = 0;
  for (double const value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// The fit of C and e0 at a given p, and the sum of squares of its relative residuals.
struct Trial {
  double factor = 0, floor = 0, misfit = 0;
};

double misfit_of(double factor, double floor, double p, std::vector<double> const& h, std::vector<double> const& e) {
  double sum = 0;
  for (std::size_t k = 0; k < h.size(); ++k) {
    double const residual = (factor * std::pow(h[k], p) + floor) / e[k] - 1;
    sum += residual * residual;
  }
  return sum;
}

/// C a_k + e0 b_k = 1 with a = h^p / e and b = 1 / e, by least squares with e0 >= 0.
Trial at_order(double p, std::vector<double> const& h, std::vector<double> const& e) {
  double aa = 0, ab = 0, bb = 0, a1 = 0, b1 = 0;
  for (std::size_t k = 0; k < h.size(); ++k) {
    double const a = std::pow(h[k] / h.front(), p) / e[k], b = 1 / e[k];
    aa += a * a, ab += a * b, bb += b * b, a1 += a, b1 += b;
  }
  double const determinant = aa * bb - ab * ab;
  double factor = (a1 * bb - b1 * ab) / determinant, floor = (b1 * aa - a1 * ab) / determinant;
  if (!(floor >= 0)) floor = 0, factor = a1 / aa;
  factor /= std::pow(h.front(), p);
  return {factor, floor, misfit_of(factor, floor, p, h, e)};
}

/// The order between low and high whose fit is best, by golden sections.
double best_order(double low, double high, std::vector<double> const& h, std::vector<double> const& e) {
  constexpr double golden = 0.6180339887498949;
  for (int step = 0; step < 60; ++step) {
    double const left = high - golden * (high - low), right = low + golden * (high - low);
    if (at_order(left, h, e).misfit < at_order(right, h, e).misfit)
      high = right;
    else
      low = left;
  }
  return 0.5 * (low + high);
}

}  // namespace

std::vector<double> pairwise_orders(std::vector<double> const& spacings, std::vector<double> const& errors) {
  std::vector<double> orders;
  for (std::size_t k = 1; k < spacings.size(); ++k) {
    bool const told = all_positive({errors[k - 1], errors[k]});
    orders.push_back(told ? std::log(errors[k - 1] / errors[k]) / std::log(spacings[k - 1] / spacings[k])
                          : std::numeric_limits<double>::quiet_NaN());
  }
  return orders;
}

std::optional<Slope> fitted_slope(std::vector<double> const& spacings, std::vector<double> const& errors) {
  std::size_t const n = spacings.size();
  if (n < 2 || !all_positive(errors)) return {};
  auto const x = logarithms(spacings), y = logarithms(errors);
  double const mean_x = mean(x), mean_y = mean(y);
  double xx = 0, xy = 0, rest = 0;
  for (std::size_t k = 0; k < n; ++k) xx += (x[k] - mean_x) * (x[k] - mean_x), xy += (x[k] - mean_x) * (y[k] - mean_y);
  double const slope = xy / xx;
  if (n < 3) return Slope{slope, {}};
  for (std::size_t k = 0; k < n; ++k) rest += std::pow(y[k] - mean_y - slope * (x[k] - mean_x), 2);
  int const freedom = static_cast<int>(n) - 2;
  double const half = student_95(freedom) * std::sqrt(rest / freedom / xx);
  return Slope{slope, {slope - half, slope + half}};
}

std::optional<FlooredFit> fitted_floor(std::vector<double> const& spacings, std::vector<double> const& errors) {
  if (spacings.size() < 3 || !all_positive(errors)) return {};
  constexpr double least = 0.2, most = 6, stride = 0.2;
  double best = least;
  for (double p = least; p <= most; p += stride)
    if (at_order(p, spacings, errors).misfit < at_order(best, spacings, errors).misfit) best = p;
  double const p = best_order(std::max(least, best - stride), std::min(most, best + stride), spacings, errors);
  auto const [factor, floor, misfit] = at_order(p, spacings, errors);
  if (!(factor > 0) || !std::isfinite(misfit)) return {};
  return FlooredFit{factor, p, floor, errors.back()};
}

double student_95(int degrees_of_freedom) {
  return gsl_cdf_tdist_Pinv(0.975, degrees_of_freedom);
}

}  // namespace talus::verification
