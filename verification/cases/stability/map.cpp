/// Where steps are stable: the longest step that the solver bears, found by bisection, with the predictions drawn over it.
///
/// Regular particles in a periodic box against von Neumann's analysis; particles without neighbours against the
/// eigenvalues of their step (verification/reference/stability). Over Poisson's ratio, the offset of the particles in
/// the cells, particles in a cell and stiffness, for every kernel but the linear one and every transfer, in reduced plane
/// strain. Steps are told as Courant numbers c_p dt/h with c_p^2 = (lambda + 2 G)/rho. The default step, 0.8 of the
/// isolated bound, is drawn in.
///
/// Where a curve over nu falls, its limit is that of a change of volume, 2 lambda + 2 G, which outgrows lambda + 2 G.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "models/kinematics/plane_strain_reduced.hpp"
#include "verification/reference/stability/arrangement.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/stability.hpp"

namespace talus::verification::stability_map {

namespace {

using Plane = kinematics::PlaneStrainReduced;

constexpr char const* courant = "c_p dt/h";

/// One curve of measurements with its prediction, and the largest distance of the two.
struct Pair {
  Curve measured, predicted;
  double worst = 1;  ///< measured over predicted where that is farthest from 1
  Cost cost;

  explicit Pair(std::string const& name) : measured{name}, predicted{name + ", predicted", {}, {}, true} {}

