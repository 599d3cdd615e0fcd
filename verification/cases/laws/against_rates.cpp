/// The return maps against the rate equations of the law, integrated by CVODE along six strain paths: every law that has
/// a limit of short steps converges to it with order one.
///
/// The whole paths end at critical state; their first 25 us lie between yield and critical state, where volume changes
/// fast. The published two-stage mu(I) map takes the whole overstress to the surface for the pressure in every step,
/// however short: its way to critical state depends on the step and does not tend to the rate equations, only its end
/// does.

#include <fmt/format.h>

#include <cmath>

#include "core/log_strain.hpp"
#include "models/laws/cam_clay_mu_i.hpp"
#include "models/laws/cam_clay_mu_i_consistent.hpp"
#include "models/laws/modified_cam_clay.hpp"
#include "verification/reference/cvode_path.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/strain_paths.hpp"

namespace talus::verification::laws_against_rates {

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
  auto const start = under_pressure(rates.elastic, path.p);
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

/// The paths cut off 25 us after their start.
std::vector<StrainPath> transients(std::vector<StrainPath> paths) {
  for (StrainPath& path : paths) path.name += ", first 25 us", path.path.front().duration = 25e-6;
  return paths;
}

/// The reference's parameters as the laws have them by default: E = 1 MPa, nu = 0.3, p_c0 = 100 Pa, xi = 50, glass.
reference::RateLaw rate_independent(reference::Elasticity const& e, double beta) {
  return reference::cam_clay(e, {law::CamClay::Parameters{}.M, beta}, soft());
}
reference::RateLaw mu_i(reference::Elasticity const& e, double beta) {
  law::CamClayMuI::Parameters const p;
  return reference::cam_clay_mu_i(e, beta, soft(), {p.mu_1, p.mu_2, p.I_0, p.d, p.rho_s});
}

/// The three observed orders with 100 ... 800 steps, and the last error.
template <class L, class Rates>
void check_order(Findings& findings, Rates const& rates_of, std::vector<StrainPath> const& paths) {
  for (double const beta : {0.0, 0.1, 0.3})
    for (StrainPath const& path : paths) {
      typename L::Parameters parameters;
      parameters.beta = beta;
      auto const e = errors(L(parameters), rates_of(elastic(path.normals), beta), path);
      std::string const subject = fmt::format("{}, {}, beta {}", L::name, path.name, beta);
      for (std::size_t k = 1; k < e.size(); ++k)
        findings.check(subject, fmt::format("order of stress, {} to {} steps", 50 << k, 100 << k),
                       std::log2(e[k - 1] / e[k]), {0.95, 1.05}, "implicit Euler");
      findings.check(subject, "error of stress, 800 steps", e.back(), at_most(2e-2), "no more than a first-order step");
    }
}

void run(Findings& findings) {
  check_order<law::CamClay>(findings, rate_independent, strain_paths(0));
  check_order<law::CamClay>(findings, rate_independent, transients(strain_paths(0)));
  check_order<law::CamClayMuIConsistent>(findings, mu_i, strain_paths(0.3));
  check_order<law::CamClayMuIConsistent>(findings, mu_i, transients(strain_paths(0.3)));
  auto const whole = strain_paths(0.3), first = transients(whole);
  law::CamClayMuI const two_stage{law::CamClayMuI::Parameters{}};
  for (std::size_t k = 0; k < whole.size(); ++k) {
    auto const rates = mu_i(elastic(whole[k].normals), 0);
    auto const early = errors(two_stage, rates, first[k]), late = errors(two_stage, rates, whole[k]);
    std::string const subject = std::string(law::CamClayMuI::name) + ", ";
    findings.note(subject + first[k].name, "error of stress, 800 steps", early.back(),
                  "does not tend to the rate equations");
    if (k == 0)
      findings.check(subject + whole[k].name, "error of stress, 800 steps", late.back(), at_most(1e-4),
                     "the end of the path is the critical state");
    else
      findings.note(subject + whole[k].name, "error of stress, 800 steps", late.back());
  }
}

}  // namespace

Case const the_case{"laws/against_rates",
                    "Return maps against rate equations",
                    "CVODE (Adams and BDF), relative tolerance 1e-13",
                    "rate equations of Cam-Clay: Roscoe & Burland (1968); mu(I): Blatny, Gray & Gaume (2024), "
                    "doi:10.1017/jfm.2024.643",
                    1,
                    30,
                    run};

}  // namespace talus::verification::laws_against_rates
