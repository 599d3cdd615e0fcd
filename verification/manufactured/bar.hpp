#pragma once
/// The periodic bar, 1 m long, as a strip of the plane four cells wide.

#include <numbers>

#include "verification/exact/axis_aligned.hpp"
#include "verification/manufactured/drive.hpp"

namespace talus::manufactured {

/// u_x = 0.05 m sin(2 pi X) sin(pi t): cells are crossed, F within 0.69 ... 1.31.
inline exact::AxisAligned<2> bar_motion() {
  return {{0.05, 0}, 2 * std::numbers::pi, std::numbers::pi};
}
/// lambda = 0, so that nothing pushes across the strip; lambda + 2 G = 1 Pa, rho_0 = 1 kg/m^3: waves travel at 1 m/s.
inline exact::Elastic bar_solid(exact::ElasticLaw law) {
  return exact::Elastic::of(law, 1, 0, 1);
}

/// N cells along the bar, n particles in each, one across; to t = 0.5 s at this Courant number.
inline Discretisation<2> bar_discretisation(Scheme const& scheme, int N, int n, double courant = 0.2) {
  double const h = 1.0 / N;
  Discretisation<2> with{scheme, h, courant * h, std::lround(0.5 / (courant * h)), {N / 4, 1}};
  with.places = verification::lattice<2>(Point<2>::Zero(), {N, 4}, {n, 1}, h);
  with.volume = h * h / n;
  return with;
}

}  // namespace talus::manufactured
