#pragma once
/// What a constitutive law is: elastic logarithmic strain to stress, and trial strain to admissible strain.
///
/// A law is a pure function of strain, its own fields and the time step. It knows no particle, loop, grid or file, and
/// it works over every scalar: branch-free on data, so that one page serves numbers, packs and derivatives.

#include <concepts>
#include <string_view>

#include "core/config/parameters.hpp"
#include "core/fields.hpp"
#include "core/tensor.hpp"

namespace talus {

/// What every law answers for the shape S of its strain and the scalar T. `eps` is the elastic Hencky strain [1].
template <class L, class T, class S>
concept LawFor = requires(L const law, Symmetric<T, S> const eps, Record<T, typename L::State> state,
                          Record<T, typename L::State> const fixed, T dt) {
  /// Kirchhoff stress [Pa], tension positive: the gradient of `energy`.
  { law.stress(eps) } -> std::same_as<Symmetric<T, S>>;
  /// Stored energy per reference volume [J/m^3].
  { law.energy(eps) } -> std::same_as<T>;
  /// The return map: takes the trial strain and the fields after the last step, gives the admissible strain and sets
  /// the fields to those after this step of dt [s]. What is no number in the trial stays none: the step looks for it.
  { law.project(eps, state, dt) } -> std::same_as<Symmetric<T, S>>;
  /// Yield function [Pa]: about the distance of the stress from the yield surface, zero or less inside. A law without a
  /// surface answers -1.
  { law.yield(eps, fixed) } -> std::same_as<T>;
  /// Fields for output, recomputed from strain and state.
  { law.derive(eps, fixed) } -> std::same_as<Record<T, typename L::Derived>>;
  /// J = det F: elastic times plastic change of volume [1].
  { law.volume_ratio(eps, fixed) } -> std::same_as<T>;
};

/// A constitutive law.
///
/// `State` are the scalar fields that it keeps of a particle besides the strain, `Derived` those that it can compute
/// for output. It states of itself what the contract tests measure: `rate_dependent`, whether the result of a step
/// depends on dt; `dissipative`, whether the plastic work tau : d eps^P of every step is zero or more.
template <class L>
concept Law = Described<typename L::Parameters> && std::constructible_from<L, typename L::Parameters const&> &&
    LawFor<L, double, shape::Solid> && LawFor<L, double, shape::PlaneStrain> && LawFor<L, Lanes, shape::Plane> &&
    requires(L const law) {
  { L::name } -> std::convertible_to<std::string_view>;
  { L::title } -> std::convertible_to<std::string_view>;
  { L::source } -> std::convertible_to<std::string_view>;
  { L::rate_dependent } -> std::convertible_to<bool>;
  { L::dissipative } -> std::convertible_to<bool>;
  /// d_s lambda + 2 G [Pa]: of a change of volume.
  { law.template volumetric_modulus<shape::Plane>() } -> std::same_as<double>;
  /// The stiffest answer to a motion in so many dimensions [Pa]: the modulus that limits the time step.
  { law.stiffest_modulus(2) } -> std::same_as<double>;
  /// lambda + 2 G [Pa]: of waves of compression.
  { law.wave_modulus() } -> std::same_as<double>;
  /// The fields of a particle that was never deformed.
  { law.template initial<shape::Solid>() } -> std::same_as<Record<double, typename L::State>>;
};

/// Pressure, positive in compression, and shear stress ||dev tau||/sqrt(2) [Pa].
template <Scalar T>
struct Invariants {
  T p, q;
};

/// p and q of the stress that a law gives a strain.
template <class L, class T, class Shape>
Invariants<T> invariants(L const& law, Symmetric<T, Shape> const& eps) {
  auto const tau = law.stress(eps);
  return {pressure(tau), shear_stress(tau)};
}

}  // namespace talus
