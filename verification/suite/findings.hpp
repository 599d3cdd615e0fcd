#pragma once
/// What a case of the suite finds: rows with a verdict each, plots, and points for work-precision diagrams.

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace talus::verification {

/// floored: an order was asked for where the error no longer falls with h. omitted: not run, for the reason given.
/// noted: measured, nothing asked of it. error: the case did not get so far; said by the runner, not by cases. Only pass,
/// omitted and noted leave the suite green.
enum class Verdict { pass, fail, floored, omitted, noted, error };

/// What a run took: wall time of its steps [s], steps, particles times steps.
struct Cost {
  double seconds = 0;
  long steps = 0;
  double particle_steps = 0;

  Cost& operator+=(Cost const& b) {
    seconds += b.seconds;
    steps += b.steps;
    particle_steps += b.particle_steps;
    return *this;
  }
};

/// A closed interval; an end that is left out does not bind.
struct Interval {
  std::optional<double> low = {}, high = {};
  /// False for what is not a number.
  [[nodiscard]] bool contains(double value) const {
    return !(low && !(value >= *low)) && !(high && !(value <= *high)) && value == value;
  }
};
[[nodiscard]] inline Interval at_least(double low) {
  return {low, {}};
}
[[nodiscard]] inline Interval at_most(double high) {
  return {{}, high};
}
/// value (1 -+ relative).
[[nodiscard]] inline Interval about(double value, double relative) {
  double const slack = (value < 0 ? -value : value) * relative;
  return {value - slack, value + slack};
}

/// One value and what was asked of it.
struct Row {
  std::string subject;  ///< which of the things that were varied: "quadratic, apic"
  std::string measure;  ///< what was measured: "order of u"
  std::string unit = "1";
  double found = std::numeric_limits<double>::quiet_NaN();
  Interval allowed = {};
  Interval uncertainty = {};  ///< 95 % interval of what was found
  Verdict verdict = Verdict::noted;
  std::string because = {};  ///< where the bar comes from; why omitted, why floored
  Cost cost = {};
};

/// Points of one colour. `guide`: a line to compare with, dashed.
struct Curve {
  std::string name;
  std::vector<double> x = {}, y = {};
  bool guide = false;
};

/// Axis labels bear the units.
struct Plot {
  std::string title, x_label, y_label;
  bool log_x = false, log_y = false;
  std::vector<Curve> curves = {};
};

/// One run of a work-precision study: a scheme at a resolution, its error and what it took.
struct WorkPoint {
  std::string problem, error_name;
  std::string kernel, transfer;
  int per_direction = 0;  ///< particles in a cell along an axis
  double cells = 0;       ///< resolution: cells in the problem's length
  double error = 0;       ///< relative [1]
  Cost cost = {};
};

/// What one case found.
class Findings {
 public:
  std::vector<Row> rows;
  std::vector<Plot> plots;
  std::vector<WorkPoint> work;

  /// A value that must lie in an interval.
  Row& check(std::string subject, std::string measure, double found, Interval allowed, std::string because,
             Cost cost = {});
  /// A value of which nothing is asked.
  Row& note(std::string subject, std::string measure, double found, std::string because = {}, Cost cost = {});
  /// What was not run.
  void omit(std::string subject, std::string measure, std::string because);
};

}  // namespace talus::verification
