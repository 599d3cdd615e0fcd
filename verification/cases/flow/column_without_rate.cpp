/// The periodic column on 28 degrees without rate dependence: it stops where mu > tan(slope) and speeds up where mu is less.
///
///   mu = tan 35 deg:  u = max(0, U y/h + a t), rigid from the base on; all has stopped at U/|a|        (1)
///   mu = tan 21 deg:  u = U y/h + a t above a layer that slips at the base                               (2)
///   a = g (sin(slope) - mu cos(slope))
///
/// Source: Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figure 31; (1), (2): verification/reference/flow.

#include <cmath>
#include <limits>

#include "verification/reference/flow/fluid.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/settled_column.hpp"

namespace talus::verification::flow_column_without_rate {

namespace {

constexpr double top_speed = 4;  // U [m/s]

SettledColumn column_of(double angle) {
  double const mu = reference::flow::tangent(angle);
  SettledColumn column{bead_layer(28), [](double Y) { return top_speed * Y / FlowColumn::height; }};
  column.layer.layer.fluid.friction.mu_1 = column.layer.layer.fluid.friction.mu_2 = mu;
  return column;
}

double acceleration(double angle) {
  double const slope = reference::flow::radians(28);
  return reference::flow::gravity * (std::sin(slope) - reference::flow::tangent(angle) * std::cos(slope));
}

/// When the surface stops: its speed falls below a thousandth of U.
void stopping(Findings& findings, Scheme const& scheme) {
  SettledColumn column = column_of(35);
  column.scheme = scheme;
  double const exact = -top_speed / acceleration(35);
  auto const times = evenly(0.05, 3.2, 63);
  Cost cost;
  auto const flows = profiles_of(column, times, cost);
  double stopped = std::numeric_limits<double>::quiet_NaN();
  Plot plot{"Column without rate dependence: surface speed", "t [s]", "u [m/s]"};
  Curve curve{scheme.name()}, line{"exact"};
  line.guide = true;
  for (std::size_t k = 0; k < times.size(); ++k) {
    curve.x.push_back(times[k]);
    curve.y.push_back(flows[k].surface());
    line.x.push_back(times[k]);
    line.y.push_back(std::max(0.0, 0.975 * top_speed + acceleration(35) * times[k]));
    if (!(stopped > 0) && flows[k].surface() < 1e-3 * top_speed) stopped = times[k];
  }
  plot.curves = {curve, line};
  findings.plots.push_back(plot);
  std::string const subject = scheme.name() + ", mu = tan 35 deg", what = "time at which it has stopped over U/|a|";
  if (scheme.alpha == 1)
    findings.check(subject, what, stopped / exact, about(1, 0.02), "2 %; looked at every 0.05 s", cost);
  else
    findings.note(subject, what, stopped / exact, "what a transfer loses smears the edge of what is at rest", cost);
}

void speeding_up(Findings& findings) {
  SettledColumn column = column_of(21);
  column.scheme.alpha = 1;
  Cost cost;
  auto const flows = profiles_of(column, {0.2, 1.0}, cost);
  double gained = 0;
  for (std::size_t s = slices / 2; s < slices; ++s) gained += (flows[1].u[s] - flows[0].u[s]) / (slices - slices / 2);
  findings.check("mu = tan 21 deg", "acceleration of the upper half over a", gained / 0.8 / acceleration(21),
                 about(1, 0.01), "1 %", cost);
}

void run(Findings& findings) {
  for (double const alpha : {1.0, 0.95, 0.0}) stopping(findings, {"quadratic", "aflip", "usl", alpha});
  speeding_up(findings);
}

}  // namespace

Case const the_case{"flow/column_without_rate",
                    "A column without rate dependence stops, or speeds up",
                    "closed form of the rigid-plastic layer",
                    "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figure 31",
                    2,
                    300,
                    run};

}  // namespace talus::verification::flow_column_without_rate
