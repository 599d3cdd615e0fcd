/// Return maps from hostile trial states: stresses over 24 decades, every corner of the parameters, tip, cap and apex.
///
/// The judge is the same step by bisection in extended precision (64 bits), which on a sample is itself judged in fifty
/// digits; steps of the consistent map are judged in fifty digits, one in a hundred. The error is the distance to the
/// judge over the largest of p_c, |p| and q. Where the strength falls faster than the stress there may be several roots: a
/// step far from the judge's is as good if the equations change sign within 1e-10 of it. TALUS_HOSTILE_STATES is the number of
/// states a law.

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

BOOST_AUTO_TEST_SUITE(hostile_states)

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

/// The rate law, counting how often the consistent map asks it: once an evaluation of its two searches.
struct CountingMuI : law::MuI {
  mutable int asked = 0;
  template <Scalar T>
  [[nodiscard]] T friction_of_step(T q_tr, law::EllipsePoint<T> const& at, double G, T dt) const {
    ++asked;
    return MuI::friction_of_step(q_tr, at, G, dt);
  }
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
      Long const gap = O - most;
      return m.mu_1 * S + 2 * O * most / (O + most + R + std::sqrt(gap * gap + R * (2 * (O + most) + R)));
    }
    return corner.M * S;
  }

  /// At a pressure: how far the flow rule is from the surface [Pa], and the shear stress of the flow law.
  struct Miss {
    Long surface, q;
  };
  [[nodiscard]] Miss miss(Trial const& t, Long p) const {
    Long const beta = corner.beta, M = corner.M, way = Long(t.p) - p;
    Long const p_c = ref::strength<Long>(judge.hardening, Long(t.eps_V) - way / K, K);
    Long const D = 2 * p - (1 - beta) * p_c, P = std::max(Long(0), p + beta * p_c);
    Long const S = std::sqrt(std::max(Long(0), (p_c - p) * P)), q = relaxed(t.q, S, P, t.dt);
    Long const mu = consistent<L> ? (S > 0 ? q / S : M) : M;
    Long const by_flow = t.q * D / (D + 2 * G * way / (K * mu * mu));
    return {by_flow - mu * S, q};
  }
  /// Whether the equations have a root within 1e-10 of this stress.
  [[nodiscard]] bool solves(Trial const& t, Stress const& s, Long size) const {
    Long const off = 1e-10L * size;
    Miss const a = miss(t, s.p - off), b = miss(t, s.p + off);
    bool const between = s.q >= std::min(a.q, b.q) - off && s.q <= std::max(a.q, b.q) + off;
    return between && (a.surface > 0) != (b.surface > 0);
  }

  void judge_one(Tally& tally, Trial const& t, Stress const& found) const {
    ++tally.plastic;
    if (!std::isfinite(found.p) || !std::isfinite(found.q)) {
      ++tally.not_finite;
      return;
    }
    Long const beta = corner.beta, p_c = ref::strength<Long>(judge.hardening, Long(t.eps_V) + (found.p - t.p) / K, K);
    Long const size = std::max({p_c, std::abs(found.p), found.q}), slack = 1e-10L * size;
    bool const between = found.p <= p_c + slack && found.p >= -beta * p_c - slack;
    if (!between || found.q < 0 || found.q > t.q * (1 + 1e-15)) ++tally.outside;
    if (consistent<L> && tally.plastic % 100 != 1) return;
    auto const truth = judged(t);
    Long error = std::max(std::abs(found.p - truth.p), std::abs(found.q - truth.q)) / size;
    if (!(error <= 1e-6L) && solves(t, found, size)) ++tally.elsewhere, error = 0;
    Long const before = ref::strength<Long>(judge.hardening, Long(t.eps_V), K);
    tally.error(static_cast<double>(error), t, corner.text(), corner.xi * std::max(before, p_c) > 100 * K);
    if (!consistent<L> && tally.plastic % 997 == 1) check_judge(tally, t, truth, size);
  }

  [[nodiscard]] Stress judged(Trial const& t) const {
    if constexpr (!consistent<L>) {
      auto const truth = exact<Long>(t);
      return {truth.p, truth.q};
    } else {
      auto const truth = exact<ref::Digits>(t);
      return {static_cast<Long>(truth.p), static_cast<Long>(truth.q)};
    }
  }

  void check_judge(Tally& tally, Trial const& t, Stress const& truth, Long size) const {
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
  int evaluations = 0;
  if constexpr (consistent<L>) {
    CountingMuI const counting{court.law.rate};
    law::ConsistentMap<law::ExponentialHardening, CountingMuI> const map{court.law.surface, court.law.hardening,
                                                                         counting, m};
    static_cast<void>(map(trial, dt, plastic));
    evaluations = counting.asked;
  } else {
    using Hardening = std::remove_cvref_t<decltype(court.law.hardening)>;
    law::CamClayMap<Hardening> const map{court.law.surface, court.law.hardening, court.K, court.G};
    evaluations = map(p, q, eps_V, p_c, plastic).iterations;
  }
  tally.most_iterations = std::max(tally.most_iterations, evaluations);
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
    auto const [p_tr, q_tr, dev] = law.split(trial);
    auto state = law.template initial<shape::Solid>();
    auto const [p, q, direction] = law.split(law.project(trial, state, t.dt));
    ++tally.tried;
    if (p == p_tr && q == q_tr) continue;
    ++tally.plastic;
    if (!std::isfinite(p) || !std::isfinite(q)) ++tally.not_finite;
    auto const truth = exact(ref::StressOf<Long>{p_tr, q_tr, 0}, t.dt);
    Long const size = std::max({std::abs(Long(p_tr)), Long(q_tr), std::abs(truth.p)});
    tally.error(static_cast<double>(std::max(std::abs(p - truth.p), std::abs(q - truth.q)) / size), t, "");
    if (q < 0 || q > q_tr + 1e-14L * size) ++tally.outside;
  }
}

}  // namespace

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
