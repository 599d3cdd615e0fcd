#pragma once
/// The steps that the contracts of laws are tried on: corners of the parameters' table, strains of all sizes, states
/// that the law reaches itself.

#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/law.hpp"
#include "models/laws/parts/fields.hpp"
#include "tests/support/law_states.hpp"

namespace talus::contract_of {

inline constexpr double eps = std::numeric_limits<double>::epsilon();

/// Values of a parameter to try: its default, and the ends of where it was validated, else of what is possible.
template <class Row, class Parameters>
std::vector<double> values_of(Row const& row, Parameters const& defaults) {
  double const at = defaults.*row.member;
  if (row.tried.bounded_below()) return {at, row.tried.low, row.tried.high};
  double const large = at == 0 ? 100 : 100 * std::abs(at);
  double const low = !row.range.bounded_below()  ? -large
                     : !row.range.low_is_open    ? row.range.low
                     : row.range.bounded_above() ? row.range.low + 0.01 * (row.range.high - row.range.low)
                                                 : row.range.low + 0.01 * (at - row.range.low);
  double const high = !row.range.bounded_above() ? large
                      : !row.range.high_is_open  ? row.range.high
                                                 : row.range.high - 0.01 * (row.range.high - row.range.low);
  return {at, low, high};
}

/// The defaults, and all that differ from them in one parameter that is at an end of its range.
template <class L>
std::vector<typename L::Parameters> corners() {
  using Parameters = typename L::Parameters;
  std::vector<Parameters> all{Parameters{}};
  for_each_parameter<Parameters>([&](auto const& row) {
    auto const values = values_of(row, Parameters{});
    for (std::size_t k = 1; k < values.size(); ++k) {
      Parameters changed{};
      changed.*row.member = values[k];
      if constexpr (Checked<Parameters>)
        if (Parameters::check(changed)) continue;
      all.push_back(changed);
    }
  });
  return all;
}

/// What a law may state of itself beside what every law states; each is measured by a contract.
///
/// The plastic flow is normal to a level of `potential`, or of `yield` where the law has none.
template <class L>
inline constexpr bool is_associated = requires {
  requires L::associated;
};
/// The stress after a step lies on the surface of the strength before it.
template <class L>
inline constexpr bool hardens_explicitly = requires {
  requires L::hardens_explicitly;
};
/// Failure in tension leaves no stress, and not one on the surface.
template <class L>
inline constexpr bool is_brittle = requires {
  requires L::brittle;
};
/// Before it projects, the law gives plastic strain back to the elastic strain.
template <class L>
concept Recovers = requires(L const law, Symmetric<double, shape::Solid> strain,
                            Record<double, typename L::State> state) {
  law.recover(strain, state);
};

/// A trial strain, the state before the step, and what the law makes of them.
template <class L, class Shape>
struct Step {
  using Strain = Symmetric<double, Shape>;
  using State = Record<double, typename L::State>;
  L const& law;
  typename L::Parameters const& parameters;
  Strain trial;
  State before;
  double dt;
  State after = before;
  Strain result = law.project(trial, after, dt);

  /// The state in which the yield surface is as the step saw it.
  [[nodiscard]] State const& surface() const {
    if constexpr (hardens_explicitly<L>)
      return before;
    else
      return after;
  }
  /// y after the step [Pa].
  [[nodiscard]] double yield() const { return law.yield(result, surface()); }

