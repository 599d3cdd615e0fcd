/// The periodic bar of a neo-Hookean material, whose body force is b = (E/rho_0) pi^2 u (1 + 2/F^2): a second law on the
/// same path from force to motion. See manufactured/bar.
///
/// Source: Steffen, Wallstedt, Guilkey, Kirby & Berzins (2008), doi:10.3970/cmes.2008.031.107.

#include "verification/manufactured/bar.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/refinement.hpp"

namespace talus::verification::manufactured_bar_neo_hookean {

namespace {

void run(Findings& findings) {
  auto const solution =
      manufactured::solution_of(manufactured::bar_motion(), manufactured::bar_solid(exact::ElasticLaw::neo_hookean));
  constexpr std::array cells{16, 32, 64};
  for (Scheme const& scheme : {Scheme{"quadratic", "apic"}, Scheme{"cubic", "aflip"}}) {
    Refinement study{scheme.name(), {}, {}};
    for (int const N : cells) study.spacings.push_back(1.0 / N);
    std::string const why = "lumped mass: order 2";
    study.norms = {{.name = "u", .unit = "m", .order = 1.85, .because = why},
                   {.name = "v", .unit = "m/s", .order = 1.8, .because = why},
                   {.name = "ln F", .order = scheme.degree() == 2 ? 1.5 : 1.8, .because = why}};
    study.solve = [&](std::size_t level) {
      auto const with = manufactured::bar_discretisation(scheme, cells[level], cells[level] / 8);
      auto const errors = manufactured::errors_of<2>(drive<2>(solution, with), solution, with);
      return Measured{{errors.u, errors.v, errors.strain}, errors.cost};
    };
    refine(findings, study, "Neo-Hookean bar");
  }
}

}  // namespace

Case const the_case{"manufactured/bar_neo_hookean",
                    "A periodic neo-Hookean bar vibrates",
                    "u = A sin(2 pi X) sin(pi t) by its body force",
                    "Steffen, Wallstedt, Guilkey, Kirby & Berzins (2008), doi:10.3970/cmes.2008.031.107",
                    1,
                    20,
                    run};

}  // namespace talus::verification::manufactured_bar_neo_hookean
