#pragma once
/// The generalised vortex: rings of a solid turn against each other, to and fro.
///
///   r = R,   theta = Theta + alpha(R, t),   alpha = A sin(w t) g(R)                                      (1)
///   g = (1 - 16 s^2)^q,   s = R - 1,   for |s| < 1/4, else 0                                             (2)
///
/// J = 1; with gamma = R alpha' the stress in the turned axes (r, theta) is
///
///   sigma_rt = 2 G asinh(gamma/2)/sqrt(1 + gamma^2/4),   sigma_rr = -sigma_tt = -gamma/2 sigma_rt   Hencky       (3)
///   sigma_rt = G gamma,   sigma_rr = 0,   sigma_tt = G gamma^2                                     neo-Hookean   (4)
///   b_r = -R alpha_t^2 - (sigma_rr' + (sigma_rr - sigma_tt)/R)/rho_0                                             (5)
///   b_t = R alpha_tt - (sigma_rt' + 2 sigma_rt/R)/rho_0
///
/// q = 2 is the published form; there alpha'' and with it b jump at the rim. For q = 4 the slope of b is continuous.
///
/// Source: Kamojjala, Brannon, Sadeghirad & Guilkey (2015), doi:10.1007/s00366-013-0342-x; (3), (5): derived here.

#include "core/tensor.hpp"
#include "verification/exact/elastic.hpp"

namespace talus::exact {

struct Vortex {
  static constexpr int dimension = 2;
  double amplitude = 0;                ///< A [1]
  double frequency = 0;                ///< w [1/s]
  int power = 2;                       ///< q
  Point<2> centre = Point<2>::Zero();  ///< [m]
  static constexpr double rim = 0.25;  ///< half of the ring's width [m]

  /// Whether the solid moves there.
  [[nodiscard]] bool moves(Point<2> const& X) const { return std::abs((X - centre).norm() - 1) < rim; }

  /// (1), (2).
  template <Scalar T>
  [[nodiscard]] Vector<T, 2> position(Vector<T, 2> const& X, T const& t) const {
    using std::cos, std::sin, std::sqrt;
    T const x = X[0] - T(centre[0]), y = X[1] - T(centre[1]), square = x * x + y * y;
    if (square <= T((1 - rim) * (1 - rim)) || square >= T((1 + rim) * (1 + rim))) return X;
    T const s = sqrt(square) - T(1.0);
    T g(1.0);
    for (int k = 0; k < power; ++k) g = g * (T(1.0) - T(16.0) * s * s);
    T const alpha = T(amplitude) * sin(T(frequency * t)) * g, c = cos(alpha), S = sin(alpha);
    return {T(centre[0]) + c * x - S * y, T(centre[1]) + S * x + c * y};
  }

  /// (5), turned into x and y [m/s^2].
  [[nodiscard]] Point<2> body_force(Elastic const& solid, Point<2> const& X, double t) const {
    Point<2> const from = X - centre;
    double const R = from.norm();
    if (!moves(X)) return Point<2>::Zero();
    double const s = R - 1, w = 1 - 16 * s * s, now = amplitude * std::sin(frequency * t);
    double const g = std::pow(w, power), g1 = -32 * s * power * std::pow(w, power - 1);
    double const g2 = 1024 * s * s * power * (power - 1) * std::pow(w, power - 2) - 32 * power * std::pow(w, power - 1);
    double const alpha = now * g, slope = now * g1, curvature = now * g2;
    double const rate = amplitude * frequency * std::cos(frequency * t) * g, second = -frequency * frequency * alpha;
    Stress const sigma = stress(solid, R * slope, slope + R * curvature);
    double const radial = -R * rate * rate - (sigma.rr_slope + (sigma.rr - sigma.tt) / R) / solid.density;
    double const around = R * second - (sigma.rt_slope + 2 * sigma.rt / R) / solid.density;
    double const c = std::cos(alpha), S = std::sin(alpha);
    Point<2> const out = Point<2>(c * from[0] - S * from[1], S * from[0] + c * from[1]) / R;
    return {radial * out[0] - around * out[1], radial * out[1] + around * out[0]};
  }

 private:
  struct Stress {
    double rr, rt, tt, rr_slope, rt_slope;
  };
  /// (3), (4), and d/dR of them, of gamma and its slope.
  [[nodiscard]] static Stress stress(Elastic const& solid, double gamma, double slope) {
    double const G = solid.G;
    if (solid.law == ElasticLaw::neo_hookean) return {0, G * gamma, G * gamma * gamma, 0, G * slope};
    double const stretch = 1 + gamma * gamma / 4, root = std::sqrt(stretch), angle = std::asinh(gamma / 2);
    double const rt = 2 * G * angle / root;
    double const rt_slope = G * slope * (1 / stretch - angle * gamma / (2 * stretch * root));
    double const rr = -gamma / 2 * rt;
    return {rr, rt, -rr, -(slope * rt + gamma * rt_slope) / 2, rt_slope};
  }
};

}  // namespace talus::exact
