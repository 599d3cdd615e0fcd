#include "verification/reference/flow/gsl.hpp"

#include <gsl/gsl_integration.h>
#include <gsl/gsl_roots.h>

#include "verification/reference/gsl_calls.hpp"

namespace talus::reference::flow {

namespace {

gsl_function function(Function const& f) {
  return {[](double x, void* data) { return (*static_cast<Function const*>(data))(x); }, const_cast<Function*>(&f)};
}

}  // namespace

double root(Function const& f, double a, double b) {
  gsl::Quiet const quiet;
  if (f(a) == 0) return a;
  if (f(b) == 0) return b;
  auto const solver = gsl::owned<gsl_root_fsolver_free>(gsl_root_fsolver_alloc(gsl_root_fsolver_brent));
  auto target = function(f);
  gsl::check(gsl_root_fsolver_set(solver.get(), &target, std::min(a, b), std::max(a, b)), "gsl_root_fsolver_set");
  for (int k = 0; k < 200; ++k) {
    gsl::check(gsl_root_fsolver_iterate(solver.get()), "gsl_root_fsolver_iterate");
    double const low = gsl_root_fsolver_x_lower(solver.get()), high = gsl_root_fsolver_x_upper(solver.get());
    double const x = gsl_root_fsolver_root(solver.get());
    if (f(x) == 0 || gsl_root_test_interval(low, high, 0, 4e-16) == GSL_SUCCESS) return x;
  }
  return gsl_root_fsolver_root(solver.get());
}

double integral(Function const& f, double a, double b) {
  if (a == b) return 0;
  gsl::Quiet const quiet;
  constexpr std::size_t most = 2000;
  auto const workspace = gsl::owned<gsl_integration_workspace_free>(gsl_integration_workspace_alloc(most));
  auto target = function(f);
  double value = 0, error = 0;
  int const status = gsl_integration_qags(&target, a, b, 0, 1e-12, most, workspace.get(), &value, &error);
  if (status != GSL_EROUND) gsl::check(status, "gsl_integration_qags");  // round-off: as exact as it gets
  return value;
}

GaussRule gauss_rule(int n) {
  auto const table =
      gsl::owned<gsl_integration_glfixed_table_free>(gsl_integration_glfixed_table_alloc(static_cast<std::size_t>(n)));
  GaussRule rule;
  for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k) {
    double x = 0, w = 0;
    gsl_integration_glfixed_point(0, 1, k, &x, &w, table.get());
    rule.x.push_back(x), rule.w.push_back(w);
  }
  return rule;
}

}  // namespace talus::reference::flow
