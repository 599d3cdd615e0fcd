#include "verification/reference/flow/banded.hpp"

#include <cvode/cvode.h>
#include <ida/ida.h>
#include <kinsol/kinsol.h>
#include <sunlinsol/sunlinsol_band.h>
#include <sunmatrix/sunmatrix_band.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "verification/reference/sundials.hpp"

namespace talus::reference::flow {

namespace {

constexpr long most_steps = 10'000'000;
constexpr int most_restarts = 1000;  // where rates have a kink that no step passes, the history of steps is forgotten

struct FreeCvode {
  void operator()(void* memory) const { CVodeFree(&memory); }
};
struct FreeIda {
  void operator()(void* memory) const { IDAFree(&memory); }
};
struct FreeKinsol {
  void operator()(void* memory) const { KINFree(&memory); }
};

template <class Pointer>
Pointer made(Pointer object) {
  if (object == nullptr) throw std::runtime_error("SUNDIALS: no memory");
  return object;
}

SUNContext new_context() {
  SUNContext context = nullptr;
  check_flag(SUNContext_Create(nullptr, &context), "SUNContext_Create", "");
  return made(context);
}

/// A context, a banded matrix and its solver.
class BandKit {
 public:
  explicit BandKit(Band const& band)
      : n_(band.n),
        context_(new_context()),
        pattern_(made(N_VNew_Serial(n_, context()))),
        matrix_(made(SUNBandMatrix(n_, band.upper, band.lower, context()))),
        solver_(made(SUNLinSol_Band(pattern_.get(), matrix(), context()))) {}

  [[nodiscard]] SUNContext context() const { return context_.get(); }
  [[nodiscard]] SUNMatrix matrix() const { return matrix_.get(); }
  [[nodiscard]] SUNLinearSolver solver() const { return solver_.get(); }
  [[nodiscard]] OwnedVector vector(std::vector<double> const& values) const {
    OwnedVector v(made(N_VNew_Serial(n_, context())));
    std::copy(values.begin(), values.end(), N_VGetArrayPointer(v.get()));
    return v;
  }
  [[nodiscard]] OwnedVector constant(double value) const {
    return vector(std::vector<double>(static_cast<std::size_t>(n_), value));
  }
  [[nodiscard]] std::vector<double> values(N_Vector v) const {
    double const* const first = N_VGetArrayPointer(v);
    return {first, first + n_};
  }

