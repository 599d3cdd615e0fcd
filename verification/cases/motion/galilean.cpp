/// The periodic bar from a train: everything moves along it with velocity V as well, over no whole number of cells.
///
/// The equations are the same in the moving frame; a scheme on a grid at rest is not quite, since its error depends on
/// how often particles cross cells. The errors of both must be alike. A sideways velocity moves the strip across its
/// period, too.
///
/// Source: the bar: Steffen, Wallstedt, Guilkey, Kirby & Berzins (2008), doi:10.3970/cmes.2008.031.107.

#include "verification/manufactured/bar.hpp"
#include "verification/suite/cases.hpp"

namespace talus::verification::motion_galilean {

namespace {

constexpr int cells = 64, per_cell = 8;

void run(Findings& findings) {
  auto const at_rest =
      manufactured::solution_of(manufactured::bar_motion(), manufactured::bar_solid(exact::ElasticLaw::hencky));
  auto const moving = manufactured::carried<2>(at_rest, {0.743, 0.0917});  // 23.776 and 2.9344 cells
  for (std::string const kernel : {"quadratic", "cubic"})
    for (std::string const transfer : {"pic", "flip", "apic", "aflip"}) {
      Scheme const scheme{kernel, transfer};
      auto const with = manufactured::bar_discretisation(scheme, cells, per_cell);
      auto const still = manufactured::errors_of<2>(drive<2>(at_rest, with), at_rest, with);
      auto const moved = manufactured::errors_of<2>(drive<2>(moving, with), moving, with);
      findings.check(scheme.name(), "error of u in motion over that at rest", moved.u / still.u, at_most(2),
                     "the frame must not matter; twice the error is allowed for crossings", moved.cost);
      findings.note(scheme.name(), "error of v in motion over that at rest", moved.v / still.v);
      findings.note(scheme.name(), "error of ln F in motion over that at rest", moved.strain / still.strain);
    }
}

}  // namespace

Case const the_case{"motion/galilean",
                    "A vibrating bar from a moving train",
                    "the same bar at rest",
                    "Steffen, Wallstedt, Guilkey, Kirby & Berzins (2008), doi:10.3970/cmes.2008.031.107",
                    1,
                    30,
                    run};

}  // namespace talus::verification::motion_galilean
