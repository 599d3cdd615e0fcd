#pragma once
/// Standing waves along all axes of a unit box.

#include <numbers>

#include "verification/exact/axis_aligned.hpp"
#include "verification/manufactured/drive.hpp"

namespace talus::manufactured {

/// u_i = 0.05 m sin(2 pi X_i) sin(w t + phi_i): phi_y = pi in the plane, so that one axis
/// is stretched where the other is compressed; all in phase in space.
template <int D>
exact::AxisAligned<D> box_motion() {
  using std::numbers::pi;
  exact::AxisAligned<D> motion{Point<D>::Constant(0.05), 2 * pi, pi};
  if (D == 2) motion.phase[1] = pi;
  return motion;
}
/// nu = 0.3, waves of 1 m/s.
inline exact::Elastic box_solid() {
  auto solid = exact::Elastic::of(exact::ElasticLaw::hencky, 1, 0.3, 1);
  solid.density = solid.lambda + 2 * solid.G;
  return solid;
}

/// N cells along an edge, n particles in each along an axis; to t = 0.5 s.
template <int D>
Discretisation<D> box_discretisation(Scheme const& scheme, int N, int n, double courant) {
  double const h = 1.0 / N;
  Discretisation<D> with{scheme, h, courant * h, std::lround(0.5 / (courant * h))};
  with.periods.fill(N / 4);
  std::array<int, D> cells, per_axis;
  cells.fill(N);
  per_axis.fill(n);
  with.places = verification::lattice<D>(Point<D>::Zero(), cells, per_axis, h);
  with.volume = std::pow(h / n, D);
  return with;
}

}  // namespace talus::manufactured
