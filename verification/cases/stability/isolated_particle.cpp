/// An elastic particle that shares no node with another, at the worst place in a cell: the case that limits the time step
/// at free surfaces and in spray. Core chooses
///
///   dt = safety h sqrt(2/q) / sqrt(max(D lambda, 0)/rho + 2 G/rho)                                              (1)
///
/// with q of the kernel and the transfer (core/time_step.hpp, where it is derived). Here (1) with safety = 1 is
/// compared with the eigenvalues of the step as a matrix (verification/reference/stability/arrangement.hpp), and with what
/// the solver does: no growth in 2000 steps at the bound, growth without end at 1.1 of it, and none with the default
/// step at any place in a cell, nu from -0.9 to 0.495. That neighbours raise the bound is tried on clouds, by
/// eigenvalues and by the solver.

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "models/kinematics/plane_strain.hpp"
#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/kinematics/solid.hpp"
#include "verification/reference/stability/arrangement.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/stability.hpp"

namespace talus::verification::stability_isolated_particle {

namespace {

constexpr double default_safety = StepLimits{}.safety;

double largest(std::vector<double> const& values) {
  return *std::max_element(values.begin(), values.end());
}

/// The bound three ways: core's formula, eigenvalues, the solver's behaviour.
template <class Kinematics>
void at_the_worst_place(Findings& findings, Scheme const& scheme) {
  constexpr int D = Kinematics::dimension;
  std::string const subject = fmt::format("{}, {}-D", scheme.name(), D);
  ElasticScheme const elastic{scheme};
  double const bound = isolated_bound<Kinematics>(elastic);
  Point<D> const worst = Point<D>::Constant(reference::sharpest_place(scheme.degree()));
  double const predicted = reference::longest_step({{worst}, {1.0}, elastic.poisson}, transfer_of(scheme));
  findings.check(subject, "bound over the one by eigenvalues", bound / predicted, about(1, 1e-3),
                 "(1) of core/time_step.hpp; the worst place is found to 1e-4 of a cell");
  Cost cost;
  findings.check(subject, "growth of the strain in 2000 steps at the bound",
                 largest(isolated_growth<Kinematics>(elastic, {worst}, bound, 2000, cost)), at_most(30),
                 "stable; with cubic affine the eigenvalues are -1 and -0.83, whose near eigenvectors first add up",
                 cost);
  findings.check(subject, "growth of the strain at 1.1 of the bound",
                 largest(isolated_growth<Kinematics>(elastic, {worst}, 1.1 * bound, 2000, cost)),
                 at_least(unstable_growth), "unstable", cost);
}

/// The default step at places all over a cell, faces and middles included.
template <class Kinematics>
void everywhere(Findings& findings, Scheme const& scheme, std::string const& kinematics, double poisson) {
  constexpr int D = Kinematics::dimension, n = D == 2 ? 8 : 4;
  ElasticScheme const elastic{scheme, 1e6, poisson};
  std::vector<Point<D>> places;
  for (int k = 0; k < (D == 2 ? n * n : n * n * n); ++k) {
    Point<D> x;
    for (int d = 0, rest = k; d < D; ++d, rest /= n) x[d] = (rest % n) / double(n) + 1e-4;
    places.push_back(x);
  }
  Cost cost;
  double const step = default_safety * isolated_bound<Kinematics>(elastic);
  findings.check(fmt::format("{}, {}, nu = {}", scheme.name(), kinematics, poisson),
                 "growth of the strain with the default step, anywhere in a cell",
                 largest(isolated_growth<Kinematics>(elastic, places, step, 100, cost)), at_most(10),
                 "stable; an affine velocity may take a few strains over", cost);
}

/// Clouds of two to four particles, with masses up to a factor of a hundred apart, by eigenvalues.
void with_neighbours(Findings& findings, Scheme const& scheme) {
  std::mt19937_64 source(5);
  std::uniform_real_distribution<double> number(0, 1);
  double most = 0;
  double const bound = isolated_bound<kinematics::PlaneStrainReduced>({scheme});
  for (int cloud = 0; cloud < 20; ++cloud) {
    reference::Arrangement particles;
    for (int p = 0; p < 2 + cloud % 3; ++p) {
      particles.places.emplace_back(Point<2>(1.5 * number(source), 1.5 * number(source)));
      particles.masses.push_back(std::pow(100.0, (cloud % 2) * number(source)));
    }
    most = std::max(most, reference::growth_of_a_step(particles, transfer_of(scheme), bound));
  }
  findings.check(scheme.name() + ", clouds", "largest eigenvalue at the bound, less 1", most - 1,
                 at_most(reference::defect), "neighbours raise the bound");
}

void with_default_step(Findings& findings, Scheme const& scheme) {
  for (double const poisson : {-0.9, 0.0, 0.3, 0.495}) {
    everywhere<kinematics::PlaneStrainReduced>(findings, scheme, "reduced plane strain", poisson);
    everywhere<kinematics::PlaneStrain>(findings, scheme, "plane strain", poisson);
    everywhere<kinematics::Solid>(findings, scheme, "3-D", poisson);
  }
}

void run(Findings& findings) {
  for (Scheme const& scheme : all_schemes("musl"))
    everywhere<kinematics::PlaneStrainReduced>(findings, scheme, "reduced plane strain", 0.495);
  for (Scheme const& scheme : all_schemes()) {
    with_default_step(findings, scheme);
    if (scheme.degree() == 1) continue;
    at_the_worst_place<kinematics::PlaneStrainReduced>(findings, scheme);
    at_the_worst_place<kinematics::Solid>(findings, scheme);
    with_neighbours(findings, scheme);
  }
  findings.omit("linear", "the bound itself",
                "the sum of squared slopes over weights has no bound; a least mass at nodes keeps the step finite, and "
                "that is no linear theory");
}

}  // namespace

Case const the_case{"stability/isolated_particle",
                    "The longest step of a particle without neighbours",
                    "eigenvalues of the step; the derived bound",
                    "derived in core/time_step.hpp and verification/reference/stability",
                    1,
                    30,
                    run};

}  // namespace talus::verification::stability_isolated_particle
