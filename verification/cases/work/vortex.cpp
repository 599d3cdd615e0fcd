/// Work and precision on the vortex of manufactured/vortex: every scheme, 2 to 4 particles a cell and axis.

#include "verification/manufactured/vortex.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/work_precision.hpp"

namespace talus::verification::work_vortex {

namespace {

/// Largest displacement of the ring: that of its middle, which turns by 0.1 rad.
constexpr double largest = 0.1;

void run(Findings& findings) {
  auto const solution = manufactured::solution_of(manufactured::vortex_motion(), manufactured::vortex_solid());
  Problem const problem{"vortex", "u over its largest", [&](Scheme const& scheme, int n, int N, Cost& cost) {
                          auto const with = manufactured::vortex_discretisation(scheme, N, n);
                          auto const errors = manufactured::errors_of<2>(drive<2>(solution, with), solution, with);
                          cost += errors.cost;
                          return errors.u / largest;
                        }};
  weigh(findings, problem, all_schemes(), {2, 3, 4}, {24, 48, 96, 144});
}

}  // namespace

Case const the_case{"work/vortex",
                    "Work and precision on the vortex",
                    "theta = Theta + A sin(pi t) g(R) by its body force, Hencky, q = 4",
                    "Kamojjala, Brannon, Sadeghirad & Guilkey (2015), doi:10.1007/s00366-013-0342-x",
                    2,
                    900,
                    run};

}  // namespace talus::verification::work_vortex
