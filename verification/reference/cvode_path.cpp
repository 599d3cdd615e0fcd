#include "verification/reference/cvode_path.hpp"

#include <cvode/cvode.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "verification/reference/sundials.hpp"

namespace talus::reference {

namespace {

struct FreeCvode {
  void operator()(void* memory) const { CVodeFree(&memory); }
};

class Cvode {
 public:
  Cvode(RateLaw const& law, State const& start)
      : law_(law), kit_(coordinates), y_(kit_.vector()), tolerances_(kit_.vector()) {
    auto const y = coordinates_of(start), sizes = sizes_of(law);
    std::copy(y.begin(), y.end(), state());
    for (int i = 0; i < coordinates; ++i)
      N_VGetArrayPointer(tolerances_.get())[i] = relative_tolerance * sizes[static_cast<std::size_t>(i)];
  }

  void begin(Segment const& segment, double from, double until) {
    segment_ = &segment;
    segment_start_ = t_ = from;
    plastic_ = starts_plastic(law_, plastic_, gradient(from), state());
    events_ = 0;
    restart(until);
  }

  void advance(double t) {
    while (t_ < t) {
      int const flag = CVode(memory_.get(), t, y_.get(), &t_, CV_NORMAL);
      check(flag, "CVode");
      if (flag != CV_ROOT_RETURN) continue;
      if (++events_ > most_events) throw std::runtime_error("CVode: the phases change without end");
      plastic_ = !plastic_;
      restart(until_);
    }
  }

  [[nodiscard]] Row row() const { return row_of(law_, t_, gradient(t_), state(), plastic_); }

 private:
  static int derivative(double t, N_Vector y, N_Vector dy, void* data) {
    auto const& self = *static_cast<Cvode*>(data);
    double* const rate = N_VGetArrayPointer(dy);
    return rates(self.law_, self.plastic_, self.gradient(t), N_VGetArrayPointer(y), rate) ? 0 : 1;  // 1: try less
  }
  static int root(double t, N_Vector y, double* g, void* data) {
    auto const& self = *static_cast<Cvode*>(data);
    g[0] = event(self.law_, self.plastic_, self.gradient(t), N_VGetArrayPointer(y));
    return 0;
  }

  [[nodiscard]] Matrix gradient(double t) const { return segment_->gradient(t - segment_start_); }
  [[nodiscard]] double* state() const { return N_VGetArrayPointer(y_.get()); }
  void check(int flag, char const* call) const { check_flag(flag, call, said_); }

  /// From here with the phase of now. Each phase has an integrator of its own: nothing is left of the last one.
  void restart(double until) {
    until_ = until;
    memory_.reset(CVodeCreate(CV_BDF, kit_.context()));
    void* const m = memory_.get();
    if (m == nullptr) throw std::runtime_error("CVodeCreate failed");
    check(CVodeSetErrHandlerFn(m, &keep_message, &said_), "CVodeSetErrHandlerFn");
    check(CVodeInit(m, &derivative, t_, y_.get()), "CVodeInit");
    check(CVodeSVtolerances(m, relative_tolerance, tolerances_.get()), "CVodeSVtolerances");
    check(CVodeSetUserData(m, this), "CVodeSetUserData");
    check(CVodeSetLinearSolver(m, kit_.solver(), kit_.matrix()), "CVodeSetLinearSolver");
    check(CVodeSetMaxNumSteps(m, 10'000'000), "CVodeSetMaxNumSteps");
    check(CVodeSetStopTime(m, until), "CVodeSetStopTime");
    check(CVodeRootInit(m, 1, &root), "CVodeRootInit");
    int direction = plastic_ ? -1 : 1;
    check(CVodeSetRootDirection(m, &direction), "CVodeSetRootDirection");
    check(CVodeSetNoInactiveRootWarn(m), "CVodeSetNoInactiveRootWarn");
  }

  RateLaw const& law_;
  DenseKit kit_;
  OwnedVector y_, tolerances_;
  std::unique_ptr<void, FreeCvode> memory_;
  std::string said_;
  Segment const* segment_ = nullptr;
  double segment_start_ = 0, t_ = 0, until_ = 0;
  bool plastic_ = false;
  int events_ = 0;
};

}  // namespace

std::vector<Row> cvode_path(RateLaw const& law, State const& start, Path const& path,
                            std::vector<double> const& times) {
  Cvode integrator(law, start);
  return follow(integrator, path, times);
}

}  // namespace talus::reference
