/// Return maps from hostile trial states: stresses over 24 decades, every corner of the parameters, tip, cap and apex.
///
/// The judge is the same step by bisection in extended precision (64 bits), which on a sample is itself judged in fifty
/// digits. The error is the distance to the judge over the largest of p_c, |p| and q; where the strength falls faster
/// than the stress there may be several roots, and a step that lies on another one is judged by the change of the trial
/// shear stress that makes it exact. TALUS_HOSTILE_STATES is the number of states a law.

#include <concepts>
#include <type_traits>

#include "models/laws/cam_clay_mu_i.hpp"
#include "models/laws/cam_clay_mu_i_consistent.hpp"
#include "models/laws/drucker_prager.hpp"
#include "models/laws/drucker_prager_viscous.hpp"
#include "models/laws/modified_cam_clay.hpp"
#include "models/laws/von_mises.hpp"
#include "tests/support/hostile.hpp"
#include "verification/reference/return_maps.hpp"

using namespace talus;
using support::Tally;
using support::Trial;
namespace ref = talus::reference;
using Long = long double;

namespace {

struct Corner {
  double beta, xi, p_c0, nu, M;
  [[nodiscard]] std::string text() const {
    std::ostringstream line;
    line << "(beta " << beta << " xi " << xi << " p_c0 " << p_c0 << " nu " << nu << " M " << M << ")";
    return line.str();
  }
};
std::vector<Corner> corners() {
  std::vector<Corner> all;
  for (double const beta : {0.0, 0.3, 0.95})
    for (double const xi : {0.0, 50.0, 1e4})
      for (double const p_c0 : {1e-3, 100.0, 1e5})
        for (double const nu : {-0.5, 0.3, 0.49})
          for (double const M : {0.01, 0.38, 3.0}) all.push_back({beta, xi, p_c0, nu, M});
  return all;
}

template <class H, class R, class C>
C coupling(law::ModifiedCamClay<H, R, C> const&);
template <class L>
using CouplingOf = decltype(coupling(std::declval<L>()));
template <class L>
inline constexpr bool consistent = std::same_as<CouplingOf<L>, law::Consistent>;

template <class L>
L law_of(Corner const& c) {
  typename L::Parameters p;
  p.nu = c.nu, p.beta = c.beta, p.p_c0 = c.p_c0, p.xi = c.xi;
  if constexpr (requires { p.M; }) p.M = c.M;
  if constexpr (requires { p.mu_1; }) p.mu_1 = c.M, p.mu_2 = 1.7 * c.M;
  return L(p);
}

struct Stress {
  Long p, q;
};

/// One law in one corner, against its truth.
template <class L>
struct Court {
  L law;
  Corner corner;
  ref::CamClay judge;
  double K = judge.elastic.K(), G = judge.elastic.G();

  explicit Court(Corner const& c)
      : law(law_of<L>(c)),
        corner(c),
        judge{{1e6, c.nu, 3}, {c.M, c.beta}, ref::ExponentialStrength{c.p_c0, c.xi}, ref::implicit_hardening} {}

  [[nodiscard]] ref::MuI mu_i() const {
    typename L::Parameters const p;
    return {corner.M, 1.7 * corner.M, p.I_0, p.d, p.rho_s};
  }
  template <class T>
  [[nodiscard]] ref::StressOf<T> exact(Trial const& t) const {
    ref::StressOf<T> const trial{T(t.p), T(t.q), T(t.eps_V)};
    if constexpr (!L::rate_dependent)
      return ref::cam_clay_projection<T>(judge, trial);
    else if constexpr (consistent<L>)
      return ref::cam_clay_consistent<T>(judge, mu_i(), trial, t.dt);
    else
      return ref::cam_clay_two_stage<T>(judge, mu_i(), trial, t.dt);
  }

  /// The shear stress that relaxes from q_tr at these S and P: the smaller root of the quadratic equation.
  [[nodiscard]] Long relaxed(Long q_tr, Long S, Long P, double dt) const {
    if constexpr (L::rate_dependent) {
      auto const m = mu_i();
      Long const O = q_tr - m.mu_1 * S, most = (Long(m.mu_2) - m.mu_1) * S, R = Long(G) * dt * m.Q() * std::sqrt(P);
      Long const sum = O + most + R;
      return m.mu_1 * S + 2 * O * most / (sum + std::sqrt(sum * sum - 4 * O * most));
    }
    return corner.M * S;
  }

