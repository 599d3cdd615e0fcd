#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>

#include "core/config/parameters.hpp"
#include "models/laws/parts/ellipse.hpp"
#include "models/laws/parts/fields.hpp"
#include "models/laws/parts/hencky.hpp"

namespace talus::law {

/// The mu(I) rheology of dense granular flow as a viscous overstress on the Cam-Clay ellipse of slope mu_1.
///
///   q = mu(I) S,   mu(I) = mu_1 + (mu_2 - mu_1)/(I_0/I + 1),   I = d gamma sqrt(rho_s/P)                      (1)
///
/// or, solved for the rate, with the overstress z = q - mu_1 S, its limit L = (mu_2 - mu_1) S, Q = I_0/(d sqrt(rho_s)),
///
///   gamma = Q sqrt(P) z/(L - z),   0 <= z < L.                                                                (2)
///
/// Over a step q = q_tr - G dt gamma. With O = q_tr - mu_1 S and R = G dt Q sqrt(P) this and (2) give
///
///   z^2 - (O + L + R) z + O L = 0,   z = 2 O L/(O + L + R + sqrt((O - L)^2 + R (2 (O + L) + R))),             (3)
///
/// the smaller root, in which nothing cancels. gamma [1/s]: plastic shear rate sqrt(2 D' : D'). S, P [Pa]:
/// EllipsePoint.
///
/// At critical state q/p = w (mu_1 + (mu_2 - mu_1)/(sqrt(w) I_0/I_p + 1)) with w = (1 + beta)/(1 - beta) and
/// I_p = d gamma sqrt(rho_s/p), which for beta = 0 is the law of Jop et al.
///
/// Source: Jop, Forterre & Pouliquen (2006), doi:10.1038/nature04801; on the ellipse: Blatny, Gray & Gaume (2024),
/// doi:10.1017/jfm.2024.643; (3) derived here.
struct MuI {
  static constexpr bool rate_dependent = true, shares_flow = false;
  using Derived = Fields<field::Friction, field::InertialNumber, field::ShearRate>;

  struct Parameters {
    double mu_1 = 0.381863, mu_2 = 0.643468;  // tan 20.9 deg, tan 32.76 deg: glass beads
    double I_0 = 0.279, d = 2.5e-3, rho_s = 2500;
    static constexpr auto table() {
      return std::tuple{
          parameter(&Parameters::mu_1, "mu_1", "mu_1", "1", "friction of slow flow", non_negative).usual(0, 3),
          parameter(&Parameters::mu_2, "mu_2", "mu_2", "1", "friction of fast flow, at least mu_1", non_negative)
              .usual(0, 3),
          parameter(&Parameters::I_0, "I_0", "I_0", "1", "inertial number half-way from mu_1 to mu_2", positive),
          parameter(&Parameters::d, "grain_diameter", "d", "m", "grain diameter", positive).usual(1e-7, 0.1),
          parameter(&Parameters::rho_s, "grain_density", "rho_s", "kg/m^3", "density of the grains", positive)
              .usual(10, 3e4),
      };
    }
    static std::optional<std::string> check(Parameters const& p) {
      if (p.mu_2 >= p.mu_1) return {};
      return "mu_2 must be at least mu_1: friction does not fall with the shear rate";
    }
  };

  double mu_1, mu_2, I_0, Q;
  explicit MuI(Parameters const& p) : mu_1(p.mu_1), mu_2(p.mu_2), I_0(p.I_0), Q(p.I_0 / (p.d * std::sqrt(p.rho_s))) {}

  /// Slope of the yield surface. Where mu_1 is 0 the ellipse is all but flat.
  [[nodiscard]] double slope() const { return std::max(mu_1, least_slope); }

  [[nodiscard]] bool viscous() const { return mu_2 > slope(); }

  /// Shear stress at the end of the step [Pa]: (3).
  template <Scalar T>
  [[nodiscard]] T relax(T q_tr, EllipsePoint<T> const& at, double G, T dt) const {
    T const q_y = T(slope()) * at.S, O = max(T(0.0), T(q_tr - q_y)), L = T(mu_2 - mu_1) * at.S;
    T const R = T(G * Q) * dt * sqrt(at.P), sum = O + L, gap = O - L;
    T const z = T(2.0) * O * L / (sum + R + sqrt(T(gap * gap + R * (sum + sum + R))) + T(least_stress));
    return q_y + z;
  }

  /// q/S of (3), also where S and with it q vanish [1].
  template <Scalar T>
  [[nodiscard]] T friction_of_step(T q_tr, EllipsePoint<T> const& at, double G, T dt) const {
    T const O = max(T(0.0), T(q_tr - T(slope()) * at.S)), L = T(mu_2 - mu_1) * at.S;
    T const R = min(T(1e100), T(T(G * Q) * dt * sqrt(at.P))), sum = O + L, gap = O - L;
    return T(slope()) + T(2 * (mu_2 - mu_1)) * O / (sum + R + sqrt(T(gap * gap + R * (sum + sum + R))) + T(1e-300));
  }
  template <Scalar T>
  [[nodiscard]] T share(T /*trial*/, T flowed, T /*dt*/) const {
    return flowed;
  }

  /// q/S between mu_1, which it is for elastic states too, and mu_2.
  template <Scalar T>
  [[nodiscard]] T friction(T q, EllipsePoint<T> const& at) const {
    return max(T(mu_1), min(T(mu_2), T(q / (at.S + T(least_stress)))));
  }

  /// The rate (2) that the state tells of; 0 where it is elastic.
  template <Scalar T, class List>
  void derive(T q, EllipsePoint<T> const& at, double /*G*/, Record<T, List>& derived) const {
    T const z = max(T(0.0), T(q - T(slope()) * at.S)), L = T(mu_2 - mu_1) * at.S;
    // I/I_0, of which the state tells at most 12 digits
    T const ratio = min(T(1e12), T(z / max(T(L - z), T(T(1e-12) * at.S + T(least_stress)))));
    derived[field::friction] = friction(q, at);
    derived[field::inertial_number] = T(I_0) * ratio;
    derived[field::shear_rate] = T(Q) * sqrt(at.P) * ratio;
  }
};

}  // namespace talus::law
