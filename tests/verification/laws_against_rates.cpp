/// The return maps against the rate equations, integrated by CVODE: every law that has a limit of short steps converges
/// to it with order one.

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <sstream>

#include "core/log_strain.hpp"
#include "models/laws/cam_clay_mu_i.hpp"
#include "models/laws/cam_clay_mu_i_consistent.hpp"
#include "models/laws/modified_cam_clay.hpp"
#include "tests/support/strain_paths.hpp"
#include "verification/reference/cvode_path.hpp"

using namespace talus;
using support::StrainPath;

namespace {

/// Stress and strength at the end of a path.
struct End {
  reference::Matrix tau;
  double p_c;
};

template <class Shape>
Symmetric<double, Shape> taken(reference::Matrix const& m) {
  Symmetric<double, Shape> s;
  for (int i = 0; i < Shape::plane; ++i)
    for (int j = i; j < Shape::plane; ++j) s(i, j) = m(i, j);
  return s;
}

/// The law along a path in n steps of the material point: F <- (I + dt L) F, L in the middle of the step.
template <class Shape, class L>
End march(L const& law, reference::State const& start, reference::Segment const& path, int n) {
  auto eps = taken<Shape>(start.eps);
  auto state = law.template initial<Shape>();
  double const dt = path.duration / n;
  for (int k = 0; k < n; ++k) {
    reference::Matrix const l = path.gradient((k + 0.5) * dt);
    Matrix<double, Shape::plane> H;
    for (int i = 0; i < Shape::plane; ++i)
      for (int j = 0; j < Shape::plane; ++j) H(i, j) = dt * l(i, j);
    eps = law.project(trial_strain(eps, H), state, dt);
  }
  auto const tau = law.stress(eps);
  End end{reference::Matrix::Zero(), law.template strength<Shape>(state)};
  for (int i = 0; i < Shape::plane; ++i)
    for (int j = 0; j < Shape::plane; ++j) end.tau(i, j) = tau(std::min(i, j), std::max(i, j));
  return end;
}

/// Errors with 100, 200, 400 and 800 steps, of the largest of p_c, |p| and q.
template <class L>
std::vector<double> errors(L const& law, reference::RateLaw const& rates, StrainPath const& path) {
  auto const start = support::under_pressure(rates.elastic, path.p);
  auto const& segment = path.path.front();
  auto row = reference::cvode_path(rates, start, path.path, {segment.duration}).back();
  if (path.normals == 2) row.tau.row(2).setZero(), row.tau.col(2).setZero();
  std::vector<double> list;
  for (int const n : {100, 200, 400, 800}) {
    End const end =
        path.normals == 2 ? march<shape::Plane>(law, start, segment, n) : march<shape::Solid>(law, start, segment, n);
    double const size = std::max({row.p_c, std::abs(row.p), row.q});
    list.push_back(std::max((end.tau - row.tau).cwiseAbs().maxCoeff(), std::abs(end.p_c - row.p_c)) / size);
  }
  return list;
}

std::string line(StrainPath const& path, double beta, std::vector<double> const& e) {
  std::ostringstream text;
  text.precision(3);
  text << path.name << ", beta " << beta << ": errors";
  for (double const value : e) text << ' ' << value;
  text << "; orders";
  for (std::size_t k = 1; k < e.size(); ++k) text << ' ' << std::log2(e[k - 1] / e[k]);
  return text.str();
}

/// The paths cut off 25 us after their start, between yield and critical state: there is where volume changes fast.
std::vector<StrainPath> transients(std::vector<StrainPath> paths) {
  for (StrainPath& path : paths) path.name += ", first 25 us", path.path.front().duration = 25e-6;
  return paths;
}

/// Tells the errors, and demands order 1.00 +- 0.05 in the last three refinements.
template <class L, class Rates>
void check_order(Rates const& rates_of, std::vector<StrainPath> const& paths) {
  for (double const beta : {0.0, 0.1, 0.3})
    for (StrainPath const& path : paths) {
      typename L::Parameters parameters;
      parameters.beta = beta;
      auto const e = errors(L(parameters), rates_of(support::elastic(path.normals), beta), path);
      BOOST_TEST_MESSAGE(L::name << ", " << line(path, beta, e));
      BOOST_TEST_CONTEXT(L::name << ", " << line(path, beta, e)) {
        BOOST_TEST(e.back() < 2e-2);
        for (std::size_t k = 1; k < e.size(); ++k) BOOST_TEST(std::abs(std::log2(e[k - 1] / e[k]) - 1) <= 0.05);
      }
    }
}

/// The reference's parameters as the laws have them by default: E = 1 MPa, nu = 0.3, p_c0 = 100 Pa, xi = 50, glass.
reference::RateLaw rate_independent(reference::Elasticity const& e, double beta) {
  return reference::cam_clay(e, {law::CamClay::Parameters{}.M, beta}, support::soft());
}
reference::MuI glass() {
  law::CamClayMuI::Parameters const p;
  return {p.mu_1, p.mu_2, p.I_0, p.d, p.rho_s};
}
reference::RateLaw mu_i(reference::Elasticity const& e, double beta) {
  return reference::cam_clay_mu_i(e, beta, support::soft(), glass());
}

}  // namespace

BOOST_AUTO_TEST_SUITE(laws_against_rates)

BOOST_AUTO_TEST_CASE(rate_independent_cam_clay_converges_with_order_one) {
  check_order<law::CamClay>(rate_independent, support::strain_paths(0));
  check_order<law::CamClay>(rate_independent, transients(support::strain_paths(0)));
}

// Shear at constant volume, compression, dilation: its volumetric transients converge as well.
BOOST_AUTO_TEST_CASE(the_consistent_mu_of_I_map_converges_with_order_one) {
  check_order<law::CamClayMuIConsistent>(mu_i, support::strain_paths(0.3));
  check_order<law::CamClayMuIConsistent>(mu_i, transients(support::strain_paths(0.3)));
}

// The published map takes the whole overstress to the surface for the pressure in every step, however short: the way to
// critical state depends on the step, and does not tend to the rate equations. Only its end does.
BOOST_AUTO_TEST_CASE(the_two_stage_map_keeps_an_error_in_volumetric_transients) {
  auto const whole = support::strain_paths(0.3), first = transients(whole);
  for (std::size_t k = 0; k < whole.size(); ++k) {
    auto const rates = mu_i(support::elastic(whole[k].normals), 0);
    auto const early = errors(law::CamClayMuI{law::CamClayMuI::Parameters{}}, rates, first[k]),
               late = errors(law::CamClayMuI{law::CamClayMuI::Parameters{}}, rates, whole[k]);
    BOOST_TEST_MESSAGE("cam_clay_mu_i_two_stage, " << line(first[k], 0, early));
    BOOST_TEST_MESSAGE("cam_clay_mu_i_two_stage, " << line(whole[k], 0, late));
    if (k != 0) continue;
    BOOST_TEST(early.back() > 1e-2);
    BOOST_TEST(std::log2(early[early.size() - 2] / early.back()) < 0.5);
    BOOST_TEST(late.back() < 1e-4);
  }
}

BOOST_AUTO_TEST_SUITE_END()
