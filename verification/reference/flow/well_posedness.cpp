#include "verification/reference/flow/well_posedness.hpp"

#include <gsl/gsl_poly.h>

#include <vector>

#include "verification/reference/flow/gsl.hpp"
#include "verification/reference/gsl_calls.hpp"

namespace talus::reference::flow {

double ill_posedness(Fluid const& fluid, double I) {
  double const b = std::sqrt(fluid.omega()) * fluid.friction.I_0, mu = fluid.ratio(I);
  double const slope = fluid.omega() * (fluid.friction.mu_2 - fluid.friction.mu_1) * b / ((b + I) * (b + I));
  double const X = I * slope / mu;
  return 4 * X * X - 4 * X + mu * mu * (1 - X / 2) * (1 - X / 2);
}

std::pair<double, double> well_posed_window(Fluid const& fluid) {
  std::vector<double> ends;
  constexpr double ratio = 1.02;
  for (double I = 1e-8; I < 1e4; I *= ratio)
    if ((ill_posedness(fluid, I) > 0) != (ill_posedness(fluid, I * ratio) > 0))
      ends.push_back(root([&](double x) { return ill_posedness(fluid, x); }, I, I * ratio));
  return ends.size() == 2 ? std::pair{ends[0], ends[1]} : std::pair{0.0, 0.0};
}

namespace {

using Polynomial = std::vector<double>;  // from the constant up

Polynomial product(Polynomial const& a, Polynomial const& b) {
  Polynomial c(a.size() + b.size() - 1, 0.0);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  return c;
}

/// a + factor b.
Polynomial sum(Polynomial a, double factor, Polynomial const& b) {
  a.resize(std::max(a.size(), b.size()), 0.0);
  for (std::size_t i = 0; i < b.size(); ++i) a[i] += factor * b[i];
  return a;
}

}  // namespace

std::pair<double, double> well_posed_window_by_polynomial(Fluid const& fluid) {
  double const w = fluid.omega(), b = std::sqrt(w) * fluid.friction.I_0;
  double const m_1 = w * fluid.friction.mu_1, m_2 = w * fluid.friction.mu_2;
  Polynomial const B{b, 1}, N{m_1 * b, m_2}, Z{0, (m_2 - m_1) * b}, B2 = product(B, B);
  Polynomial const last = product(N, sum(product(B, N), -0.5, Z));
  Polynomial const all =
      sum(sum(product(last, last), 4, product(product(Z, Z), B2)), -4, product(product(Z, N), product(B2, B)));
  std::vector<double> roots(2 * (all.size() - 1));
  gsl::Quiet const quiet;
  auto const workspace = gsl::owned<gsl_poly_complex_workspace_free>(gsl_poly_complex_workspace_alloc(all.size()));
  gsl::check(gsl_poly_complex_solve(all.data(), all.size(), workspace.get(), roots.data()), "gsl_poly_complex_solve");
  std::vector<double> ends;
  for (std::size_t k = 0; k < roots.size(); k += 2)
    if (roots[k] > 0 && std::abs(roots[k + 1]) < 1e-9 * roots[k]) ends.push_back(roots[k]);
  return ends.size() == 2 ? std::pair{std::min(ends[0], ends[1]), std::max(ends[0], ends[1])} : std::pair{0.0, 0.0};
}

}  // namespace talus::reference::flow
