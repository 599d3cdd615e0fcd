#pragma once
/// A body force that differs from particle to particle and from time to time, besides gravity.

#include "core/tensor.hpp"

namespace talus {

/// For example the force that makes a chosen motion the solution. A particle is known by its number, so that the force
/// may depend on where the particle came from.
template <int D>
class BodyForce {
 public:
  BodyForce() = default;
  BodyForce(BodyForce const&) = delete;
  virtual ~BodyForce() = default;

  /// Acceleration of the particle with this number at time t [s], the start of a step [m/s^2]. Called from all threads
  /// at once.
  [[nodiscard]] virtual Point<D> acceleration(long id, double t) const = 0;
};

}  // namespace talus
