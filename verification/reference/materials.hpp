#pragma once
/// What a material is made of, for the truths of this folder. Nothing of core/ or models/ is used here.

#include <algorithm>
#include <cmath>
#include <variant>

namespace talus::reference {

/// Hencky elasticity.
///
///   tau = lambda tr(eps) I + 2 G eps,   p = -K tr(eps),   q = sqrt(2) G ||dev eps||                               (1)
///   G = E/(2 (1 + nu)),   lambda = 2 G nu/(1 - 2 nu),   K = lambda + 2 G/normals                                  (2)
///
/// eps [1]: Hencky strain of b^e, tension positive; tau [Pa]: Kirchhoff stress; p [Pa]: -tr(tau)/normals, positive in
/// compression; q [Pa]: ||dev tau||/sqrt(2). normals: the normal strains that take part: 3 in space and in plane
/// strain, 2 where everything lives in the plane ("reduced": zz is left out of I, traces and deviators).
struct Elasticity {
  double E, nu;
  int normals;

  [[nodiscard]] double G() const { return E / (2 * (1 + nu)); }
  [[nodiscard]] double lambda() const { return 2 * G() * nu / (1 - 2 * nu); }
  [[nodiscard]] double K() const { return lambda() + 2 * G() / normals; }
};

/// p_c = p_c0.
struct ConstantStrength {
  double p_c0;
};
/// p_c = p_c0 exp(-xi eps_V^P).
struct ExponentialStrength {
  double p_c0, xi;
};
/// p_c = K sinh(-xi eps_V^P + asinh(p_c0/K)).
struct HyperbolicSineStrength {
  double p_c0, xi;
};
/// Compressive strength p_c [Pa] as it depends on the plastic volumetric strain eps_V^P [1], positive in dilation.
/// Source: Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643; Gaume et al. (2018), doi:10.1038/s41467-018-05181-w.
using Hardening = std::variant<ConstantStrength, ExponentialStrength, HyperbolicSineStrength>;

[[nodiscard]] inline double initial_strength(Hardening const& hardening) {
  return std::visit([](auto const& h) { return h.p_c0; }, hardening);
}

/// The formula of the law, of any sign and size.
template <class T>
[[nodiscard]] T unlimited(ConstantStrength const& h, T const&, double) {
  return T(h.p_c0);
}
template <class T>
[[nodiscard]] T unlimited(ExponentialStrength const& h, T const& eps_V, double) {
  using std::exp;
  return h.p_c0 * exp(T(-h.xi * eps_V));
}
template <class T>
[[nodiscard]] T unlimited(HyperbolicSineStrength const& h, T const& eps_V, double K) {
  using std::asinh, std::sinh;
  return K * sinh(T(asinh(T(T(h.p_c0) / K)) - h.xi * eps_V));
}

/// p_c [Pa], kept in  [max(1e-9 p_c0, 1e-100 Pa), 10 K].
template <class T>
[[nodiscard]] T strength(Hardening const& hardening, T const& eps_V, double K) {
  T const least = std::max(1e-9 * initial_strength(hardening), 1e-100), most = 10 * K;
  T const free = std::visit([&](auto const& h) { return unlimited<T>(h, eps_V, K); }, hardening);
  return free > most ? most : (free > least ? free : least);
}

/// dp_c/deps_V^P [Pa] within that range.
[[nodiscard]] inline double strength_slope(Hardening const& hardening, double eps_V, double K) {
  if (auto const* h = std::get_if<ExponentialStrength>(&hardening)) return -h->xi * unlimited(*h, eps_V, K);
  if (auto const* h = std::get_if<HyperbolicSineStrength>(&hardening))
    return -h->xi * K * std::cosh(std::asinh(h->p_c0 / K) - h->xi * eps_V);
  return 0;
}

/// Yield surface of modified Cam-Clay,  y = q^2 - M^2 (p_c - p)(p + beta p_c).
struct Ellipse {
  double M, beta;
};
/// Yield surface of Drucker-Prager,  y = q - M p - c;  von Mises for M = 0. c [Pa].
struct Cone {
  double M, c;
};
/// mu(I) = mu_1 + (mu_2 - mu_1)/(I_0/I + 1),  I = d gamma sqrt(rho_s/P).  d [m], rho_s [kg/m^3].
struct MuI {
  double mu_1, mu_2, I_0, d, rho_s;
  /// I_0/(d sqrt(rho_s)) [1/(s sqrt(Pa))].
  [[nodiscard]] double Q() const { return I_0 / (d * std::sqrt(rho_s)); }
};
/// q = q_y (1 + t_v gamma)^s.  t_v [s].
struct Perzyna {
  double t_v, s;
};
/// The stress relaxes towards its projection within the time t_v [s].
struct DuvautLions {
  double t_v;
};

}  // namespace talus::reference
