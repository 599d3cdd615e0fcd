#pragma once
/// What every law must keep, as functions of the law alone: each answers how it was broken, or nothing.
///
/// So that a law that is added to the catalogue is tested before anyone writes a test for it.

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "core/dual.hpp"
#include "tests/contracts/law_steps.hpp"

namespace talus::contract_of {

/// What was found where a contract is broken.
inline std::string unless(bool kept, std::string const& what, double got, double limit) {
  if (kept) return {};
  std::ostringstream text;
  text << what << ' ' << got << " against " << limit;
  return text.str();
}

/// Strain and state in one number, which is finite where they are.
template <class Shape, class State>
double sum_of(Symmetric<double, Shape> const& strain, State const& state) {
  double const sum = std::accumulate(strain.entries.begin(), strain.entries.end(), 0.0);
  return std::accumulate(state.values.begin(), state.values.end(), sum);
}

/// tau = dPsi/deps by dual numbers; a shear entry stands for two.
template <class L>
std::string stress_is_the_gradient_of_the_energy() {
  return in_every_shape<L>([]<class Shape>(Step<L, Shape> const& step) -> std::string {
    constexpr int n = Symmetric<double, Shape>::size;
    Symmetric<Dual<n>, Shape> strain;
    for (int k = 0; k < n; ++k) strain[k] = Dual<n>::variable(step.result[k], k);
    Dual<n> const energy = step.law.energy(strain);
    auto const tau = step.law.stress(step.result);
    // energies are sums of terms of the order of G eps and lambda eps in their derivatives
    double const slack = step.slack() + 64 * eps * step.law.G;
    for (int k = 0; k < n; ++k) {
      double const off = std::abs(energy.derivative(k) - (k < Shape::normals ? 1 : 2) * tau[k]);
      if (!(off <= slack)) return unless(false, "gradient of the energy misses the stress [Pa] by", off, slack);
    }
    double const rest = support::largest(step.law.stress(Symmetric<double, Shape>{}));
    return unless(rest == 0, "stress at rest", rest, 0);
  });
}

/// y(result) <= 0, and every number that a law gives is finite.
template <class L>
std::string projection_is_admissible() {
  return in_every_shape<L>([]<class Shape>(Step<L, Shape> const& s) -> std::string {
    if constexpr (!L::rate_dependent) {
      double const y = s.yield(), slack = s.yield_slack();
      if (!(y <= slack)) return unless(false, "yield function [Pa] after the step", y, slack);
    }
    bool finite = std::isfinite(s.law.energy(s.result)) && std::isfinite(s.law.volume_ratio(s.result, s.after));
    for (double const value : s.law.derive(s.result, s.after).values) finite = finite && std::isfinite(value);
    return unless(finite, "energy, volume ratio or a derived field is not finite", 0, 0);
  });
}

/// A trial that is no number in the plane of motion gives a strain or a state that is none, whatever the other lanes
/// hold: the step looks at those only.
template <class L>
std::string projection_does_not_hide_what_is_no_number() {
  return in_every_shape<L>([]<class Shape>(Step<L, Shape> const& s) -> std::string {
    auto lost = s.trial;
    for (int i = 0; i < 2; ++i)
      for (int j = i; j < 2; ++j) lost(i, j) = std::numeric_limits<double>::quiet_NaN();
    Step<L, Shape> const alone{s.law, s.parameters, lost, s.before, s.dt};
    Symmetric<Lanes, Shape> trial;
    Record<Lanes, typename L::State> state;
    for (int lane = 0; lane < lanes; ++lane) {
      support::set_lane(trial, lane, lane == 3 ? lost : s.trial);
      support::set_lane(state, lane, s.before);
    }
    auto const result = s.law.project(trial, state, Lanes(s.dt));
    double const sums[] = {sum_of(alone.result, alone.after),
                           sum_of(support::lane_of(result, 3), support::lane_of(state, 3)),
                           sum_of(support::lane_of(result, 4), support::lane_of(state, 4))};
    bool const kept = !std::isfinite(sums[0]) && !std::isfinite(sums[1]) && std::isfinite(sums[2]);
    if (kept) return {};
    return unless(false, "beside a trial that is no number, strain and state sum up to", sums[1], sums[2]);
  });
}

/// An admissible trial stays as it is, bit for bit; what was changed lies on the surface, for any dt at least upon it.
/// A law that states that it is brittle may leave no stress instead.
template <class L>
std::string kuhn_tucker_conditions_hold() {
  return in_every_shape<L>([]<class Shape>(Step<L, Shape> const& s) -> std::string {
    bool const untouched = s.change() == 0 && s.after.values == s.before.values;
    if (s.law.yield(s.trial, s.before) <= 0)
      return unless(untouched, "an admissible strain was changed by", s.change(), 0);
    if (untouched || (is_brittle<L> && support::largest(s.result) == 0)) return {};
    double const y = s.yield(), slack = s.yield_slack();
    return unless(y >= -slack, "plastic flow below the yield surface, at [Pa]", y, -slack);
  });
}

/// A second projection changes nothing, nor does it add to the state, where the surface can be rested on.
template <class L>
std::string projection_is_idempotent() requires(!L::rate_dependent) {
  return in_every_shape<L>([]<class Shape>(Step<L, Shape> const& s) -> std::string {
    if (s.snaps()) return {};
    Step<L, Shape> const again{s.law, s.parameters, s.result, s.surface(), s.dt};
    double const weakest = std::min(s.law.G, s.law.template bulk<Shape>()), slack = s.yield_slack() / weakest;
    double added = again.change();
    for (std::size_t k = 0; k < s.after.values.size(); ++k)
      added = std::max(added, std::abs(again.after.values[k] - again.before.values[k]));
    return unless(added <= slack, "a second projection moved the strain by", added, slack);
  });
}

/// q falls with dt from at most q_tr to the yield surface, and never below.
template <class L>
std::string viscous_stress_lies_between_trial_and_yield() requires(L::rate_dependent) {
  return in_every_shape<L>([]<class Shape>(Step<L, Shape> const& s) -> std::string {
    double last = invariants(s.law, s.trial).q;
    for (double const dt : {0.0, 1e-12, 1e-8, 1e-6, 1e-4, 1e-2, 1e300}) {
      Step<L, Shape> const step{s.law, s.parameters, s.trial, s.before, dt};
      double const q = invariants(s.law, step.result).q;
      if (!(q <= last + s.slack() + step.yield_slack())) return unless(false, "q [Pa] rises with dt", q, last);
      last = q;
    }
    Step<L, Shape> const slow{s.law, s.parameters, s.trial, s.before, 1e300};
    double const y = slow.yield(), slack = slow.yield_slack();
    return unless(y <= slack, "yield function [Pa] after an endless step", y, slack);
  });
}

/// tau : d eps^P >= 0; where a law states that its whole is not, then at least that of the shear.
template <class L>
std::string plastic_work_is_never_negative() {
  return in_every_shape<L>([]<class Shape>(Step<L, Shape> const& s) -> std::string {
    auto const tau = s.law.stress(s.result), slip = s.trial - s.result;
    double const work = L::dissipative ? contract(tau, slip) : contract(deviator(tau), deviator(slip));
    double const limit = -(s.slack() + s.yield_slack()) * (support::largest(slip) + eps * support::largest(s.trial));
    return unless(work >= limit, "plastic work [J/m^3]", work, limit);
  });
}

/// J is the same before and after: what leaves the elastic volume is in the state.
template <class L>
std::string projection_keeps_the_volume() {
  return in_every_shape<L>([]<class Shape>(Step<L, Shape> const& s) -> std::string {
    double const before = std::log(s.law.volume_ratio(s.trial, s.before)),
                 after = std::log(s.law.volume_ratio(s.result, s.after));
    double const slack = 64 * eps * (1 + std::abs(before) + support::largest(s.trial));
    return unless(std::abs(after - before) <= slack, "ln J changed by", after - before, slack);
  });
}

/// How far two results may lie apart when the same step is computed in another order [1]. A viscous stress may hang on
/// the yield stress by any factor, so that there it is also asked what the last digits of the trial do.
template <class L, class Shape>
double apart(Step<L, Shape> const& s) {
  double const weakest = std::min(s.law.G, s.law.template bulk<Shape>());
  double noise = 0;
  if constexpr (L::rate_dependent) {
    auto const nudge = isotropic<Shape>(8 * eps * support::largest(s.trial));
    Step<L, Shape> const nudged{s.law, s.parameters, s.trial + nudge, s.before, s.dt};
    noise = support::largest(nudged.result - s.result);
  }
  return (s.slack() + s.yield_slack()) / weakest + noise;
}

/// Renaming x, y, z renames the entries of the result.
template <class L>
std::string result_does_not_depend_on_the_order_of_the_axes() {
  return in_every_step<L, shape::Solid>([](Step<L, shape::Solid> const& s) -> std::string {
    for (auto const& order : {std::array{1, 2, 0}, std::array{1, 0, 2}, std::array{0, 2, 1}}) {
      auto const renamed = [&](Symmetric<double, shape::Solid> const& a) {
        Symmetric<double, shape::Solid> r;
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = i; j < 3; ++j) r(static_cast<int>(i), static_cast<int>(j)) = a(order[i], order[j]);
        return r;
      };
      Step<L, shape::Solid> const other{s.law, s.parameters, renamed(s.trial), s.before, s.dt};
      double const off = support::largest(other.result - renamed(s.result));
      if (!(off <= apart(s))) return unless(false, "with the axes renamed the strain differs by", off, apart(s));
    }
    return {};
  });
}

