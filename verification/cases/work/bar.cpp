/// Work and precision on the periodic bar of manufactured/bar: every scheme with a fixed number of particles in a cell.
///
/// With that number fixed the particles' quadrature leaves an error of the forces that does not fall with h: of
/// 1/(2 n^2) of the stress with n particles in a cell and the quadratic kernel, of 1/(8 n^3) with the cubic one. Is the
/// cubic kernel with 2 particles better than the quadratic one with 4 beyond 64 cells? The particles are half as many; in the
/// plane it is 64 pairs of particle and node in a cell against 144.
///
/// Source: quadrature of particles: Steffen, Kirby & Berzins (2008), doi:10.1002/nme.2360; the factors derived by the
/// case transfer/quadrature.

#include <fmt/format.h>

#include <algorithm>

#include "verification/manufactured/bar.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/work_precision.hpp"

namespace talus::verification::work_bar {

namespace {

/// The point of that scheme on that grid.
WorkPoint const& point_of(Findings const& findings, char const* kernel, int per_direction, int cells) {
  return *std::find_if(findings.work.begin(), findings.work.end(), [&](WorkPoint const& p) {
    return p.kernel == kernel && p.transfer == "apic" && p.per_direction == per_direction && p.cells == cells;
  });
}

void compare_cubic_with_quadratic(Findings& findings, std::vector<int> const& grids) {
  for (int const N : grids) {
    auto const &cubic = point_of(findings, "cubic", 2, N), &quadratic = point_of(findings, "quadratic", 4, N);
    std::string const subject = fmt::format("apic, {} cells: cubic with 2 over quadratic with 4", N);
    Row& error = findings.note(subject, "error of u", cubic.error / quadratic.error, "", cubic.cost);
    error.because = error.found < 1 ? "better" : "worse";
    findings.note(subject, "time", cubic.cost.seconds / quadratic.cost.seconds);
  }
}

void run(Findings& findings) {
  auto const solution =
      manufactured::solution_of(manufactured::bar_motion(), manufactured::bar_solid(exact::ElasticLaw::hencky));
  Problem const problem{"bar", "u over A", [&](Scheme const& scheme, int n, int N, Cost& cost) {
                          auto const with = manufactured::bar_discretisation(scheme, N, n);
                          auto const errors = manufactured::errors_of<2>(drive<2>(solution, with), solution, with);
                          cost += errors.cost;
                          return errors.u / 0.05;
                        }};
  std::vector<int> const grids{16, 32, 64, 128, 256};
  weigh(findings, problem, all_schemes(), {2, 4, 8}, grids);
  compare_cubic_with_quadratic(findings, grids);
}

}  // namespace

Case const the_case{"work/bar",
                    "Work and precision on the periodic bar",
                    "u = A sin(2 pi X) sin(pi t) by its body force, Hencky",
                    "Steffen, Kirby & Berzins (2008), doi:10.1002/nme.2360",
                    2,
                    300,
                    run};

}  // namespace talus::verification::work_bar
