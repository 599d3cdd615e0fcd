/// The body forces that make chosen motions solutions: closed forms, written by hand, against automatic differentiation
/// of the same motion through the solver's law, at random points and times.
///
/// An affine motion has a uniform stress, so that Div P = 0 for any law.
///
/// Source: of the motions see verification/exact; of the method: Aycock, Rebelo & Craven (2020),
/// doi:10.1016/j.cma.2020.113175 (manufactured solutions with the Hencky law; abstract read).

#include <numbers>
#include <random>

#include "models/laws/hencky.hpp"
#include "models/laws/neo_hookean.hpp"
#include "verification/exact/axis_aligned.hpp"
#include "verification/exact/expanding_ring.hpp"
#include "verification/exact/vortex.hpp"
#include "verification/manufactured/balance.hpp"
#include "verification/suite/cases.hpp"

namespace talus::verification::manufactured_body_forces {

namespace {

using std::numbers::pi;
constexpr double E = 1000, nu = 0.3, density = 700;
constexpr int samples = 500;

/// x = (I + t G + t^2 H) X: a general affine motion.
template <int D>
struct Affine {
  static constexpr int dimension = D;
  template <Scalar T>
  [[nodiscard]] Vector<T, D> position(Vector<T, D> const& X, T const& t) const {
    Vector<T, D> x = X;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        auto const to = static_cast<std::size_t>(i), from = static_cast<std::size_t>(j);
        x[to] += T(0.3 * std::sin(1 + 2 * i + 5 * j)) * t * X[from] + T(0.2 * std::cos(3 * i + j)) * t * t * X[from];
      }
    return x;
  }
};

/// Places and times of `samples` points in a box and in [0, 1).
template <int D>
std::vector<std::pair<Point<D>, double>> random_points(double low, double high) {
  std::mt19937 source(7);
  std::uniform_real_distribution<double> place(low, high), time(0, 1);
  std::vector<std::pair<Point<D>, double>> points(samples);
  for (auto& [X, t] : points) {
    for (int d = 0; d < D; ++d) X[d] = place(source);
    t = time(source);
  }
  return points;
}

/// Calls f(solid, law, name) for both laws.
template <class F>
void for_both_laws(F const& f) {
  using exact::Elastic, exact::ElasticLaw;
  f(Elastic::of(ElasticLaw::hencky, E, nu, density), law::Hencky({E, nu}), "hencky");
  f(Elastic::of(ElasticLaw::neo_hookean, E, nu, density), law::NeoHookean({E, nu}), "neo-hookean");
}

/// Largest difference over the largest force.
template <class M>
void compare(Findings& findings, M const& motion, std::string const& name, double low, double high) {
  constexpr int D = M::dimension;
  for_both_laws([&](exact::Elastic const& solid, auto const& law, std::string const& law_name) {
    double off = 0, largest = 0;
    for (auto const& [X, t] : random_points<D>(low, high)) {
      Point<D> const by_hand = motion.body_force(solid, X, t);
      off = std::max(off, (manufactured::body_force(law, density, motion, X, t) - by_hand).norm());
      largest = std::max(largest, by_hand.norm());
    }
    findings.check(name + ", " + law_name, "difference of the body forces over the largest", off / largest,
                   at_most(1e-11), "both are exact; rounding of second derivatives");
  });
}

template <int D>
void affine(Findings& findings) {
  for_both_laws([&](exact::Elastic const&, auto const& law, std::string const& law_name) {
    double off = 0;
    for (auto const& [X, t] : random_points<D>(-1, 1))
      off = std::max(off, manufactured::stress_divergence(law, Affine<D>{}, X, t).norm());
    findings.check("affine " + std::to_string(D) + "-D, " + law_name, "length times Div P over E", off / E,
                   at_most(1e-11), "the stress is uniform");
  });
}

/// At rest b vanishes, where all stretches coincide and a spectral form would be 0/0.
void at_rest(Findings& findings) {
  exact::AxisAligned<3> const motion{Point<3>::Constant(0.05), 2 * pi, pi};
  Point<3> const b =
      manufactured::body_force(law::Hencky({E, nu}), density, motion, Point<3>(0.1, 0.2, 0.3), 0) * density / E;
  findings.check("undeformed", "body force times density over E", b.norm(), at_most(1e-11), "u = 0 at t = 0");
}

/// What the ring's polynomial was made for.
void rims(Findings& findings) {
  exact::ExpandingRing const ring{0.4, 0.6, 0.1, 1};
  auto const at = [&](double R) { return manufactured::moved(ring, Point<2>(R, 0), pi / 2); };
  double const slope = std::abs(at(0.4).F(0, 0) - 1) + std::abs(at(0.6).F(0, 0) - 1);
  findings.check("expanding ring", "slope of the displacement at the rims", slope, at_most(1e-14), "free rims");
  findings.check("expanding ring", "displacement of the outer rim over A", (at(0.6).x[0] - 0.6) / 0.1, about(1, 1e-13),
                 "A is defined so");
}

void run(Findings& findings) {
  compare(findings, exact::AxisAligned<2>{{0.05, 0}, 2 * pi, pi}, "bar", 0, 1);
  compare(findings, exact::AxisAligned<2>{{0.05, 0.04}, 2 * pi, pi, {0, pi}}, "axis aligned 2-D", 0, 1);
  compare(findings, exact::AxisAligned<3>{{0.05, 0.04, 0.03}, 2 * pi, pi, {0, 2, 4}}, "axis aligned 3-D", 0, 1);
  compare(findings, exact::Vortex{0.1, pi, 4, {0.1, 0.2}}, "vortex, q = 4", -1, 1.2);
  compare(findings, exact::Vortex{1, pi, 2, {0.1, 0.2}}, "vortex, q = 2", -1, 1.2);
  compare(findings, exact::ExpandingRing{0.4, 0.6, 0.1, pi, {0.1, 0.2}}, "expanding ring", 0.4, 0.6);
  affine<2>(findings);
  affine<3>(findings);
  at_rest(findings);
  rims(findings);
}

}  // namespace

Case const the_case{"manufactured/body_forces",
                    "Body forces in closed form and by automatic differentiation",
                    "closed forms, derived by hand",
                    "derived in verification/exact; motions of Wallstedt & Guilkey (2008), "
                    "doi:10.1016/j.jcp.2008.07.019, and Kamojjala et al. (2015), "
                    "doi:10.1007/s00366-013-0342-x",
                    0,
                    5,
                    run};

}  // namespace talus::verification::manufactured_body_forces
