/// Particles on a regular lattice that fills a periodic box: the longest stable step, found by bisection, against von
/// Neumann's analysis (verification/reference/stability/regular.hpp), at the worst place of the lattice in the cells.
///
/// Steps are told as Courant numbers c_p dt/h. All lie above the bound of an isolated particle, from which core chooses
/// its step. stability/map has the same over Poisson's ratio, offset, particles in a cell and stiffness.

#include <fmt/format.h>

#include <cmath>

#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/kinematics/solid.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/stability.hpp"

namespace talus::verification::stability_regular_particles {

namespace {

template <class Kinematics>
void compare(Findings& findings, Scheme const& scheme, PeriodicLattice const& lattice) {
  ElasticScheme const elastic{scheme};
  Cost cost;
  double const predicted = predicted_limit<Kinematics>(elastic, lattice),
               measured = measured_limit<Kinematics>(elastic, lattice, cost);
  std::string const subject = fmt::format("{}, {}-D, {} a cell and axis, offset {:.3f}", scheme.name(),
                                          Kinematics::dimension, lattice.per_axis, lattice.offset[0]);
  findings.note(subject, "longest stable c_p dt/h", measured * elastic.wave_speed(), "", cost);
  findings.check(subject, "longest stable step over the predicted one", measured / predicted, about(1, 0.05),
                 "von Neumann; growth by 1000 in 2000 steps, found to 0.5 %");
  findings.check(subject, "longest stable step over the bound of an isolated particle",
                 measured / isolated_bound<Kinematics>(elastic), at_least(1), "neighbours raise the bound");
}

void run(Findings& findings) {
  for (Scheme const& scheme : all_schemes()) {
    if (scheme.degree() == 1) continue;
    for (int const per_axis : {1, 2})
      compare<kinematics::PlaneStrainReduced>(findings, scheme,
                                              worst_lattice<kinematics::PlaneStrainReduced>({scheme}, per_axis));
  }
  for (std::string const transfer : {"pic", "aflip"}) {
    Scheme const scheme{"quadratic", transfer, "musl"};
    compare<kinematics::PlaneStrainReduced>(findings, scheme,
                                            worst_lattice<kinematics::PlaneStrainReduced>({scheme}, 1));
  }
  compare<kinematics::Solid>(findings, {"quadratic", "flip"}, {1, {0.001, 0.001, 0.001}});
  findings.omit("linear", "all of it", "a least mass at nodes keeps its step finite: no linear theory of the lattice");
}

}  // namespace

Case const the_case{"stability/regular_particles",
                    "The longest step of a lattice of particles",
                    "von Neumann's analysis of the step",
                    "derived in verification/reference/stability/regular.hpp",
                    1,
                    30,
                    run};

}  // namespace talus::verification::stability_regular_particles
