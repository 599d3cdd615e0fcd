/// Waves along both axes of a periodic square at once: what the bar cannot see of the second axis.
///
///   u_i = A sin(2 pi X_i) sin(pi t + phi_i),   phi = (0, pi),   A = 0.05 m,   t = 0.5 s                  (1)
///
/// N/8 particles a cell and axis. The same in a box with frictionless walls, on which (1) vanishes and which lie on
/// nodes, with phi = (pi, pi) so that the walls are pushed, and with phi = (0, 0) so that they are pulled. A node one
/// cell inside still weighs 1/8 on a wall, so that the wall is soft by O(h): order 1 at best.
///
/// Source: (1) Wallstedt & Guilkey (2008), doi:10.1016/j.jcp.2008.07.019.

#include "models/boundaries/contacts/slip.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/boundaries/motions/fixed.hpp"
#include "models/boundaries/shapes/container.hpp"
#include "verification/manufactured/periodic_box.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/refinement.hpp"

namespace talus::verification::manufactured_axis_aligned {

namespace {

Measured solve(Scheme const& scheme, manufactured::Solution<2> const& solution, int N, bool walled) {
  auto with = manufactured::box_discretisation<2>(scheme, N, N / 8, 0.4);
  if (walled) {
    with.periods = {};
    with.adds = [](Scene<2>& scene) {
      scene.walls.push_back(
          make_wall<2, wall::Container, wall::Slip, wall::Fixed>("box", {{0, 0, 0}, {1, 1, 1}}, {}, {}));
    };
  }
  auto const errors = manufactured::errors_of<2>(drive<2>(solution, with), solution, with);
  return {{errors.u, errors.v, errors.strain}, errors.cost};
}

Refinement study_of(std::string const& subject, std::vector<int> const& cells, Norm const& u) {
  Refinement study{subject, {}, {u, {.name = "v", .unit = "m/s"}, {.name = "ln F"}}};
  for (int const N : cells) study.spacings.push_back(1.0 / N);
  return study;
}

void periodic(Findings& findings, Scheme const& scheme) {
  std::vector<int> const cells{16, 32, 64};
  auto const solution = manufactured::solution_of(manufactured::box_motion<2>(), manufactured::box_solid());
  auto study =
      study_of(scheme.name(), cells,
               {.name = "u", .unit = "m", .order = 1.8, .because = "lumped mass: order 2, less the coarse grid"});
  study.solve = [&](std::size_t level) { return solve(scheme, solution, cells[level], false); };
  refine(findings, study, "Periodic square");
}

void walled(Findings& findings, Scheme const& scheme, double phase, std::string const& walls, double order) {
  std::vector<int> const cells{16, 24, 32};
  auto motion = manufactured::box_motion<2>();
  motion.phase = Point<2>::Constant(phase);
  auto const solution = manufactured::solution_of(motion, manufactured::box_solid());
  auto study = study_of(scheme.name() + ", walls " + walls, cells,
                        {.name = "u", .unit = "m", .order = order, .because = "a wall is soft by O(h)"});
  study.solve = [&](std::size_t level) { return solve(scheme, solution, cells[level], true); };
  refine(findings, study, "Walled square");
}

void run(Findings& findings) {
  for (std::string const kernel : {"quadratic", "cubic"})
    for (std::string const transfer : {"flip", "apic", "aflip"}) periodic(findings, {kernel, transfer});
  walled(findings, {"quadratic", "apic"}, std::numbers::pi, "pushed", 0.8);
  walled(findings, {"quadratic", "apic"}, 0, "pulled", 0.8);
}

}  // namespace

Case const the_case{"manufactured/axis_aligned",
                    "Waves along both axes of a square",
                    "u_i = A sin(2 pi X_i) sin(pi t + phi_i) by its body force, Hencky",
                    "Wallstedt & Guilkey (2008), doi:10.1016/j.jcp.2008.07.019",
                    1,
                    120,
                    run};

}  // namespace talus::verification::manufactured_axis_aligned
