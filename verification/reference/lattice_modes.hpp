#pragma once
/// A wave on a lattice of particles, in closed form: what a transfer, and a whole elastic step, make of sin kx.
///
/// Along a row of nodes x_i = i h with n particles a cell, x_p = (p + 1/2) h/n, all weighing the same, a field of the
/// nodes a exp(ikx_i) comes back from the particles as a multiple of itself. With N the B-spline of degree p and
/// D = (p + 1) h^2/12, of the node x_0 = 0:
///
///   S = 1/n sum_p N(x_p) sum_i N(x_p - x_i) cos kx_i                      velocity to the particles and back      (1)
///   s = 1/(n D) sum_p N(x_p) (-x_p) sum_i N(x_p - x_i) (x_i - x_p) cos kx_i    what C_p adds                  (2)
///   Q = 1/n sum_p N'(x_p) sum_i N'(x_p - x_i) cos kx_i                    gradient, then force                     (3)
///
/// A step of dt on an elastic row with wave speed c, from the amplitudes of v (what the particles' velocities give the
/// nodes), u (the nodes' velocity of the step before, as C_p has it; without C_p, s = 0) and a (the stress's force on a
/// unit mass):
///
///   u'  = v + s u - dt a
///   v'  = alpha (v - S dt a) + (1 - alpha) S u'                                                                   (4)
///   a'  = a + dt c^2 Q u'              gradient of the nodes' velocity
///   a'  = a + dt c^2 Q (v' + s u')     or of the one that is mapped back
///
/// The eigenvalue exp((-delta + i omega) dt) of (4) that oscillates is what the scheme does to the wave, with all its
/// errors in space and time. To leading order, without those in time,
///
///   omega = c k (1 - (p + 1)/12 (kh)^2) without C_p and alpha = 1,  c k (1 - (p + 1)/24 (kh)^2) with C_p.
///
/// Derived here.

#include <complex>

namespace talus::reference {

/// Cardinal B-spline of a degree, centred at 0 with knots one apart, by the recursion of Cox and de Boor from degree 1 on.
[[nodiscard]] double cardinal_spline(int degree, double x);
/// Its derivative.
[[nodiscard]] double cardinal_spline_slope(int degree, double x);

/// Blend alpha: 0 replaces velocities, 1 increments them. maps_back: the gradient is that of (4), last line.
struct Transfer {
  int degree = 2;
  bool affine = false;
  double alpha = 0;
  bool maps_back = false;
};

/// (1) to (3), with h = 1.
struct LatticeMode {
  double S, s, Q;
};
[[nodiscard]] LatticeMode lattice_mode(Transfer const&, int particles_per_cell, double kh);

/// The oscillating eigenvalue of (4), imaginary part positive; courant = c dt/h.
[[nodiscard]] std::complex<double> wave_factor(Transfer const&, int particles_per_cell, double kh, double courant);

}  // namespace talus::reference
