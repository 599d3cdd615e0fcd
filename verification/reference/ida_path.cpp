#include "verification/reference/ida_path.hpp"

#include <ida/ida.h>

#include <Eigen/LU>
#include <algorithm>
#include <stdexcept>
#include <string>

#include "verification/reference/sundials.hpp"

namespace talus::reference {

namespace {

struct FreeIda {
  void operator()(void* memory) const { IDAFree(&memory); }
};

/// One phase of a segment: elastic or plastic, with its unknown rates.
class Ida {
 public:
  Ida(RateLaw const& law, State const& start) : law_(law), y_(coordinates_of(start)) {}

  void begin(MixedSegment const& segment, double from, double until) {
    segment_ = &segment;
    t_ = from;
    until_ = until;
    unknowns_ = static_cast<int>(segment.held.size());
    auto const elastic = solved_rates(false);
    plastic_ = starts_plastic(law_, plastic_, gradient(elastic.data()), y_.data());
    events_ = 0;
    restart();
  }

  void advance(double t) {
    while (t_ < t) {
      int const flag = IDASolve(memory_.get(), t, &t_, all_.get(), slopes_.get(), IDA_NORMAL);
      check(flag, "IDASolve");
      std::copy_n(values(), coordinates, y_.begin());
      if (flag != IDA_ROOT_RETURN) continue;
      if (++events_ > most_events) throw std::runtime_error("IDA: the phases change without end");
      plastic_ = !plastic_;
      restart();
    }
  }

  [[nodiscard]] Row row() const { return row_of(law_, t_, gradient(values() + coordinates), y_.data(), plastic_); }

 private:
  [[nodiscard]] double* values() const { return N_VGetArrayPointer(all_.get()); }
  void check(int flag, char const* call) const { check_flag(flag, call, said_); }

  [[nodiscard]] Matrix gradient(double const* r) const {
    Matrix l = segment_->l;
    for (auto const& held : segment_->held) l(held.row, held.column) = *r++;
    return l;
  }

  /// (1): 7 equations for y, then one for each stress, in units of strain rate.
  [[nodiscard]] bool residual(double const* y, double const* dy, double* out) const {
    Coordinates f{};
    bool const defined = rates(law_, plastic_, gradient(y + coordinates), y, f.data());
    for (int i = 0; i < coordinates; ++i) out[i] = dy[i] - f[static_cast<std::size_t>(i)];
    Matrix const change = stress_rate(law_, y, dy);
    double* next = out + coordinates;
    for (auto const& held : segment_->held)
      *next++ = (change(held.row, held.column) - held.stress_rate) / law_.elastic.G();
    return defined;
  }

  /// The unknown rates of a phase. The stress rate is affine in them, elastic or plastic.
  [[nodiscard]] Eigen::VectorXd solved_rates(bool plastic) const {
    auto const miss = [&](Eigen::VectorXd const& r) {
      Coordinates f{};
      if (!rates(law_, plastic, gradient(r.data()), y_.data(), f.data()))
        throw std::domain_error("a phase starts where the law is not defined");
      Matrix const change = stress_rate(law_, y_.data(), f.data());
      Eigen::VectorXd out(unknowns_);
      for (int k = 0; k < unknowns_; ++k) {
        auto const& held = segment_->held[static_cast<std::size_t>(k)];
        out[k] = (change(held.row, held.column) - held.stress_rate) / law_.elastic.G();
      }
      return out;
    };
    Eigen::VectorXd const zero = Eigen::VectorXd::Zero(unknowns_), at_zero = miss(zero);
    Eigen::MatrixXd slope(unknowns_, unknowns_);
    for (int k = 0; k < unknowns_; ++k) slope.col(k) = miss(Eigen::VectorXd::Unit(unknowns_, k)) - at_zero;
    return unknowns_ == 0 ? zero : Eigen::VectorXd(slope.fullPivLu().solve(-at_zero));
  }

  static int equations(double, N_Vector y, N_Vector dy, N_Vector out, void* data) {
    auto const& self = *static_cast<Ida*>(data);
    return self.residual(N_VGetArrayPointer(y), N_VGetArrayPointer(dy), N_VGetArrayPointer(out)) ? 0 : 1;
  }
  static int root(double, N_Vector all, N_Vector, double* g, void* data) {
    auto const& self = *static_cast<Ida*>(data);
    double const* const y = N_VGetArrayPointer(all);
    g[0] = event(self.law_, self.plastic_, self.gradient(y + coordinates), y);
    return 0;
  }

