#pragma once
/// The generalised vortex with a smooth rim in Hencky's material: a ring of 0.75 m < R < 1.25 m turns and the rest does
/// not, on a square of 3 m that is periodic and full of material.

#include <numbers>

#include "verification/exact/vortex.hpp"
#include "verification/manufactured/drive.hpp"

namespace talus::manufactured {

inline constexpr double vortex_side = 3;  // [m]

/// Amplitude 0.1, turned at a frequency of half a hertz, q = 4.
inline exact::Vortex vortex_motion() {
  return {0.1, std::numbers::pi, 4, {vortex_side / 2, vortex_side / 2}};
}
/// E = 1000 Pa, nu = 0.3, rho_0 = 1000 kg/m^3.
inline exact::Elastic vortex_solid() {
  return exact::Elastic::of(exact::ElasticLaw::hencky, 1000, 0.3, 1000);
}

/// N cells along a side, n particles a cell and axis; to t = 0.5 s at a Courant number of 0.2.
inline Discretisation<2> vortex_discretisation(Scheme const& scheme, int N, int n) {
  constexpr double end = 0.5, courant = 0.2;
  double const h = vortex_side / N;
  long const steps = std::lround(end * vortex_solid().wave_speed() / (courant * h));
  Discretisation<2> with{scheme, h, end / double(steps), steps, {N / 4, N / 4}};
  with.places = verification::lattice<2>(Point<2>::Zero(), {N, N}, {n, n}, h);
  with.volume = h * h / (n * n);
  return with;
}

}  // namespace talus::manufactured
