/// The generalised vortex with a smooth rim (q = 4) in Hencky's material: rings that turn against each other, so that
/// the order of the factors of F and the axes of C matter, as they do not along one axis.
///
///   A = 0.1, t = 0.5 s, E = 1000 Pa, nu = 0.3, rho_0 = 1000 kg/m^3; square of 3 m, periodic and full of material
///
/// 24, 48 and 96 cells with 2, 3 and 4 particles a cell and axis. Outside of the ring nothing moves.
///
/// The levels were computed once by a program of its own, which shares no code with this one.
///
/// Source: Kamojjala, Brannon, Sadeghirad & Guilkey (2015), doi:10.1007/s00366-013-0342-x; q = 4 and the body force:
/// verification/exact/vortex.hpp.

#include <array>
#include <limits>

#include "verification/manufactured/vortex.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/refinement.hpp"

namespace talus::verification::manufactured_vortex {

namespace {

constexpr std::array cells{24, 48, 96}, per_axis{2, 3, 4};

/// Errors of u [m], v [m/s] and tau/G on the finest grid.
using Levels = std::array<double, 3>;

void refine_vortex(Findings& findings, Scheme const& scheme, double order, Levels const& levels) {
  auto const solid = manufactured::vortex_solid();
  auto const solution = manufactured::solution_of(manufactured::vortex_motion(), solid);
  std::string const why = "lumped mass: order 2; level: computed once by a program of its own, +15 %";
  Refinement study{scheme.name(), {}, {}};
  study.norms = {{.name = "u", .unit = "m", .order = order, .level = 1.15 * levels[0], .because = why},
                 {.name = "v", .unit = "m/s", .level = 1.15 * levels[1], .because = why},
                 {.name = "tau/G", .level = 1.15 * levels[2], .because = why}};
  for (int const N : cells) study.spacings.push_back(manufactured::vortex_side / N);
  study.solve = [&](std::size_t level) {
    auto const with = manufactured::vortex_discretisation(scheme, cells[level], per_axis[level]);
    auto const errors = manufactured::errors_of<2>(drive<2>(solution, with), solution, with);
    return Measured{{errors.u, errors.v, errors.stress / solid.G}, errors.cost};
  };
  refine(findings, study, "Vortex");
}

void run(Findings& findings) {
  constexpr double not_asked = std::numeric_limits<double>::quiet_NaN();
  refine_vortex(findings, {"quadratic", "aflip"}, 1.7, {2.9e-4, 1.3e-3, 8.2e-3});
  refine_vortex(findings, {"quadratic", "apic"}, 1.7, {1.8e-4, 2.2e-3, 6.7e-3});
  refine_vortex(findings, {"quadratic", "flip"}, not_asked, {8.0e-4, 4.6e-3, 1.7e-2});
  refine_vortex(findings, {"cubic", "aflip"}, not_asked, {4.0e-4, 1.3e-3, 7.9e-3});
  refine_vortex(findings, {"cubic", "apic"}, not_asked, {2.0e-4, 3.6e-3, 6.3e-3});
}

}  // namespace

Case const the_case{"manufactured/vortex",
                    "A ring turns against its surroundings",
                    "theta = Theta + A sin(pi t) g(R) by its body force, Hencky, q = 4",
                    "Kamojjala, Brannon, Sadeghirad & Guilkey (2015), doi:10.1007/s00366-013-0342-x",
                    1,
                    90,
                    run};

}  // namespace talus::verification::manufactured_vortex
