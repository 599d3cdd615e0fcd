/// Waves along all three axes of a periodic cube: see manufactured/axis_aligned.
///
///   u_i = A sin(2 pi X_i) sin(pi t),   A = 0.05 m,   t = 0.5 s
///
/// 8, 16 and 32 cells with 1, 2 and 4 particles a cell and axis.
///
/// Source: Wallstedt & Guilkey (2008), doi:10.1016/j.jcp.2008.07.019.

#include <array>

#include "verification/manufactured/periodic_box.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/refinement.hpp"

namespace talus::verification::manufactured_axis_aligned_3d {

namespace {

constexpr std::array cells{8, 16, 32};

void run(Findings& findings) {
  auto const solution = manufactured::solution_of(manufactured::box_motion<3>(), manufactured::box_solid());
  for (Scheme const& scheme : {Scheme{"quadratic", "apic"}, Scheme{"cubic", "aflip"}}) {
    Refinement study{scheme.name()};
    study.norms = {{.name = "u", .unit = "m", .order = 1.8, .because = "lumped mass: order 2, less the coarse grid"},
                   {.name = "v", .unit = "m/s"},
                   {.name = "ln F"}};
    for (int const N : cells) study.spacings.push_back(1.0 / N);
    study.solve = [&](std::size_t level) {
      auto const with = manufactured::box_discretisation<3>(scheme, cells[level], cells[level] / 8, 0.4);
      auto const errors = manufactured::errors_of<3>(drive<3>(solution, with), solution, with);
      return Measured{{errors.u, errors.v, errors.strain}, errors.cost};
    };
    refine(findings, study, "Periodic cube");
  }
}

}  // namespace

Case const the_case{"manufactured/axis_aligned_3d",
                    "Waves along the axes of a cube",
                    "u_i = A sin(2 pi X_i) sin(pi t) by its body force, Hencky",
                    "Wallstedt & Guilkey (2008), doi:10.1016/j.jcp.2008.07.019",
                    2,
                    300,
                    run};

}  // namespace talus::verification::manufactured_axis_aligned_3d
