#pragma once
/// Contracts of plastic flow: its direction, and the rate that a viscous stress tells of.

#include <cmath>
#include <string>

#include "core/dual.hpp"
#include "tests/contracts/law_contracts.hpp"

namespace talus::contract_of {

/// What a law's plastic flow is normal to.
template <class L, class T, class Shape>
T potential(L const& law, Symmetric<T, Shape> const& strain, Record<T, typename L::State> const& state) {
  if constexpr (requires { law.potential(strain, state); })
    return law.potential(strain, state);
  else
    return law.yield(strain, state);
}

/// The gradient of the potential in the space of strains, as a unit tensor; 0 where it is not a number. A shear entry
/// stands for two.
template <class L, class Shape>
Symmetric<double, Shape> normal(L const& law, Symmetric<double, Shape> const& at,
                                Record<double, typename L::State> const& state) {
  constexpr int n = Symmetric<double, Shape>::size;
  Symmetric<Dual<n>, Shape> strain;
  for (int k = 0; k < n; ++k) strain[k] = Dual<n>::variable(at[k], k);
  Record<Dual<n>, typename L::State> fixed;
  for (std::size_t k = 0; k < state.values.size(); ++k) fixed.values[k] = state.values[k];
  Dual<n> const value = potential(law, strain, fixed);
  Symmetric<double, Shape> gradient;
  for (int k = 0; k < n; ++k) gradient[k] = value.derivative(k) / (k < Shape::normals ? 1 : 2);
  double const size = support::largest(gradient);
  if (!std::isfinite(size) || size == 0) return {};
  gradient = (1 / size) * gradient;
  return (1 / norm(gradient)) * gradient;
}

/// The stress that a step takes away is normal to the potential in the space of elastic strains: C d eps^P is along its
/// gradient. Measured where flow and normal are known to three digits; that there is such flow is part of the contract.
template <class L>
std::string flow_is_normal_to_the_potential() requires(is_associated<L>) {
  long told = 0;
  std::string broken = in_every_shape<L>([&]<class Shape>(Step<L, Shape> const& s) -> std::string {
    auto const taken = s.law.stress(s.trial) - s.law.stress(s.result);
    double const size = norm(taken);
    if (!(size > 1e4 * (s.slack() + s.yield_slack()))) return {};
    auto const along = normal(s.law, s.result, s.surface());
    double unsure = (s.slack() + s.yield_slack()) / size;
    for (double const sign : {-1.0, 1.0}) {  // what the rounding of the result does to its normal
      auto nudged = s.result;
      for (double& entry : nudged.entries) entry += sign * 1e3 * eps * support::largest(s.trial);
      unsure += norm(along - normal(s.law, nudged, s.surface()));
    }
    if (!(unsure < 1e-3)) return {};
    ++told;
    double const off = norm((1 / size) * taken - along);
    return unless(off <= 1e-9 + 100 * unsure, "flow is off the normal by", off, 1e-9 + 100 * unsure);
  });
  if (broken.empty() && told < 100)
    return unless(false, "steps that tell of a normal:", static_cast<double>(told), 100);
  return broken;
}

/// The shear rate that the state after a step tells of is (q_tr - q)/(G dt), the one with which the step was made: the
/// discrete flow law holds. Measured where the rate follows from the state with three digits.
template <class L>
std::string viscous_flow_law_is_satisfied() requires(L::rate_dependent) {
  long told = 0;
  std::string broken = in_every_shape<L>([&]<class Shape>(Step<L, Shape> const& s) -> std::string {
    if (!s.law.viscous() || (is_brittle<L> && support::largest(s.result) == 0)) return {};
    double const slip = invariants(s.law, s.trial).q - invariants(s.law, s.result).q, made = slip / (s.law.G * s.dt);
    double doubt = s.yield_slack();  // of p: rounding, and where the search for it ends
    if constexpr (L::Derived::template holds<field::CompressiveStrength>)
      doubt += 1e-12 * s.law.derive(s.result, s.surface())[field::compressive_strength];
    auto const rate = [&](double stretch) {
      Record<double, typename L::State> state = s.surface();
      for (double& value : state.values) value += stretch * (std::abs(value) + support::largest(s.trial));
      auto const dev = deviator(s.result);  // of which rounding leaves less, the more of the strain is pressure
      double const noise = 1 + support::largest(s.result) / std::max(support::largest(dev), 1e-300);
      auto strain = s.result + stretch * noise * dev;
      double const volume = doubt / s.law.template volumetric_modulus<Shape>();
      strain = strain + isotropic<Shape>(stretch * support::largest(s.trial) + std::copysign(volume, stretch));
      return s.law.derive(strain, state)[field::shear_rate];
    };
    double const told_of = s.law.derive(s.result, s.surface())[field::shear_rate],
                 slack = s.slack() / (s.law.G * s.dt) + 1e-9 * made + std::abs(rate(64 * eps) - told_of) +
                         std::abs(rate(-64 * eps) - told_of);
    if (!(slip > 0) || !(slack < 1e-3 * std::min(made, told_of))) return {};
    ++told;
    return unless(std::abs(told_of - made) <= 4 * slack, "rate [1/s] of the state", told_of, made);
  });
  if (broken.empty() && told < 100) return unless(false, "steps that tell of a rate:", static_cast<double>(told), 100);
  return broken;
}

/// What a law gives back before it projects is part of its projection, keeps the volume, and is not given twice.
template <class L>
std::string recovery_is_part_of_the_projection() requires(Recovers<L>) {
  return in_every_shape<L>([]<class Shape>(Step<L, Shape> const& s) -> std::string {
    for (double const change : {-2.0, -0.5, 0.0, 0.5}) {  // from a gap that opened, closing it in part and whole
      auto const trial = s.result + change * isotropic<Shape>(trace(s.trial) / Shape::normals);
      auto recovered = trial;
      auto state = s.after;
      s.law.recover(recovered, state);
      Step<L, Shape> const whole{s.law, s.parameters, trial, s.after, s.dt};
      Step<L, Shape> const rest{s.law, s.parameters, recovered, state, s.dt};
      if (whole.result.entries != rest.result.entries || whole.after.values != rest.after.values)
        return unless(false, "recovery before the projection moved it by", support::largest(whole.result - rest.result),
                      0);
      double const before = std::log(s.law.volume_ratio(trial, s.after)),
                   after = std::log(s.law.volume_ratio(recovered, state));
      double const slack = 64 * eps * (1 + std::abs(before) + support::largest(trial));
      if (!(std::abs(after - before) <= slack)) return unless(false, "recovery changed ln J by", after - before, slack);
      auto again = recovered;
      auto same = state;
      s.law.recover(again, same);
      if (support::largest(again - recovered) > 0) return unless(false, "given back twice", 0, 0);
    }
    return {};
  });
}

}  // namespace talus::contract_of