 private:
  int n_;
  Owner<SUNContext, FreeContext> context_;  // freed last
  OwnedVector pattern_;
  Owner<SUNMatrix, FreeMatrix> matrix_;
  Owner<SUNLinearSolver, FreeSolver> solver_;
};

std::vector<double> absolute(Start const& start) {
  auto list = start.sizes;
  for (double& size : list) size *= start.tolerance;
  return list;
}

int call_rates(double, N_Vector y, N_Vector f, void* data) {
  return (*static_cast<Rates const*>(data))(N_VGetArrayPointer(y), N_VGetArrayPointer(f)) ? 0 : 1;  // 1: try less
}
int call_residual(double, N_Vector y, N_Vector dy, N_Vector out, void* data) {
  auto const& residual = *static_cast<Residual const*>(data);
  return residual(N_VGetArrayPointer(y), N_VGetArrayPointer(dy), N_VGetArrayPointer(out)) ? 0 : 1;
}
int call_equations(N_Vector y, N_Vector out, void* data) {
  return (*static_cast<Equations const*>(data))(N_VGetArrayPointer(y), N_VGetArrayPointer(out)) ? 0 : 1;
}
template <class F>
void* user(F const& f) {
  return const_cast<F*>(&f);
}

/// The states at those times; `advance` goes to a time > 0.
template <class Advance>
std::vector<std::vector<double>> states(std::vector<double> const& times, std::vector<double> const& start,
                                        Advance const& advance) {
  std::vector<std::vector<double>> list;
  for (double const t : times) list.push_back(t > 0 ? advance(t) : start);
  return list;
}

}  // namespace

std::vector<std::vector<double>> cvode_banded(Band const& band, Rates const& rates, Start const& start,
                                              std::vector<double> const& times) {
  BandKit const kit(band);
  std::string said;
  auto const y = kit.vector(start.y), tolerances = kit.vector(absolute(start));
  std::unique_ptr<void, FreeCvode> const memory(made(CVodeCreate(CV_BDF, kit.context())));
  void* const m = memory.get();
  auto const check = [&](int flag, char const* call) { check_flag(flag, call, said); };
  check(CVodeSetErrHandlerFn(m, &keep_message, &said), "CVodeSetErrHandlerFn");
  check(CVodeInit(m, &call_rates, 0, y.get()), "CVodeInit");
  check(CVodeSVtolerances(m, start.tolerance, tolerances.get()), "CVodeSVtolerances");
  check(CVodeSetUserData(m, user(rates)), "CVodeSetUserData");
  check(CVodeSetLinearSolver(m, kit.solver(), kit.matrix()), "CVodeSetLinearSolver");
  check(CVodeSetMaxNumSteps(m, most_steps), "CVodeSetMaxNumSteps");
  check(CVodeSetStopTime(m, times.back()), "CVodeSetStopTime");
  int restarts = 0;
  return states(times, start.y, [&](double until) {
    for (double t = 0; t < until;) {
      int const flag = CVode(m, until, y.get(), &t, CV_NORMAL);
      bool const kink = (flag == CV_ERR_FAILURE || flag == CV_CONV_FAILURE) && ++restarts <= most_restarts;
      check(kink ? CVodeReInit(m, t, y.get()) : flag, "CVode");
    }
    return kit.values(y.get());
  });
}

std::vector<std::vector<double>> ida_banded(Band const& band, Residual const& residual, Start const& start,
                                            std::vector<double> const& slopes, std::vector<bool> const& differential,
                                            std::vector<double> const& times) {
  BandKit const kit(band);
  std::string said;
  auto const y = kit.vector(start.y), dy = kit.vector(slopes), tolerances = kit.vector(absolute(start));
  auto const kinds = kit.vector({differential.begin(), differential.end()});
  std::unique_ptr<void, FreeIda> const memory(made(IDACreate(kit.context())));
  void* const m = memory.get();
  auto const check = [&](int flag, char const* call) { check_flag(flag, call, said); };
  check(IDASetErrHandlerFn(m, &keep_message, &said), "IDASetErrHandlerFn");
  check(IDAInit(m, &call_residual, 0, y.get(), dy.get()), "IDAInit");
  check(IDASVtolerances(m, start.tolerance, tolerances.get()), "IDASVtolerances");
  check(IDASetUserData(m, user(residual)), "IDASetUserData");
  check(IDASetLinearSolver(m, kit.solver(), kit.matrix()), "IDASetLinearSolver");
  check(IDASetMaxNumSteps(m, most_steps), "IDASetMaxNumSteps");
  check(IDASetId(m, kinds.get()), "IDASetId");
  check(IDASetSuppressAlg(m, 1), "IDASetSuppressAlg");
  check(IDASetStopTime(m, times.back()), "IDASetStopTime");
  return states(times, start.y, [&](double until) {
    double t = 0;
    check(IDASolve(m, until, &t, y.get(), dy.get(), IDA_NORMAL), "IDASolve");
    return kit.values(y.get());
  });
}

std::vector<double> kinsol_banded(Band const& band, Equations const& equations, Start const& start, NewtonSteps steps) {
  BandKit const kit(band);
  std::string said;
  auto const y = kit.vector(start.y), ones = kit.constant(1);
  auto inverse = start.sizes;
  for (double& size : inverse) size = 1 / size;
  auto const scale = kit.vector(inverse);
  std::unique_ptr<void, FreeKinsol> const memory(made(KINCreate(kit.context())));
  void* const m = memory.get();
  auto const check = [&](int flag, char const* call) { check_flag(flag, call, said); };
  check(KINSetErrHandlerFn(m, &keep_message, &said), "KINSetErrHandlerFn");
  check(KINInit(m, &call_equations, y.get()), "KINInit");
  check(KINSetUserData(m, user(equations)), "KINSetUserData");
  check(KINSetLinearSolver(m, kit.solver(), kit.matrix()), "KINSetLinearSolver");
  check(KINSetFuncNormTol(m, start.tolerance), "KINSetFuncNormTol");
  check(KINSetScaledStepTol(m, 1e-15), "KINSetScaledStepTol");
  check(KINSetMaxSetupCalls(m, 1), "KINSetMaxSetupCalls");  // a new matrix in each iteration
  check(KINSetNumMaxIters(m, 1000), "KINSetNumMaxIters");
  check(KINSetMaxNewtonStep(m, 1e10), "KINSetMaxNewtonStep");
  int const strategy = steps == NewtonSteps::searched ? KIN_LINESEARCH : KIN_NONE;
  check(KINSol(m, y.get(), strategy, scale.get(), ones.get()), "KINSol");
  return kit.values(y.get());
}

}  // namespace talus::reference::flow
