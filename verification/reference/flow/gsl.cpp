#include "verification/reference/flow/gsl.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_roots.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace talus::reference::flow {

namespace {

struct FreeGsl {
  void operator()(gsl_integration_workspace* w) const { gsl_integration_workspace_free(w); }
  void operator()(gsl_integration_glfixed_table* t) const { gsl_integration_glfixed_table_free(t); }
  void operator()(gsl_root_fsolver* s) const { gsl_root_fsolver_free(s); }
};
template <class T>
std::unique_ptr<T, FreeGsl> owned(T* object) {
  if (object == nullptr) throw std::runtime_error("GSL: no memory");
  return std::unique_ptr<T, FreeGsl>(object);
}

/// GSL's handler, which would abort, is off while this lives.
struct Quiet {
  gsl_error_handler_t* before = gsl_set_error_handler_off();
  Quiet() = default;
  Quiet(Quiet const&) = delete;
  Quiet& operator=(Quiet const&) = delete;
  ~Quiet() { gsl_set_error_handler(before); }
};

void check(int status, char const* call) {
  if (status != GSL_SUCCESS) throw std::runtime_error(std::string(call) + ": " + gsl_strerror(status));
}

gsl_function function(Function const& f) {
  return {[](double x, void* data) { return (*static_cast<Function const*>(data))(x); }, const_cast<Function*>(&f)};
}

}  // namespace

double root(Function const& f, double a, double b) {
  Quiet const quiet;
  if (f(a) == 0) return a;
  if (f(b) == 0) return b;
  auto const solver = owned(gsl_root_fsolver_alloc(gsl_root_fsolver_brent));
  auto target = function(f);
  check(gsl_root_fsolver_set(solver.get(), &target, std::min(a, b), std::max(a, b)), "gsl_root_fsolver_set");
  for (int k = 0; k < 200; ++k) {
    check(gsl_root_fsolver_iterate(solver.get()), "gsl_root_fsolver_iterate");
    double const low = gsl_root_fsolver_x_lower(solver.get()), high = gsl_root_fsolver_x_upper(solver.get());
    double const x = gsl_root_fsolver_root(solver.get());
    if (f(x) == 0 || gsl_root_test_interval(low, high, 0, 4e-16) == GSL_SUCCESS) return x;
  }
  return gsl_root_fsolver_root(solver.get());
}

double integral(Function const& f, double a, double b) {
  if (a == b) return 0;
  Quiet const quiet;
  constexpr std::size_t most = 2000;
  auto const workspace = owned(gsl_integration_workspace_alloc(most));
  auto target = function(f);
  double value = 0, error = 0;
  int const status = gsl_integration_qags(&target, a, b, 0, 1e-12, most, workspace.get(), &value, &error);
  if (status != GSL_EROUND) check(status, "gsl_integration_qags");  // round-off: as exact as it gets
  return value;
}

GaussRule gauss_rule(int n) {
  auto const table = owned(gsl_integration_glfixed_table_alloc(static_cast<std::size_t>(n)));
  GaussRule rule;
  for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k) {
    double x = 0, w = 0;
    gsl_integration_glfixed_point(0, 1, k, &x, &w, table.get());
    rule.x.push_back(x), rule.w.push_back(w);
  }
  return rule;
}

}  // namespace talus::reference::flow