/// Turning the trial strain turns the result: R project(eps) R^T = project(R eps R^T).
template <class L>
std::string projection_is_objective() {
  double const a = 0.7, b = -1.9;  // angles about z and x
  std::array<std::array<double, 3>, 3> const R{{{std::cos(a), -std::sin(a), 0},
                                                {std::cos(b) * std::sin(a), std::cos(b) * std::cos(a), -std::sin(b)},
                                                {std::sin(b) * std::sin(a), std::sin(b) * std::cos(a), std::cos(b)}}};
  auto const turned = [&](Symmetric<double, shape::Solid> const& e) {
    Symmetric<double, shape::Solid> r{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k)
          for (std::size_t l = 0; l < 3; ++l)
            r(static_cast<int>(i), static_cast<int>(j)) +=
                R[i][k] * R[j][l] * e(static_cast<int>(k), static_cast<int>(l));
    return r;
  };
  return in_every_step<L, shape::Solid>([&](Step<L, shape::Solid> const& s) {
    Step<L, shape::Solid> const other{s.law, s.parameters, turned(s.trial), s.before, s.dt};
    double const off = support::largest(other.result - turned(s.result));
    return unless(off <= apart(s), "after a rotation the strain differs by", off, apart(s));
  });
}

/// A lane of a pack has the bits that it has among other neighbours, and the digits of the same step with plain
/// numbers.
template <class L>
std::string a_pack_gives_the_same_as_its_lanes() {
  std::string first;
  std::vector<Step<L, shape::Plane>> steps;
  auto const compare = [&] {
    Symmetric<Lanes, shape::Plane> trial, turned;
    Record<Lanes, typename L::State> state, turned_state;
    Lanes dt(0.0), turned_dt(0.0);
    for (int lane = 0; lane < lanes; ++lane) {
      auto const& step = steps[static_cast<std::size_t>(lane)];
      int const place = (lane + 3) % lanes;
      support::set_lane(trial, lane, step.trial), support::set_lane(turned, place, step.trial);
      support::set_lane(state, lane, step.before), support::set_lane(turned_state, place, step.before);
      dt.set(lane, step.dt), turned_dt.set(place, step.dt);
    }
    // one lane has quite other neighbours
    support::set_lane(turned, 3, Symmetric<double, shape::Plane>{});
    auto const& law = steps.front().law;
    auto const packed = law.project(trial, state, dt), elsewhere = law.project(turned, turned_state, turned_dt);
    for (int lane = 0; lane < lanes && first.empty(); ++lane) {
      auto const& step = steps[static_cast<std::size_t>(lane)];
      auto const mine = support::lane_of(packed, lane);
      double const off = support::largest(mine - step.result);
      first = unless(off <= apart(step), "a lane differs from the plain number by", off, apart(step));
      int const place = (lane + 3) % lanes;
      bool const same = mine.entries == support::lane_of(elsewhere, place).entries &&
                        support::lane_of(state, lane).values == support::lane_of(turned_state, place).values;
      if (first.empty() && place != 3) first = unless(same, "a lane depends on its neighbours", lane, 0);
    }
  };
  L const* law = nullptr;
  for_each_step<L, shape::Plane>([&](Step<L, shape::Plane> const& step) {
    if (law != &step.law) steps.clear();
    law = &step.law;
    steps.push_back(step);
    if (steps.size() < static_cast<std::size_t>(lanes)) return;
    compare();
    steps.clear();
  });
  return first;
}

}  // namespace talus::contract_of
