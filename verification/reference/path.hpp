#pragma once
/// Paths of deformation, and how an integrator follows one.

#include <stdexcept>
#include <vector>

#include "verification/reference/material_point.hpp"

namespace talus::reference {

/// A velocity gradient l [1/s] for a duration [s]. `turn` [rad/s]: its axes turn about z, l(t) = R(turn t) l R^T.
struct Segment {
  double duration;
  Matrix l;
  double turn;

  [[nodiscard]] Matrix gradient(double t) const;
};
using Path = std::vector<Segment>;

/// l with the three normal rates, and the simple shear l_xy.
[[nodiscard]] Matrix velocity_gradient(double xx, double yy, double zz, double xy);

/// Relative error that the integrators are asked to keep in a step.
inline constexpr double relative_tolerance = 1e-13;

/// More changes between elastic and plastic than this in a segment are a mistake.
inline constexpr int most_events = 1000;

/// The rows at `times`, which do not decrease and lie within the path; at the end of a segment the row is of that
/// segment. An integrator has begin(segment, start of the segment, its end), advance(t) and row().
template <class Integrator, class Segments>
[[nodiscard]] std::vector<Row> follow(Integrator& integrator, Segments const& path, std::vector<double> const& times) {
  std::vector<Row> rows;
  auto next = times.begin();
  double begin = 0;
  for (auto const& segment : path) {
    double const end = begin + segment.duration;
    integrator.begin(segment, begin, end);
    for (; next != times.end() && *next <= end; ++next) {
      if (*next > begin) integrator.advance(*next);
      rows.push_back(integrator.row());
    }
    integrator.advance(end);
    begin = end;
  }
  if (next != times.end()) throw std::invalid_argument("a row is asked for after the end of the path");
  return rows;
}

}  // namespace talus::reference
