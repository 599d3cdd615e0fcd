/// A ring that breathes with free rims, which cut through cells.
///
///   U = A sin(pi c t/(a + b)) (c_3 R^3 + c_2 R^2 + c_1 R)
///   a = 0.4 m, b = 0.6 m, A = 0.1 m, E = 1e7 Pa, nu = 0, rho_0 = 1000 kg/m^3
///
/// to a fifth of the period. Particles lie on a lattice and only those within the ring are there: the mass of cells at
/// the rim is off by O(1), so that order 1 is what may be hoped for, whatever the inside does.
///
/// Source: Wallstedt & Guilkey (2008), doi:10.1016/j.jcp.2008.07.019.

#include <array>
#include <numbers>

#include "verification/exact/expanding_ring.hpp"
#include "verification/manufactured/drive.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/refinement.hpp"

namespace talus::verification::manufactured_expanding_ring {

namespace {

constexpr double side = 1.6, inner = 0.4, outer = 0.6, courant = 0.2;
constexpr std::array cells{32, 64, 128}, per_axis{2, 3, 4};

void refine_ring(Findings& findings, Scheme const& scheme) {
  auto const solid = exact::Elastic::of(exact::ElasticLaw::hencky, 1e7, 0, 1000);
  double const frequency = std::numbers::pi * solid.wave_speed() / (inner + outer);
  exact::ExpandingRing const ring{inner, outer, 0.1, frequency, Point<2>::Constant(side / 2)};
  auto const solution = manufactured::solution_of(ring, solid);
  double const end = 0.2 * 2 * std::numbers::pi / frequency;
  Refinement study{scheme.name()};
  study.norms = {{.name = "u", .unit = "m", .order = 1, .because = "free rims cut cells: order 1"},
                 {.name = "v", .unit = "m/s"},
                 {.name = "ln F"}};
  for (int const N : cells) study.spacings.push_back(side / N);
  study.solve = [&](std::size_t level) {
    int const N = cells[level], n = per_axis[level];
    double const h = side / N;
    long const steps = std::lround(end * solid.wave_speed() / (courant * h));
    manufactured::Discretisation<2> with{scheme, h, end / double(steps), steps};
    for (Point<2> const& X : lattice<2>(Point<2>::Zero(), {N, N}, {n, n}, h))
      if (double const R = (X - ring.centre).norm(); R > inner && R < outer) with.places.push_back(X);
    with.volume = h * h / (n * n);
    auto const errors = manufactured::errors_of<2>(drive<2>(solution, with), solution, with);
    return Measured{{errors.u, errors.v, errors.strain}, errors.cost};
  };
  refine(findings, study, "Expanding ring");
}

void run(Findings& findings) {
  refine_ring(findings, {"quadratic", "apic"});
  refine_ring(findings, {"quadratic", "aflip"});
  refine_ring(findings, {"cubic", "apic"});
}

}  // namespace

Case const the_case{"manufactured/expanding_ring",
                    "A ring breathes with free rims",
                    "r = R + U(R, t) by its body force, Hencky",
                    "Wallstedt & Guilkey (2008), doi:10.1016/j.jcp.2008.07.019",
                    2,
                    120,
                    run};

}  // namespace talus::verification::manufactured_expanding_ring
