/// Work and precision on the steady column of flow/column: every scheme, begun as the exact layer, and how far it has
/// left it after 2 to 2.5 s.

#include "verification/suite/cases.hpp"
#include "verification/suite/settled_column.hpp"
#include "verification/suite/work_precision.hpp"

namespace talus::verification::work_flow_column {

namespace {

void run(Findings& findings) {
  auto const layer = bead_layer(28);
  SteadyLayer const exact(layer);
  Problem const problem{"flowing column", "error of the profile", [&](Scheme const& scheme, int n, int N, Cost& cost) {
                          SettledColumn column = steady_column(layer, exact, N);
                          column.scheme = scheme;
                          column.per_axis = n;
                          column.width = 8;
                          auto const flow = mean_of(profiles_of(column, evenly(2, 2.5, 10), cost));
                          return profile_error(flow, exact.profile);
                        }};
  auto schemes = all_schemes();
  for (std::string const kernel : {"quadratic", "cubic"}) schemes.push_back({kernel, "aflip", "usl", 0.95});
  weigh(findings, problem, schemes, {2, 3}, {10, 20, 40});
}

}  // namespace

Case const the_case{"work/flow_column",
                    "Work and precision on the steady column on a slope",
                    "compressible layer, by quadrature",
                    "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, figure 29",
                    2,
                    3600,
                    run};

}  // namespace talus::verification::work_flow_column
