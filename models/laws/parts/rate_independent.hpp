#pragma once

#include "models/laws/parts/slope.hpp"

namespace talus::law {

/// Shear stress that does not depend on the rate of shear: the friction coefficient is the slope of the surface.
///
/// What every rate law answers, here in its simplest form. A step has two parts: `relax`, the shear stress that the
/// flow law leaves at a point of the surface, and `share`, how far the stress comes on its way there.
template <class Slope>
struct RateIndependent : Slope {
  static constexpr bool rate_dependent = false;
  /// True where the step does the same part of the plastic flow in volume and in shear.
  static constexpr bool shares_flow = false;
  using Derived = typename Slope::Derived;
  using Slope::Slope;

  /// Shear stress of the flow law [Pa]: the yield stress.
  template <Scalar T>
  [[nodiscard]] T relax(T /*q_tr*/, EllipsePoint<T> const& at, double /*G*/, T /*dt*/) const {
    return T(this->slope()) * at.S;
  }
  /// Where p or q is after the step: all the way from its trial value to what the flow asks for.
  template <Scalar T>
  [[nodiscard]] T share(T /*trial*/, T flowed, T /*dt*/) const {
    return flowed;
  }
  template <Scalar T>
  [[nodiscard]] T friction(T /*q*/, EllipsePoint<T> const& /*at*/) const {
    return T(this->M);
  }
  template <Scalar T, class List>
  void derive(T q, EllipsePoint<T> const& at, double /*G*/, Record<T, List>& derived) const {
    if constexpr (Derived::template holds<field::Friction>) derived[field::friction] = friction(q, at);
  }
};

}  // namespace talus::law
