/// The periodic bar with a fixed number n of particles in a cell: what no finer grid removes.
///
/// Particles that have moved apart leave an unbalanced force sigma eps_q (transfer/quadrature): the stress stays off by
/// a share of the strain, and the error of u, once below it, grows again as about 1/h. Degree helps more than
/// particles. Bars are on levels; an order would be that of the floor.
///
/// The levels were computed once by a program of its own in one dimension, which shares no code with this one. They
/// depend on where the particles happen to lie and hold to the digit given.
///
/// Source: the bar: Steffen, Wallstedt, Guilkey, Kirby & Berzins (2008), doi:10.3970/cmes.2008.031.107; the floor:
/// Steffen, Kirby & Berzins (2008), doi:10.1002/nme.2360 (abstract read).

#include <algorithm>
#include <array>
#include <random>

#include "verification/manufactured/bar.hpp"
#include "verification/suite/cases.hpp"

namespace talus::verification::manufactured_floors {

namespace {

using manufactured::bar_discretisation, manufactured::errors_of;

constexpr std::array cells{32, 64, 128, 256};

/// Particles in a cell and the error of ln F that stays.
struct Floor {
  int n;
  double level;
};

manufactured::Solution<2> bar() {
  return manufactured::solution_of(manufactured::bar_motion(), manufactured::bar_solid(exact::ElasticLaw::hencky));
}

void add_curve(Findings& findings, std::string const& title, std::string const& label, Curve curve) {
  for (Plot& plot : findings.plots)
    if (plot.title == title) return plot.curves.push_back(std::move(curve));
  findings.plots.push_back({title, "h [m]", label, true, true, {std::move(curve)}});
}

void find_floor(Findings& findings, Scheme const& scheme, Floor const& floor) {
  auto const solution = bar();
  std::string const subject = scheme.name() + ", n = " + std::to_string(floor.n);
  Curve strain{subject}, u{subject};
  Cost cost;
  for (int const N : cells) {
    auto const with = bar_discretisation(scheme, N, floor.n);
    auto const errors = errors_of<2>(drive<2>(solution, with), solution, with);
    cost += errors.cost;
    for (Curve* curve : {&strain, &u}) curve->x.push_back(with.h);
    strain.y.push_back(errors.strain);
    u.y.push_back(errors.u);
  }
  findings.check(subject, "error of ln F at h = 1/256 over its floor", strain.y.back() / floor.level, at_most(1.15),
                 "floor: computed once in one dimension by a program of its own", cost);
  double const least = *std::min_element(u.y.begin(), u.y.end());
  findings.note(subject, "error of u at h = 1/256 over the least", u.y.back() / least,
                "grows as about 1/h from the floor on");
  add_curve(findings, "Fixed particles in a cell: ln F", "error of ln F [1]", std::move(strain));
  add_curve(findings, "Fixed particles in a cell: u", "error of u [m]", std::move(u));
}

/// The same with places off by up to a quarter of their spacing.
void jitter(Findings& findings, Scheme const& scheme, int n) {
  auto const solution = bar();
  auto with = bar_discretisation(scheme, 64, n);
  std::mt19937 source(3);
  std::uniform_real_distribution<double> shift(-0.25 * with.h / n, 0.25 * with.h / n);
  for (Point<2>& X : with.places) X[0] += shift(source);
  auto const errors = errors_of<2>(drive<2>(solution, with), solution, with);
  findings.note(scheme.name() + ", n = " + std::to_string(n) + ", jittered", "error of ln F at h = 1/64", errors.strain,
                "order is gone: particles sample at random", errors.cost);
}

void run(Findings& findings) {
  for (Floor const floor : {Floor{2, 0.09}, Floor{4, 0.07}, Floor{8, 0.03}})
    find_floor(findings, {"linear", "flip"}, floor);
  for (std::string const transfer : {"flip", "apic", "aflip"}) {
    for (Floor const floor : {Floor{2, 2.0e-2}, Floor{3, 7e-3}, Floor{4, 2.6e-3}, Floor{8, 1.0e-3}})
      find_floor(findings, {"quadratic", transfer}, floor);
    for (Floor const floor : {Floor{2, 7e-3}, Floor{3, 1.2e-3}, Floor{4, 2.5e-4}, Floor{8, 5e-5}})
      find_floor(findings, {"cubic", transfer}, floor);
  }
  for (int const n : {4, 16})
    for (std::string const kernel : {"quadratic", "cubic"}) jitter(findings, {kernel, "apic"}, n);
}

}  // namespace

Case const the_case{"manufactured/floors",
                    "The bar with a fixed number of particles in a cell",
                    "levels of the error that stays",
                    "Steffen, Kirby & Berzins (2008), doi:10.1002/nme.2360",
                    2,
                    300,
                    run};

}  // namespace talus::verification::manufactured_floors
