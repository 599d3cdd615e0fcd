/// The generalised vortex as published: q = 2, A = 1, a neo-Hookean material; to t = 0.5 s, when the shear is
/// largest: 6.
///
///   E = 1000 Pa, nu = 0.3, rho_0 = 1000 kg/m^3; square of 3 m, periodic and full of material; 24, 48, 96 cells
///
/// At the rim the body force jumps, so that orders saturate between 1 and 2: bars are on the error of u.
///
/// The levels were computed once by a program of its own, which shares no code with this one.
///
/// Source: Kamojjala, Brannon, Sadeghirad & Guilkey (2015), doi:10.1007/s00366-013-0342-x.

#include <array>
#include <limits>
#include <numbers>
#include <optional>

#include "core/errors.hpp"
#include "verification/exact/vortex.hpp"
#include "verification/manufactured/drive.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/refinement.hpp"

namespace talus::verification::manufactured_vortex_classical {

namespace {

constexpr double side = 3, end = 0.5, courant = 0.15;
constexpr std::array cells{24, 48, 96}, per_axis{2, 3, 4};

void refine_vortex(Findings& findings, Scheme const& scheme, std::optional<double> level_of_u) {
  auto const solid = exact::Elastic::of(exact::ElasticLaw::neo_hookean, 1000, 0.3, 1000);
  exact::Vortex const motion{1, std::numbers::pi, 2, {side / 2, side / 2}};
  auto const solution = manufactured::solution_of(motion, solid);
  Refinement study{scheme.name()};
  study.norms = {{.name = "u", .unit = "m", .because = "level: computed once by a program of its own, +15 %"},
                 {.name = "v", .unit = "m/s"},
                 {.name = "tau/G"}};
  if (level_of_u) study.norms.front().level = 1.15 * *level_of_u;
  for (int const N : cells) study.spacings.push_back(side / N);
  study.solve = [&](std::size_t level) {
    int const N = cells[level], n = per_axis[level];
    double const h = side / N;
    long const steps = std::lround(end * solid.wave_speed() / (courant * h));
    manufactured::Discretisation<2> with{scheme, h, end / double(steps), steps, {N / 4, N / 4}};
    with.places = lattice<2>(Point<2>::Zero(), {N, N}, {n, n}, h);
    with.volume = h * h / (n * n);
    with.adds = [](Scene<2>& scene) { scene.limits.gradient = 1; };  // shear is fast, not the step long
    auto const errors = manufactured::errors_of<2>(drive<2>(solution, with), solution, with);
    return Measured{{errors.u, errors.v, errors.stress / solid.G}, errors.cost};
  };
  try {
    refine(findings, study, "Vortex as published");
  } catch (RunError const& error) {
    double const none = std::numeric_limits<double>::quiet_NaN();
    Row& row = level_of_u ? findings.check(scheme.name(), "error of u", none, at_most(*level_of_u), error.what())
                          : findings.note(scheme.name(), "error of u", none, error.what());
    row.because = row.because.substr(0, row.because.find('\n'));
  }
}

void run(Findings& findings) {
  refine_vortex(findings, {"quadratic", "apic"}, 7.3e-3);
  refine_vortex(findings, {"cubic", "apic"}, 6.4e-3);
  refine_vortex(findings, {"cubic", "aflip"}, 4.9e-3);
  refine_vortex(findings, {"cubic", "flip"}, 9.0e-3);
  refine_vortex(findings, {"linear", "flip"}, {});  // the material-point method as it was
}

}  // namespace

Case const the_case{"manufactured/vortex_classical",
                    "The vortex as published, with shear up to 6",
                    "theta = Theta + A sin(pi t) g(R) by its body force, neo-Hookean, q = 2",
                    "Kamojjala, Brannon, Sadeghirad & Guilkey (2015), "
                    "doi:10.1007/s00366-013-0342-x",
                    2,
                    400,
                    run};

}  // namespace talus::verification::manufactured_vortex_classical