  /// What rounding may do to a stress of this step [Pa].
  [[nodiscard]] double slack() const {
    double const size = std::max(support::largest(trial), support::largest(result));
    return 64 * eps * (2 * law.G + std::abs(law.lambda) * Shape::normals) * size + 1e-250;
  }
  /// What rounding of the strain and of the state may do to the yield function [Pa].
  [[nodiscard]] double yield_slack() const {
    double const size = support::largest(trial);
    State nudged = surface();
    for (double& value : nudged.values) value += 64 * eps * (std::abs(value) + size);
    Strain stretched = result;
    for (double& entry : stretched.entries) entry += 64 * eps * size;
    double const here = yield();
    double largest = std::abs(law.yield(Strain{}, surface()));  // the largest stress that the yield surface knows
    if constexpr (L::Derived::template holds<field::CompressiveStrength>)
      largest = std::max(largest, law.derive(result, surface())[field::compressive_strength]);
    // at a frozen strength the step to a flat tip may be the last one of the search, which ends within 1e-12 p_c
    double const searched = hardens_explicitly<L> ? 1e-12 : 64 * eps;
    return searched * largest + slack() + std::abs(law.yield(result, nudged) - here) +
           std::abs(law.yield(stretched, surface()) - here);
  }
  /// True where flow that went on by itself would raise the yield function: a strength that falls faster than the
  /// stress does. There is no rest on such a surface.
  [[nodiscard]] bool snaps() const {
    constexpr double further = 1e-3;
    State later = after;
    for (std::size_t k = 0; k < later.values.size(); ++k)
      later.values[k] += further * (after.values[k] - before.values[k]);
    return law.yield(result - further * (trial - result), later) > law.yield(result, after);
  }
  [[nodiscard]] double change() const { return support::largest(result - trial); }
};

/// A strain of random size and direction.
template <class Shape>
Symmetric<double, Shape> random_strain(support::LogUniform& random) {
  Symmetric<double, Shape> strain;
  for (double& entry : strain.entries) entry = 2 * random.unit() - 1;
  auto const dev = deviator(strain);
  double const shear = random.positive(), volume = random.signed_();
  return (shear / norm(dev)) * dev + isotropic<Shape>(volume / Shape::normals);
}

/// Calls f(Step) for every corner of the parameters, with strains from 1e-8 to 0.1 in states that a few steps lead to.
template <class L, class Shape>
void for_each_step(std::function<void(Step<L, Shape> const&)> const& f) {
  unsigned seed = 1;
  for (auto const& parameters : corners<L>()) {
    L const law(parameters);
    support::LogUniform random(1e-8, 0.1, seed++);
    for (int walk = 0; walk < 12; ++walk) {
      auto state = law.template initial<Shape>();
      Symmetric<double, Shape> strain{};
      for (int k = 0; k < 8; ++k) {
        double const dt = std::pow(10, -8 + 6 * random.unit());
        auto trial = strain + random_strain<Shape>(random);
        if constexpr (Recovers<L>) law.recover(trial, state);  // the contracts speak of what comes after
        Step<L, Shape> const step{law, parameters, trial, state, dt};
        f(step);
        if (k % 2 == 0) std::tie(strain, state) = std::pair{step.result, step.after};
      }
    }
  }
}

/// What tells a step from the others: stress, parameters that are not at their default.
template <class L, class Shape>
std::string describe(Step<L, Shape> const& s) {
  std::ostringstream text;
  auto const trial = invariants(s.law, s.trial), result = invariants(s.law, s.result);
  text << " (p " << trial.p << " -> " << result.p << ", q " << trial.q << " -> " << result.q << ", dt " << s.dt;
  for_each_parameter<typename L::Parameters>([&](auto const& row) {
    if (s.parameters.*row.member != typename L::Parameters{}.*row.member)
      text << ", " << row.name << ' ' << s.parameters.*row.member;
  });
  for (double const value : s.before.values) text << ", state " << value;
  text << ", " << Shape::normals << " normals)";
  return text.str();
}

/// Calls a contract of one step for every step of a shape until one is broken.
template <class L, class Shape>
std::string in_every_step(std::function<std::string(Step<L, Shape> const&)> const& broken) {
  std::string first;
  for_each_step<L, Shape>([&](Step<L, Shape> const& step) {
    if (!first.empty()) return;
    first = broken(step);
    if (!first.empty()) first += describe(step);
  });
  return first;
}

/// The same in space and in both kinds of plane strain.
template <class L, class F>
std::string in_every_shape(F&& broken) {
  std::string first = in_every_step<L, shape::Solid>(broken);
  if (first.empty()) first = in_every_step<L, shape::PlaneStrain>(broken);
  if (first.empty()) first = in_every_step<L, shape::Plane>(broken);
  return first;
}

}  // namespace talus::contract_of
