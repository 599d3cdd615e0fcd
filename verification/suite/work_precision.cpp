#include "verification/suite/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/errors.hpp"

namespace talus::verification {

namespace {

constexpr double short_run = 0.3;  // [s]: what takes less is run again
constexpr int most_runs = 3;

WorkPoint measured(Problem const& problem, Scheme const& scheme, int per_direction, int cells) {
  WorkPoint point{problem.name,           problem.error_name, scheme.kernel,
                  scheme.transfer_name(), per_direction,      double(cells)};
  double spent = 0;
  for (int k = 0; k < most_runs && (k == 0 || spent < short_run); ++k) {
    Cost cost;
    point.error = problem.solve(scheme, per_direction, cells, cost);
    spent += cost.seconds;
    if (k == 0 || cost.seconds < point.cost.seconds) point.cost = cost;
  }
  return point;
}

/// The points of one scheme with one number of particles, from the finest grid on.
std::vector<WorkPoint const*> grids_of(std::vector<WorkPoint> const& points, WorkPoint const& like) {
  std::vector<WorkPoint const*> grids;
  for (WorkPoint const& point : points)
    if (point.kernel == like.kernel && point.transfer == like.transfer && point.per_direction == like.per_direction)
      grids.push_back(&point);
  std::ranges::sort(grids, std::greater{}, &WorkPoint::cells);
  return grids;
}

/// Whether the scheme's error is below the given one here and on every finer grid: what crosses it once by chance does
/// not count.
bool stays_below(std::vector<WorkPoint> const& points, WorkPoint const& point, double error) {
  return std::ranges::all_of(grids_of(points, point), [&](WorkPoint const* other) {
    return other->cells < point.cells || other->error <= error;
  });
}

}  // namespace

void tell_cheapest(Findings& findings, std::vector<WorkPoint> const& points) {
  if (points.empty()) return;
  std::string const problem = points.front().problem, error_name = points.front().error_name;
  for (double const error : {0.1, 0.01, 0.001}) {
    WorkPoint const* best = nullptr;
    for (WorkPoint const& point : points)
      if (stays_below(points, point, error) && (best == nullptr || point.cost.seconds < best->cost.seconds))
        best = &point;
    std::string const measure = fmt::format("seconds of the cheapest way to {} %", 100 * error);
    if (best == nullptr) {
      findings.omit(problem, measure, "no scheme came there on these grids");
      continue;
    }
    std::string const how =
        fmt::format("{}, {}, {} particles a cell along an axis, {} cells: {} is {:.2g} %", best->kernel, best->transfer,
                    best->per_direction, best->cells, error_name, 100 * best->error);
    findings.note(problem, measure, best->cost.seconds, how, best->cost).unit = "s";
  }
}

void weigh(Findings& findings, Problem const& problem, std::vector<Scheme> const& schemes,
           std::vector<int> const& per_direction, std::vector<int> const& cells) {
  std::vector<WorkPoint> points;
  for (Scheme const& scheme : schemes)
    for (int const each : per_direction)
      for (int const n : cells) try {
          points.push_back(measured(problem, scheme, each, n));
        } catch (RunError const& error) {
          std::string const text = error.what();
          findings.omit(fmt::format("{}, {} a cell along an axis, {} cells", scheme.name(), each, n),
                        problem.error_name, "it blows up: " + text.substr(0, text.find('\n')));
        }
  tell_cheapest(findings, points);
  findings.omit("linear with apic and aflip", problem.error_name,
                "the affine inertia of the linear kernel is singular at nodes");
  findings.work.insert(findings.work.end(), points.begin(), points.end());
}

}  // namespace talus::verification
