/// Work and precision on the column of elastic/geostatic, on a wall: every scheme, 2 to 8 particles a cell.

#include "verification/suite/cases.hpp"
#include "verification/suite/resting_column.hpp"
#include "verification/suite/work_precision.hpp"

namespace talus::verification {

namespace {

void run(Findings& findings) {
  Problem const problem{"geostatic column", "place over the height",
                        [](Scheme const& scheme, int n, int N, Cost& cost) {
                          Measured const found = solved_column(scheme, N, n, false);
                          cost += found.cost;
                          return found.errors[0];
                        }};
  weigh(findings, problem, all_schemes(), {2, 4, 8}, {10, 20, 40});
}

}  // namespace

Case const work_column{"work/column",
                       "Work and precision on a soft column under its own weight",
                       "closed form with Lambert's function",
                       "derived in verification/reference/hencky_column.hpp",
                       2,
                       300,
                       run};

}  // namespace talus::verification