  /// Relative change of the trial shear stress that makes (p, q) an exact step, and the distance of q from its law.
  [[nodiscard]] double backward(Trial const& t, Stress const& s) const {
    Long const beta = corner.beta, way = Long(t.p) - s.p;
    Long const p_c = ref::strength<Long>(judge.hardening, Long(t.eps_V) - way / K, K);
    Long const D = 2 * s.p - (1 - beta) * p_c, P = s.p + beta * p_c, S = std::sqrt(std::max(Long(0), (p_c - s.p) * P));
    Long const M = corner.M, q_flow = consistent<L> ? s.q : M * S;
    Long const q_tr =
        consistent<L> ? s.q + way * S * S * 2 * G / (K * s.q * D) : q_flow * (1 + 2 * G * way / (K * M * M * D));
    Long const size = std::max({p_c, std::abs(s.p), s.q}), law_error = std::abs(relaxed(t.q, S, P, t.dt) - s.q) / size;
    return static_cast<double>(std::max(std::abs(q_tr - t.q) / std::max(Long(t.q), std::abs(Long(t.p))), law_error));
  }

  void judge_one(Tally& tally, Trial const& t, Stress const& found) const {
    ++tally.plastic;
    if (!std::isfinite(found.p) || !std::isfinite(found.q)) {
      ++tally.not_finite;
      return;
    }
    auto const truth = exact<Long>(t);
    Long const p_c = ref::strength<Long>(judge.hardening, truth.eps_V, K), beta = corner.beta;
    Long const own_p_c = ref::strength<Long>(judge.hardening, Long(t.eps_V) + (found.p - t.p) / K, K);
    Long const size = std::max({p_c, std::abs(truth.p), truth.q}), slack = 1e-10L * std::max({own_p_c, found.q, size});
    bool const between = found.p <= own_p_c + slack && found.p >= -beta * own_p_c - slack;
    if (!between || found.q < 0 || found.q > t.q + slack) ++tally.outside;
    double error = static_cast<double>(std::max(std::abs(found.p - truth.p), std::abs(found.q - truth.q)) / size);
    if (!(error <= 1e-10)) {
      double const back = backward(t, found);
      tally.elsewhere += back <= 1e-10 ? 1 : 0;
      error = std::min(error, back);
    }
    tally.error(error, t, corner.text());
    if (tally.plastic % 997 == 1) check_judge(tally, t, truth, size);
  }

