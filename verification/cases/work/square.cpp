/// Work and precision on the waves along both axes of a square of manufactured/axis_aligned: every scheme, 2 to 4 particles
/// a cell and axis.

#include "verification/manufactured/periodic_box.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/work_precision.hpp"

namespace talus::verification::work_square {

namespace {

void run(Findings& findings) {
  auto const solution = manufactured::solution_of(manufactured::box_motion<2>(), manufactured::box_solid());
  Problem const problem{"waves in a square", "u over A", [&](Scheme const& scheme, int n, int N, Cost& cost) {
                          auto const with = manufactured::box_discretisation<2>(scheme, N, n, 0.4);
                          auto const errors = manufactured::errors_of<2>(drive<2>(solution, with), solution, with);
                          cost += errors.cost;
                          return errors.u / 0.05;
                        }};
  weigh(findings, problem, all_schemes(), {2, 3, 4}, {16, 32, 64, 96});
}

}  // namespace

Case const the_case{"work/square",
                    "Work and precision on waves in a square",
                    "u_i = A sin(2 pi X_i) sin(pi t + phi_i) by its body force, Hencky",
                    "Wallstedt & Guilkey (2008), doi:10.1016/j.jcp.2008.07.019",
                    2,
                    900,
                    run};

}  // namespace talus::verification::work_square
