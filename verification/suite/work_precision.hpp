#pragma once
/// Work and precision: one problem solved by every kernel, transfer and number of particles on several grids, each with
/// its error and what it took.

#include <functional>
#include <string>
#include <vector>

#include "verification/suite/findings.hpp"
#include "verification/suite/scheme.hpp"

namespace talus::verification {

/// A problem that any scheme may solve. `solve` gives the error relative to the solution's size [1] and adds what it
/// took; it may throw RunError where the scheme blows up.
struct Problem {
  std::string name, error_name;
  std::function<double(Scheme const&, int per_direction, int cells, Cost&)> solve;
};

/// Adds rows that tell the cheapest way to an error of 10, 1 and 0.1 % among the points of one problem. Only a grid from
/// which on the scheme stays below that error counts.
void tell_cheapest(Findings& findings, std::vector<WorkPoint> const& points);

/// Solves `problem` by all of `schemes` with each number of particles in a cell along an axis on each grid, adds the
/// points and what `tell_cheapest` tells of them. A short run is repeated, and the shortest time counts.
/// What blows up is told as omitted, with the reason.
void weigh(Findings& findings, Problem const& problem, std::vector<Scheme> const& schemes,
           std::vector<int> const& per_direction, std::vector<int> const& cells);

}  // namespace talus::verification