  void check_judge(Tally& tally, Trial const& t, ref::StressOf<Long> const& truth, Long size) const {
    auto const digits = exact<ref::Digits>(t);
    ref::Digits const apart = std::max<ref::Digits>(abs(digits.p - truth.p), abs(digits.q - truth.q)) / size;
    tally.judge = std::max(tally.judge, static_cast<double>(apart));
  }
};

/// Packs of trial stresses through the law's own step, as `project` takes it.
template <class L>
void judge_packs(Tally& tally, Court<L> const& court, support::TrialSampler& sampler) {
  auto const strength = [&](double eps_V) { return court.law.hardening.strength(eps_V, court.K); };
  std::array<Trial, lanes> trials;
  Lanes p, q, eps_V, dt;
  for (int k = 0; k < lanes; ++k) {
    Trial const t = trials[static_cast<std::size_t>(k)] = sampler.next(court.corner.p_c0, court.corner.beta, strength);
    p.set(k, t.p), q.set(k, t.q), eps_V.set(k, t.eps_V), dt.set(k, t.dt);
  }
  Lanes const p_c = court.law.hardening.strength(eps_V, court.K);
  auto const plastic =
      court.law.surface.excess(p, q, p_c) > Lanes(0.0) && p_c < Lanes(court.law.hardening.ceiling(court.K));
  law::CamClayTrial<Lanes> const trial{p, q, eps_V, p_c};
  law::Modulus const m{court.K, court.G};
  auto const flowed =
      CouplingOf<L>::flow(court.law.surface, court.law.hardening, court.law.rate, m, trial, dt, plastic);
  if constexpr (!consistent<L>) {
    law::CamClayMap const map{court.law.surface, court.law.hardening, court.K, court.G};
    tally.most_iterations = std::max(tally.most_iterations, map(p, q, eps_V, p_c, plastic).iterations);
  }
  tally.tried += lanes;
  for (int k = 0; k < lanes; ++k)
    if (plastic[k]) court.judge_one(tally, trials[static_cast<std::size_t>(k)], {flowed.p[k], flowed.q[k]});
}

template <class L>
void judge_law(unsigned seed) {
  Tally tally(L::name);
  support::TrialSampler sampler(seed);
  auto const all = corners();
  long const each = std::max(1L, support::hostile_states() / static_cast<long>(all.size()) / lanes);
  for (Corner const& corner : all) {
    Court<L> const court(corner);
    for (long n = 0; n < each; ++n) judge_packs(tally, court, sampler);
  }
  tally.check();
}

/// Whole steps of a law without hardening; the trial stress is the one that the strain has. Errors in units of the trial
/// stress: the strain keeps no more.
template <class L, class Exact>
void judge_cone(L const& law, Exact const& exact, unsigned seed, Tally& tally, long count) {
  support::TrialSampler sampler(seed);
  for (long n = 0; n < count; ++n) {
    Trial t = sampler.next(100, 0, [](double) { return 100.0; });
    auto const trial = support::strain_of<shape::Solid>(law, t.p, t.q);
    auto const inv = invariants(law, trial);
    auto state = law.template initial<shape::Solid>();
    auto const after = invariants(law, law.project(trial, state, t.dt));
    ++tally.tried;
    if (after.p == inv.p && after.q == inv.q) continue;
    ++tally.plastic;
    if (!std::isfinite(after.p) || !std::isfinite(after.q)) ++tally.not_finite;
    auto const truth = exact(ref::StressOf<Long>{inv.p, inv.q, 0}, t.dt);
    Long const size = std::max({std::abs(Long(inv.p)), Long(inv.q), std::abs(truth.p)});
    tally.error(static_cast<double>(std::max(std::abs(after.p - truth.p), std::abs(after.q - truth.q)) / size), t, "");
    if (after.q < 0 || after.q > inv.q * (1 + 1e-12)) ++tally.outside;
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hostile_states)

BOOST_AUTO_TEST_CASE(modified_cam_clay) {
  judge_law<law::CamClay>(1);
}
BOOST_AUTO_TEST_CASE(modified_cam_clay_with_mu_of_I_in_two_stages) {
  judge_law<law::CamClayMuI>(2);
}
BOOST_AUTO_TEST_CASE(modified_cam_clay_with_mu_of_I_consistently) {
  judge_law<law::CamClayMuIConsistent>(3);
}

BOOST_AUTO_TEST_CASE(drucker_prager_and_von_mises) {
  ref::Elasticity const elastic{1e6, 0.3, 3};
  long const each = support::hostile_states() / 8;
  Tally cone("drucker_prager"), viscous("drucker_prager_perzyna"), cylinder("von_mises");
  unsigned seed = 10;
  for (double const M : {1e-3, 0.57735, 5.0})
    for (double const c : {0.0, 1e-6, 1e3}) {
      judge_cone(
          law::DruckerPrager({{}, M, c}),
          [&](auto const& trial, double) {
            return ref::cone_step<Long>(elastic, {M, c}, trial);
          },
          ++seed, cone, each);
      law::DruckerPragerPerzyna::Parameters p;
      p.M = M, p.c = c, p.t_v = 1e-3, p.s = 0.7;
      judge_cone(
          law::DruckerPragerPerzyna(p),
          [&](auto const& trial, double dt) {
            return ref::cone_step<Long>(elastic, {M, c}, {p.t_v, p.s}, trial, dt);
          },
          ++seed, viscous, each);
    }
  for (double const q_y : {1e-9, 1.0, 1e9})
    judge_cone(
        law::VonMises({{}, q_y}),
        [&](auto const& trial, double) {
          return ref::cone_step<Long>(elastic, {0, q_y}, trial);
        },
        ++seed, cylinder, each * 3);
  cone.check(), viscous.check(), cylinder.check();
}

BOOST_AUTO_TEST_SUITE_END()
