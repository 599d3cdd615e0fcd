/// The periodic bar of Hencky's material with every scheme: grid, step and particles are refined together.
///
///   u = A sin(2 pi X) sin(pi t),   A = 0.05 m,   t = 0.5 s                                               (1)
///
/// At N cells there are N/8 particles in a cell and dt = 0.2 h/c. Velocities are those of half a step before. With a
/// lumped mass a B-spline smooths at h^2, whatever its degree: order 2 in u, v and stress. Were the number of particles
/// in a cell fixed, the stress would stay off by the quadrature error (see manufactured/floors).
///
/// The levels were computed once by a program of its own in one dimension, which shares no code with this one.
///
/// Source: (1) Steffen, Wallstedt, Guilkey, Kirby & Berzins (2008), doi:10.3970/cmes.2008.031.107; body force of
/// verification/exact/axis_aligned.hpp.

#include <array>
#include <limits>
#include <map>

#include "verification/manufactured/bar.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/refinement.hpp"

namespace talus::verification::manufactured_bar {

namespace {

using manufactured::bar_discretisation, manufactured::errors_of, manufactured::solution_of;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Errors with N/8 particles in a cell at N = 64 and 256 [m], [m/s], [1].
struct Level {
  std::array<double, 3> at_64, at_256;
};
std::map<std::string, Level> const levels{{"quadratic, flip", {{5.6e-5, 8.1e-4, 1.0e-3}, {3.5e-6, 5.7e-5, 7.9e-5}}},
                                          {"quadratic, apic", {{2.6e-5, 1.4e-4, 5.3e-4}, {1.6e-6, 9.8e-6, 5.2e-5}}},
                                          {"quadratic, aflip", {{2.9e-5, 5.9e-4, 8.9e-4}, {1.7e-6, 3.9e-5, 9.4e-5}}},
                                          {"cubic, flip", {{7.3e-5, 5.7e-4, 5.5e-4}, {4.6e-6, 3.5e-5, 3.4e-5}}},
                                          {"cubic, apic", {{3.1e-5, 1.2e-4, 2.2e-4}, {2.1e-6, 6.5e-6, 1.5e-5}}},
                                          {"cubic, aflip", {{3.6e-5, 1.1e-4, 2.4e-4}, {2.2e-6, 6.5e-6, 1.5e-5}}},
                                          {"linear, flip", {{1.0e-3, 1.4e-2, 2.1e-2}, {1.8e-4, 3.8e-3, 6.2e-3}}},
                                          {"quadratic, pic", {{2.3e-3, none, none}, {6.3e-4, none, none}}},
                                          {"cubic, pic", {{3.0e-3, none, none}, {8.3e-4, none, none}}}};
std::string const of_levels = "level: computed once in one dimension by a program of its own";

/// What is asked of the orders, and of the errors at N = 128: not 15 % above the geometric mean of those at 64 and 256.
std::vector<Norm> norms_of(Scheme const& scheme) {
  std::vector<Norm> norms{{"u", "m"}, {"v", "m/s"}, {"ln F"}};
  if (scheme.transfer == "pic") {
    norms[0].order = 0.85, norms[0].most_order = 1.15;
    norms[0].because = "PIC diffuses at h^2/dt: order 1 at a fixed Courant number";
  } else if (scheme.degree() == 1) {
    norms[0].order = 0.7, norms[0].most_order = 1.4;
    norms[0].because = "the slope of the linear kernel jumps: quadrature of order 1";
  } else {
    norms[0].order = 1.85, norms[1].order = 1.8, norms[2].order = scheme.degree() == 2 ? 1.5 : 1.8;
    for (Norm& norm : norms) norm.because = "lumped mass: order 2";
    if (scheme.degree() == 2) norms[2].because += ", and quadrature that fades more slowly";
  }
  if (auto const known = levels.find(scheme.name()); known != levels.end())
    for (std::size_t k = 0; k < 3; ++k) {
      double const level = std::sqrt(known->second.at_64[k] * known->second.at_256[k]);
      if (!(level > 0)) continue;
      norms[k].level = 1.15 * level;
      norms[k].because += (norms[k].because.empty() ? "" : "; ") + of_levels + ", +15 %";
    }
  return norms;
}

/// The errors at N = 64 over their levels.
void check_level(Findings& findings, Scheme const& scheme, std::array<double, 3> const& errors, Cost const& cost) {
  auto const known = levels.find(scheme.name());
  if (known == levels.end()) return;
  constexpr std::array names{"u", "v", "ln F"};
  for (std::size_t k = 0; k < 3; ++k)
    if (double const level = known->second.at_64[k]; level > 0)
      findings.check(scheme.name(), std::string("error of ") + names[k] + " at h = 1/64 over its level",
                     errors[k] / level, at_most(1.15), of_levels, cost);
}

void refine_bar(Findings& findings, Scheme const& scheme) {
  auto const solution = solution_of(manufactured::bar_motion(), manufactured::bar_solid(exact::ElasticLaw::hencky));
  constexpr std::array cells{16, 32, 64, 128};
  Refinement study{scheme.name(), {}, norms_of(scheme)};
  for (int const N : cells) study.spacings.push_back(1.0 / N);
  study.solve = [&](std::size_t level) {
    int const N = cells[level];
    auto const with = bar_discretisation(scheme, N, N / 8);
    auto const errors = errors_of<2>(drive<2>(solution, with), solution, with);
    if (N == 64) check_level(findings, scheme, {errors.u, errors.v, errors.strain}, errors.cost);
    findings.work.push_back(
        {"bar", "u over A", scheme.kernel, scheme.transfer, N / 8, double(N), errors.u / 0.05, errors.cost});
    return Measured{{errors.u, errors.v, errors.strain}, errors.cost};
  };
  refine(findings, study, "Bar");
}

void run(Findings& findings) {
  for (Scheme const& scheme : all_schemes()) refine_bar(findings, scheme);
}

}  // namespace

Case const the_case{"manufactured/bar",
                    "A periodic bar vibrates, every scheme",
                    "u = A sin(2 pi X) sin(pi t) by its body force, Hencky",
                    "Steffen, Wallstedt, Guilkey, Kirby & Berzins (2008), doi:10.3970/cmes.2008.031.107",
                    1,
                    120,
                    run};

}  // namespace talus::verification::manufactured_bar
