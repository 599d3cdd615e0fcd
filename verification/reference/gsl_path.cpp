#include "verification/reference/gsl_path.hpp"

#include <gsl/gsl_odeiv2.h>

#include <algorithm>

#include "verification/reference/gsl_calls.hpp"

namespace talus::reference {

namespace {

class Gsl {
 public:
  Gsl(RateLaw const& law, State const& start)
      : law_(law),
        y_(coordinates_of(start)),
        step_(gsl::owned<gsl_odeiv2_step_free>(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, coordinates))),
        control_(gsl::owned<gsl_odeiv2_control_free>(gsl_odeiv2_control_scaled_new(
            relative_tolerance, relative_tolerance, 1, 0, sizes_of(law).data(), coordinates))),
        evolve_(gsl::owned<gsl_odeiv2_evolve_free>(gsl_odeiv2_evolve_alloc(coordinates))),
        system_{&derivative, nullptr, coordinates, this} {}
  Gsl(Gsl const&) = delete;
  Gsl& operator=(Gsl const&) = delete;

  void begin(Segment const& segment, double from, double until) {
    segment_ = &segment;
    segment_start_ = t_ = from;
    plastic_ = starts_plastic(law_, plastic_, gradient(from), y_.data());
    events_ = 0;
    h_ = 1e-6 * (until - from);
    restart();
  }

  void advance(double t) {
    while (t_ < t) {
      auto const y = y_;
      double const from = t_, before = event_at(from, y);
      gsl::check(gsl_odeiv2_evolve_apply(evolve_.get(), control_.get(), step_.get(), &system_, &t_, t, &h_, y_.data()),
                 "gsl_odeiv2_evolve_apply");
      double const after = event_at(t_, y_);
      if (plastic_ ? before > 0 && after < 0 : before < 0 && after > 0) change_phase(from, y);
    }
  }

  [[nodiscard]] Row row() const { return row_of(law_, t_, gradient(t_), y_.data(), plastic_); }

 private:
  static int derivative(double t, double const* y, double* dy, void* data) {
    auto const& self = *static_cast<Gsl*>(data);
    return rates(self.law_, self.plastic_, self.gradient(t), y, dy) ? GSL_SUCCESS : GSL_EDOM;
  }

  [[nodiscard]] Matrix gradient(double t) const { return segment_->gradient(t - segment_start_); }
  [[nodiscard]] double event_at(double t, Coordinates const& y) const {
    return event(law_, plastic_, gradient(t), y.data());
  }

  /// One step of that length, without control of the error, which a longer one has passed.
  [[nodiscard]] Coordinates stepped(double from, Coordinates y, double h) const {
    Coordinates error{};
    gsl_odeiv2_step_reset(step_.get());
    gsl::check(gsl_odeiv2_step_apply(step_.get(), from, h, y.data(), error.data(), nullptr, nullptr, &system_),
               "gsl_odeiv2_step_apply");
    return y;
  }

  /// The last step was from there and has passed an event: goes to the event instead.
  void change_phase(double from, Coordinates const& y) {
    if (++events_ > most_events) throw std::runtime_error("GSL: the phases change without end");
    double low = 0, high = t_ - from;
    for (int k = 0; k < 60; ++k) {
      double const middle = 0.5 * (low + high), value = event_at(from + middle, stepped(from, y, middle));
      ((plastic_ ? value > 0 : value < 0) ? low : high) = middle;
    }
    y_ = stepped(from, y, high);
    t_ = from + high;
    plastic_ = !plastic_;
    h_ = 1e-3 * high;
    restart();
  }

  void restart() {
    gsl_odeiv2_step_reset(step_.get());
    gsl_odeiv2_evolve_reset(evolve_.get());
  }

  RateLaw const& law_;
  Coordinates y_;
  gsl::Quiet const quiet_;
  gsl::Owned<gsl_odeiv2_step, gsl_odeiv2_step_free> step_;
  gsl::Owned<gsl_odeiv2_control, gsl_odeiv2_control_free> control_;
  gsl::Owned<gsl_odeiv2_evolve, gsl_odeiv2_evolve_free> evolve_;
  gsl_odeiv2_system system_;
  Segment const* segment_ = nullptr;
  double segment_start_ = 0, t_ = 0, h_ = 0;
  bool plastic_ = false;
  int events_ = 0;
};

}  // namespace

std::vector<Row> gsl_path(RateLaw const& law, State const& start, Path const& path, std::vector<double> const& times) {
  Gsl integrator(law, start);
  return follow(integrator, path, times);
}

}  // namespace talus::reference
