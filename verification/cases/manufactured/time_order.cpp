/// The order of the steps in time, apart from the grid: the bar on one grid with one set of particles, the step halved
/// again and again, against a run with far shorter steps.
///
///   u = A sin(2 pi X) sin(pi t + pi/4),   A = 1e-4 m                                                     (1)
///
/// Symplectic Euler is the leapfrog scheme if velocities live at half steps: order 2. Taken to live at whole steps, when
/// they start and when they are looked at, they are off by dt/2: order 1. (1) starts with an acceleration, so that this
/// shows.
///
/// Particles move with P v + dt a: the old velocity smoothed by the transfer P, the increment not. That leaves a term of
/// h^2 dt, beyond the order of the grid, which takes over where dt << h: the steps are therefore near the stable one. At
/// 0.05 m quadrature adds to it, and the order is only noted. The schemes keep the increment, for those that replace
/// velocities diffuse at h^2/dt.
///
/// Source: the bar: Steffen, Wallstedt, Guilkey, Kirby & Berzins (2008), doi:10.3970/cmes.2008.031.107; the half steps:
/// Hairer, Lubich & Wanner (2003), doi:10.1017/S0962492902000144 (not re-read).

#include <array>
#include <map>
#include <optional>

#include "verification/manufactured/bar.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/refinement.hpp"

namespace talus::verification::manufactured_time_order {

namespace {

constexpr int cells = 64, per_cell = 4;
constexpr double finest = 1.0 / 80;  ///< Courant number of the run to compare with
constexpr std::array courants{0.8, 0.4, 0.2, 0.1};

using Field = std::vector<Point<2>>;

double distance(Field const& a, Field b) {
  for (std::size_t p = 0; p < a.size(); ++p) b[p] -= a[p];
  return root_mean_square(b);
}

manufactured::Solution<2> bar_of(double amplitude) {
  auto motion = manufactured::bar_motion();
  motion.amplitude[0] = amplitude;
  motion.phase[0] = std::numbers::pi / 4;
  return manufactured::solution_of(motion, manufactured::bar_solid(exact::ElasticLaw::hencky));
}

/// The fine run: displacements at the end, velocities after each of its last steps and of one more.
struct Reference {
  Field u;
  std::map<long, Field> v;
  long end = 0;

  /// At `steps` fine steps before the end, a whole step: the mean of the two half steps around it.
  [[nodiscard]] Field velocity(long steps) const {
    Field mean = v.at(end - steps);
    Field const& next = v.at(end - steps + 1);
    for (std::size_t p = 0; p < mean.size(); ++p) mean[p] = 0.5 * (mean[p] + next[p]);
    return mean;
  }
};

Reference reference_of(Scheme const& scheme, manufactured::Solution<2> const& solution) {
  auto with = manufactured::bar_discretisation(scheme, cells, per_cell, finest);
  Reference reference;
  reference.end = with.steps;
  reference.u = drive<2>(solution, with).u;
  with.after_each = [&](Simulation<2> const& simulation) {
    long const step = simulation.step_count();
    if (step >= reference.end - std::lround(courants[0] / finest)) reference.v[step] = vectors(simulation, "velocity");
  };
  ++with.steps;
  (void)drive<2>(solution, with);
  return reference;
}

/// asked: the order to be found, or nothing.
void refine_steps(Findings& findings, Scheme const& scheme, double amplitude, double lag, std::optional<double> asked) {
  auto const solution = bar_of(amplitude);
  Reference const reference = reference_of(scheme, solution);
  Refinement study{scheme.name() + (lag > 0 ? ", half steps" : ", whole steps") + (asked ? "" : ", A = 0.05 m")};
  study.norms = {{.name = "u", .unit = "m", .because = "start and step each leave their share"},
                 {.name = "v", .unit = "m/s", .because = "h^2 dt, and quadrature where A is large"}};
  if (asked && lag > 0) {
    study.norms[0].order = *asked - 0.2, study.norms[0].most_order = *asked + 0.2;
    study.norms[0].because = "leapfrog: order 2";
  } else if (asked) {
    study.norms[1].order = *asked - 0.15, study.norms[1].most_order = *asked + 0.15;
    study.norms[1].because = "velocities half a step off: order 1";
  }
  study.variable = "dt", study.variable_unit = "s";
  for (double const courant : courants) study.spacings.push_back(courant / cells);
  study.solve = [&](std::size_t level) {
    auto with = manufactured::bar_discretisation(scheme, cells, per_cell, courants[level]);
    with.lag = lag;
    auto const driven = drive<2>(solution, with);
    auto const back = std::lround(lag * courants[level] / finest);
    return Measured{{distance(reference.u, driven.u), distance(reference.velocity(back), driven.v)}, driven.cost};
  };
  refine(findings, study, "Time steps");
}

void run(Findings& findings) {
  for (std::string const kernel : {"quadratic", "cubic"}) {
    refine_steps(findings, {kernel, "aflip"}, 1e-4, 0.5, 2);
    refine_steps(findings, {kernel, "aflip"}, 1e-4, 0, 1);
    refine_steps(findings, {kernel, "flip"}, 1e-4, 0.5, 2);
    refine_steps(findings, {kernel, "aflip"}, 0.05, 0.5, {});
  }
}

}  // namespace

Case const the_case{"manufactured/time_order",
                    "The bar with shorter and shorter steps",
                    "a run on the same grid with far shorter steps",
                    "Steffen, Wallstedt, Guilkey, Kirby & Berzins (2008), "
                    "doi:10.3970/cmes.2008.031.107",
                    1,
                    20,
                    run};

}  // namespace talus::verification::manufactured_time_order