  /// Vectors of the size of this phase: state, unknown rates as of now, tolerances, what is differential.
  void fill() {
    memory_.reset();
    kit_ = std::make_unique<DenseKit>(coordinates + unknowns_);
    for (auto* vector : {&all_, &slopes_, &tolerances_, &differential_}) *vector = kit_->vector();
    auto const r = solved_rates(plastic_);
    std::copy(y_.begin(), y_.end(), values());
    std::copy_n(r.data(), unknowns_, values() + coordinates);
    (void)rates(law_, plastic_, gradient(r.data()), y_.data(), N_VGetArrayPointer(slopes_.get()));
    auto const sizes = sizes_of(law_);
    double* const tolerance = N_VGetArrayPointer(tolerances_.get());
    std::transform(sizes.begin(), sizes.end(), tolerance, [](double size) { return relative_tolerance * size; });
    std::fill_n(tolerance + coordinates, unknowns_, relative_tolerance * std::max(segment_->l.norm(), r.norm()));
    std::fill_n(N_VGetArrayPointer(differential_.get()), coordinates, 1.0);
  }

  /// From here with the phase of now. Each phase has an integrator of its own: nothing is left of the last one.
  void restart() {
    fill();
    memory_.reset(IDACreate(kit_->context()));
    void* const m = memory_.get();
    if (m == nullptr) throw std::runtime_error("IDACreate failed");
    check(IDASetErrHandlerFn(m, &keep_message, &said_), "IDASetErrHandlerFn");
    check(IDAInit(m, &equations, t_, all_.get(), slopes_.get()), "IDAInit");
    check(IDASVtolerances(m, relative_tolerance, tolerances_.get()), "IDASVtolerances");
    check(IDASetUserData(m, this), "IDASetUserData");
    check(IDASetLinearSolver(m, kit_->solver(), kit_->matrix()), "IDASetLinearSolver");
    check(IDASetMaxNumSteps(m, 10'000'000), "IDASetMaxNumSteps");
    check(IDASetId(m, differential_.get()), "IDASetId");
    check(IDASetSuppressAlg(m, 1), "IDASetSuppressAlg");
    check(IDASetStopTime(m, until_), "IDASetStopTime");
    check(IDACalcIC(m, IDA_YA_YDP_INIT, until_), "IDACalcIC");
    check(IDAGetConsistentIC(m, all_.get(), slopes_.get()), "IDAGetConsistentIC");
    check(IDARootInit(m, 1, &root), "IDARootInit");
    int direction = plastic_ ? -1 : 1;
    check(IDASetRootDirection(m, &direction), "IDASetRootDirection");
    check(IDASetNoInactiveRootWarn(m), "IDASetNoInactiveRootWarn");
  }

  RateLaw const& law_;
  Coordinates y_;
  std::unique_ptr<DenseKit> kit_;  // freed after all that it made
  OwnedVector all_, slopes_, tolerances_, differential_;
  std::unique_ptr<void, FreeIda> memory_;
  std::string said_;
  MixedSegment const* segment_ = nullptr;
  double t_ = 0, until_ = 0;
  bool plastic_ = false;
  int unknowns_ = 0, events_ = 0;
};

}  // namespace

std::vector<Row> ida_path(RateLaw const& law, State const& start, MixedPath const& path,
                          std::vector<double> const& times) {
  Ida integrator(law, start);
  return follow(integrator, path, times);
}

MixedPath direct_shear(double shear_rate, double duration) {
  return {{duration, velocity_gradient(0, 0, 0, shear_rate), {{1, 1, 0}}}};
}
MixedPath triaxial_compression(double rate, double duration) {
  return {{duration, velocity_gradient(0, -rate, 0, 0), {{0, 0, 0}, {2, 2, 0}}}};
}
MixedPath oedometer(double rate, double duration) {
  return {{duration, velocity_gradient(0, -rate, 0, 0), {}}};
}
MixedPath undrained_shear(double shear_rate, double duration) {
  return {{duration, velocity_gradient(0, 0, 0, shear_rate), {}}};
}
MixedPath isotropic_path(double rate, int normals, double duration) {
  double const each = -rate / normals;
  return {{duration, velocity_gradient(each, each, normals == 3 ? each : 0, 0), {}}};
}

}  // namespace talus::reference
