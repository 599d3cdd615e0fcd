/// The granular dam break on a slope of 22 degrees on four grids: how far its figures are from those of an infinitely
/// fine one. There is no exact solution. The shipped study is run, its particles on a lattice.
///
/// Source: problem: Mangeney et al. (2010), doi:10.1029/2009JF001462; grid convergence index: Roache (1994),
/// doi:10.1115/1.2910291; least squares: Eca & Hoekstra (2014), doi:10.1016/j.jcp.2014.01.006.

#include <fmt/format.h>

#include "verification/suite/cases.hpp"
#include "verification/suite/dam_break.hpp"
#include "verification/suite/richardson.hpp"

namespace talus::verification::granular_dam_break {

namespace {

constexpr double end = 0.4;  // of the runs [s]

/// What is looked at, in the words of the series.
std::vector<std::string> const measures{"centre_of_mass_x", "centre_of_mass_y", "front", "kinetic_energy"};

void run(Findings& findings) {
  std::vector<double> spacings;
  std::vector<std::vector<double>> values(measures.size());
  for (int const n : {20, 28, 40, 56}) {
    spacings.push_back(heap_height / n);
    Document document = dam_break(n, 3);
    set_value(document, R"(/output/ledger={"type": "none"})");
    Cost cost;
    auto const found = run_to(document, end, measures, cost).values;
    for (std::size_t k = 0; k < measures.size(); ++k) {
      values[k].push_back(found[k]);
      findings.note(measures[k], fmt::format("value with {} cells in the height", n), found[k], "",
                    k == 0 ? cost : Cost{});
    }
  }
  for (std::size_t k = 0; k < measures.size(); ++k) {
    std::string const subject = measures[k];
    double const fine = std::abs(values[k].back());
    auto const three = convergence_of_three(spacings, values[k]);
    auto const all = convergence_by_least_squares(spacings, values[k]);
    findings.note(subject, "observed order of the three finest", three.order,
                  three.approach == Approach::monotone ? "" : "the approach is not monotone");
    findings.note(subject, "grid convergence index, relative", three.uncertainty / fine, "Roache (1994)");
    if (k < 2)
      findings.check(subject, "uncertainty by least squares, relative", all.uncertainty / fine, at_most(0.05),
                     "the shipped study's tolerance is 1 %: on a grid of half the spacing");
    else
      findings.note(subject, "uncertainty by least squares, relative", all.uncertainty / fine, "Eca & Hoekstra (2014)");
    findings.plots.push_back({fmt::format("Dam break: {} at t = {} s", subject, end),
                              "h [m]",
                              subject,
                              true,
                              false,
                              {Curve{"runs", spacings, values[k]}}});
  }
}

}  // namespace

Case const the_case{"granular/dam_break",
                    "Grid refinement of the dam break on 22 degrees",
                    "itself on finer grids: Richardson extrapolation, grid convergence index",
                    "Mangeney et al. (2010), doi:10.1029/2009JF001462; Roache (1994), doi:10.1115/1.2910291",
                    2,
                    600,
                    run};

}  // namespace talus::verification::granular_dam_break