  void add(double x, double found, double expected, double speed) {
    measured.x.push_back(x);
    predicted.x.push_back(x);
    measured.y.push_back(found * speed);
    predicted.y.push_back(expected * speed);
    if (!(std::abs(found / expected - 1) <= std::abs(worst - 1))) worst = found / expected;
  }
  void judge(Findings& findings, Plot& plot, std::string const& over) const {
    findings.check(measured.name + ", over " + over, "measured over predicted longest step, where farthest from 1",
                   worst, about(1, 0.05), "prediction by eigenvalues; steps are found to 1 %", cost);
    plot.curves.push_back(measured);
    plot.curves.push_back(predicted);
  }
};

std::vector<std::string> const transfers{"pic", "flip", "apic", "aflip"};

void add_lattice(Pair& pair, double x, ElasticScheme const& elastic, PeriodicLattice const& lattice) {
  pair.add(x, measured_limit<Plane>(elastic, lattice, pair.cost), predicted_limit<Plane>(elastic, lattice),
           elastic.wave_speed());
}

double isolated_prediction(ElasticScheme const& elastic, Point<2> const& place) {
  return reference::longest_step({{place}, {1.0}, elastic.poisson}, transfer_of(elastic.scheme));
}

void over_poisson(Findings& findings, std::string const& kernel) {
  Plot regular{"Longest stable step of a lattice, 2 x 2 a cell, " + kernel, "nu", courant},
      isolated{"Longest stable step of a particle without neighbours, " + kernel, "nu", courant};
  for (std::string const& transfer : transfers) {
    Pair lattice("lattice, " + kernel + ", " + transfer), alone("alone, " + kernel + ", " + transfer);
    Curve chosen{kernel + ", " + transfer + ", default step"};
    for (double const poisson : {0.0, 0.15, 0.3, 0.4, 0.45, 0.48, 0.495}) {
      ElasticScheme const elastic{{kernel, transfer}, 1e6, poisson};
      add_lattice(lattice, poisson, elastic, worst_lattice<Plane>(elastic, 2));
      Point<2> const worst = Point<2>::Constant(reference::sharpest_place(elastic.scheme.degree()));
      alone.add(poisson, isolated_limits<Plane>(elastic, {worst}, alone.cost)[0], isolated_prediction(elastic, worst),
                elastic.wave_speed());
      chosen.x.push_back(poisson);
      chosen.y.push_back(StepLimits{}.safety * isolated_bound<Plane>(elastic) * elastic.wave_speed());
    }
    lattice.judge(findings, regular, "nu");
    alone.judge(findings, isolated, "nu");
    isolated.curves.push_back(chosen);
  }
  findings.plots.push_back(regular);
  findings.plots.push_back(isolated);
}

void over_offset(Findings& findings, std::string const& kernel) {
  Plot regular{"Longest stable step of a lattice, one a cell, over its place, " + kernel,
               "offset along the diagonal [h]", courant},
      isolated{"Longest stable step of a particle without neighbours over its place, " + kernel,
               "place along the diagonal [h]", courant};
  for (std::string const& transfer : transfers) {
    ElasticScheme const elastic{{kernel, transfer}};
    Pair lattice("lattice, " + kernel + ", " + transfer), alone("alone, " + kernel + ", " + transfer);
    std::vector<Point<2>> places;
    for (int k = 0; k <= 16; ++k) {
      double const offset = k / 16.0 * 0.9996 + 1e-4;  // not exactly in the middle, where a node drops out
      if (k % 2 == 0) add_lattice(lattice, offset, elastic, {1, {offset, offset}});
      places.push_back(Point<2>::Constant(offset));
    }
    auto const limits = isolated_limits<Plane>(elastic, places, alone.cost);
    for (std::size_t k = 0; k < places.size(); ++k)
      alone.add(places[k][0], limits[k], isolated_prediction(elastic, places[k]), elastic.wave_speed());
    lattice.judge(findings, regular, "offset");
    alone.judge(findings, isolated, "offset");
  }
  findings.plots.push_back(regular);
  findings.plots.push_back(isolated);
}

void over_particles(Findings& findings, std::string const& kernel) {
  Plot plot{"Longest stable step of a lattice over particles in a cell, " + kernel, "particles along an axis of a cell",
            courant};
  for (std::string const& transfer : transfers) {
    ElasticScheme const elastic{{kernel, transfer}};
    Pair pair("lattice, " + kernel + ", " + transfer);
    for (int const per_axis : {1, 2, 3, 4})
      add_lattice(pair, per_axis, elastic, worst_lattice<Plane>(elastic, per_axis));
    pair.judge(findings, plot, "particles in a cell");
  }
  findings.plots.push_back(plot);
}

/// Without a picture.
void over_lattices(Findings& findings, Scheme const& scheme) {
  Plot ignored;
  Pair pair("lattice, " + scheme.name());
  for (int const per_axis : {1, 2}) add_lattice(pair, per_axis, {scheme}, worst_lattice<Plane>({scheme}, per_axis));
  pair.judge(findings, ignored, "particles in a cell");
}

/// Steps in units of h/sqrt(E/rho) do not know E.
void over_stiffness(Findings& findings, Scheme const& scheme) {
  Plot plot{"Longest stable step of a lattice over stiffness, " + scheme.name(), "E [Pa]", courant, true, false};
  Pair pair("lattice, " + scheme.name());
  for (double const young : {1e4, 1e6, 1e8, 1e10, 1e12}) {
    ElasticScheme const elastic{scheme, young};
    add_lattice(pair, young, elastic, worst_lattice<Plane>(elastic, 2));
  }
  pair.judge(findings, plot, "E");
  auto const [least, most] = std::minmax_element(pair.measured.y.begin(), pair.measured.y.end());
  findings.check(scheme.name() + ", over E", "largest over smallest of the measured steps", *most / *least,
                 about(1, 0.006), "E scales out; 0.5 %: where the bisection ends");
  findings.plots.push_back(plot);
}

void run(Findings& findings) {
  for (std::string const kernel : {"quadratic", "cubic"}) {
    over_poisson(findings, kernel);
    over_offset(findings, kernel);
    over_particles(findings, kernel);
  }
  for (Scheme const& scheme : all_schemes("musl"))
    if (scheme.degree() > 1) over_lattices(findings, scheme);
  over_stiffness(findings, {"quadratic", "aflip"});
  over_stiffness(findings, {"cubic", "pic"});
  findings.omit("linear", "all of it", "a least mass at nodes keeps its step finite: no linear theory of the lattice");
}

}  // namespace

Case const the_case{"stability/map",
                    "Longest stable steps, measured and predicted",
                    "von Neumann's analysis; eigenvalues of the step of a particle",
                    "derived in verification/reference/stability",
                    2,
                    180,
                    run};

}  // namespace talus::verification::stability_map
