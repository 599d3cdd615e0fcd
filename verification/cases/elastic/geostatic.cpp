/// A soft column under its own weight, compressed to 0.66 of its height: Hencky's law in closed form
/// (verification/reference/hencky_column.hpp).
///
/// The particles begin at the exact places x(X) with the exact strain, and the scheme finds its own equilibrium: whenever
/// the kinetic energy falls, all velocities are set to zero, until a push no longer moves anything. What is measured is
/// how far that equilibrium is from the exact one. Spacing and particles are refined together.
///
/// "on its twin": two columns foot to foot, pulled towards the middle. That has no wall. "on a wall": one column on a slip
/// wall at a node; kernels reach below it, where there are no particles, so that the first node above it feels the
/// stress at the wall without its counterpart: an error of order 1 in h that stays near the wall. "on a mirror": the wall
/// puts the images there (core/mirror.hpp), and the column is as good as with its twin.

#include <algorithm>
#include <cmath>

#include "verification/suite/cases.hpp"
#include "verification/suite/refinement.hpp"
#include "verification/suite/resting_column.hpp"

namespace talus::verification::elastic_geostatic {

namespace {

void study(Findings& findings, Scheme const& scheme, Foot foot) {
  constexpr char const* names[] = {", on a wall", ", on a mirror", ", on its twin"};
  bool const mirrored = foot != Foot::wall;
  constexpr int cells[] = {10, 20, 40};
  Refinement study;
  study.subject = scheme.name() + names[static_cast<std::size_t>(foot)];
  for (int const N : cells) study.spacings.push_back(column_on_foot.height / N);
  study.norms.resize(2);
  study.norms[0].name = "x over the height";
  study.norms[1].name = "stress over that at the foot";
  if (mirrored) study.norms[0].level = 1e-3;
  study.norms[0].order = mirrored ? 1.8 : 0.85;
  study.norms[0].because = mirrored ? "2 or more: at rest, smoothing by the lumped mass plays no part; 1e-3 at 40 cells"
                                    : "1: the wall's; 1e-3 at 40 cells is not reached";
  study.norms[1].because = "quadrature, and what is next to foot and top";
  study.solve = [&](std::size_t level) { return solved_column(scheme, cells[level], cells[level] / 5, foot); };
  refine(findings, study, "Column");
}

void run(Findings& findings) {
  auto const& exact = column_on_foot;
  findings
      .check("closed form", "height of the card M = 1e5, rho_0 = 1500, H = 10", exact.place(exact.height),
             about(6.6289627048, 1e-10), "computed apart, by quadrature of F")
      .unit = "m";
  for (std::string const kernel : {"quadratic", "cubic"})
    for (Foot const foot : {Foot::twin, Foot::mirror, Foot::wall}) study(findings, {kernel, "flip"}, foot);
}

}  // namespace

Case const the_case{"elastic/geostatic",
                    "A soft column under its own weight, at finite strain",
                    "closed form with Lambert's function",
                    "derived in verification/reference/hencky_column.hpp",
                    1,
                    60,
                    run};

}  // namespace talus::verification::elastic_geostatic
