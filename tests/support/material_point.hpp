#pragma once
/// A material point, moved by increments of strain.

#include "core/law.hpp"

namespace talus::support {

/// Strain and state of a law, from rest.
template <class Shape, class L>
struct MaterialPoint {
  L const& law;
  Symmetric<double, Shape> eps{};
  Record<double, typename L::State> state = law.template initial<Shape>();

  void step(Symmetric<double, Shape> const& increment, double dt) { eps = law.project(eps + increment, state, dt); }
  [[nodiscard]] double p() const { return invariants(law, eps).p; }
  [[nodiscard]] double q() const { return invariants(law, eps).q; }
  [[nodiscard]] double derived(auto which) const { return law.derive(eps, state)[which]; }
};

/// Simple shear by a small angle gamma in the plane of the first two axes.
template <class Shape>
Symmetric<double, Shape> simple_shear(double gamma) {
  Symmetric<double, Shape> e{};
  e(0, 1) = 0.5 * gamma;
  return e;
}

}  // namespace talus::support
