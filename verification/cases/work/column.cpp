/// Work and precision on the column of elastic/geostatic, on a wall that mirrors: every scheme, 2 to 8 particles a cell.

#include "verification/suite/cases.hpp"
#include "verification/suite/resting_column.hpp"
#include "verification/suite/work_precision.hpp"

namespace talus::verification::work_column {

namespace {

/// Settlement of the top [m].
double const largest = column_on_foot.height - column_on_foot.place(column_on_foot.height);

void run(Findings& findings) {
  Problem const problem{"geostatic column", "settlement over the largest",
                        [](Scheme const& scheme, int n, int N, Cost& cost) {
                          Measured const found = solved_column(scheme, N, n, Foot::mirror);
                          cost += found.cost;
                          return found.errors[0] * column_on_foot.height / largest;
                        }};
  weigh(findings, problem, all_schemes(), {2, 4, 8}, {10, 20, 40, 80});
}

}  // namespace

Case const the_case{"work/column",
                    "Work and precision on a soft column under its own weight",
                    "closed form with Lambert's function",
                    "derived in verification/reference/hencky_column.hpp",
                    2,
                    300,
                    run};

}  // namespace talus::verification::work_column
