#pragma once

#include "core/fields.hpp"
#include "core/tensor.hpp"

namespace talus::law {

/// A law that is nothing but its elasticity: no state, no yield.
template <class Elasticity>
struct Elastic : Elasticity {
  static constexpr bool rate_dependent = false, dissipative = true;
  using State = Fields<>;
  using Derived = Fields<>;
  using Elasticity::Elasticity;

  template <class Shape>
  [[nodiscard]] Record<double, State> initial() const {
    return {};
  }
  /// Every strain is admissible.
  template <Scalar T, class Shape>
  [[nodiscard]] Symmetric<T, Shape> project(Symmetric<T, Shape> const& trial, Record<T, State>& /*state*/,
                                            T /*dt*/) const {
    return trial;
  }
  template <Scalar T, class Shape>
  [[nodiscard]] T yield(Symmetric<T, Shape> const& /*eps*/, Record<T, State> const& /*state*/) const {
    return T(-1.0);
  }
  template <Scalar T, class Shape>
  [[nodiscard]] Record<T, Derived> derive(Symmetric<T, Shape> const& /*eps*/, Record<T, State> const& /*state*/) const {
    return {};
  }
  template <Scalar T, class Shape>
  [[nodiscard]] T volume_ratio(Symmetric<T, Shape> const& eps, Record<T, State> const& /*state*/) const {
    return exp(trace(eps));
  }
};

}  // namespace talus::law
