#include "verification/reference/rate_laws.hpp"

#include <limits>

#include "verification/reference/return_maps.hpp"

namespace talus::reference {

namespace {

/// The ellipse at a stress: y, its derivatives, and the measures of the rate.
struct EllipseAt {
  double p_c, P, S2, y, y_p, y_c;

  EllipseAt(Ellipse const& e, double strength, Stress const& at) : p_c(strength), P(at.p + e.beta * strength) {
    double const M2 = e.M * e.M;
    S2 = (p_c - at.p) * P;
    y = at.q * at.q - M2 * S2;
    y_p = M2 * (2 * at.p - (1 - e.beta) * p_c);
    y_c = -M2 * ((1 - e.beta) * at.p + 2 * e.beta * p_c);
  }
};

/// All but the flow, which is the same for every law on the ellipse.
RateLaw on_ellipse(Elasticity const& elastic, Ellipse const& ellipse, Hardening const& hardening, bool viscous) {
  double const K = elastic.K(), G = elastic.G();
  RateLaw law{elastic, initial_strength(hardening), viscous, {}, {}, {}, {}};
  auto const p_c = [=](double eps_V) { return strength(hardening, eps_V, K); };
  law.strength = p_c;
  law.excess = [=](Stress const& at) {
    double const c = p_c(at.eps_V);
    return EllipseAt(ellipse, c, at).y / (c * c);
  };
  law.loading = [=](Stress const& at, Driving const& by) {
    EllipseAt const e(ellipse, p_c(at.eps_V), at);
    return (2 * G * by.shear - K * e.y_p * by.volume) / (e.p_c * e.p_c);
  };
  return law;
}

/// (4) with gamma = rate(mu, P).
template <class Rate>
RateLaw on_dynamic_ellipse(Elasticity const& elastic, Ellipse const& ellipse, Hardening const& hardening, Rate rate) {
  RateLaw law = on_ellipse(elastic, ellipse, hardening, true);
  law.flow = [=, p_c = law.strength](Stress const& at, Driving const&) -> Flow {
    EllipseAt const e(ellipse, p_c(at.eps_V), at);
    double const S = std::sqrt(e.S2), mu = at.q / S, gamma = rate(mu, e.P);
    return {gamma / (2 * at.q), gamma * mu * ((1 - ellipse.beta) * e.p_c - 2 * at.p) / (2 * S)};
  };
  return law;
}

RateLaw on_cone(Elasticity const& elastic, Cone const& cone, bool viscous) {
  double const K = elastic.K(), G = elastic.G(), scale = std::max(cone.c, 1.0);
  RateLaw law{elastic, scale, viscous, {}, {}, {}, {}};
  law.strength = [=](double) { return scale; };
  law.excess = [=](Stress const& at) { return (at.q - cone.M * at.p - cone.c) / scale; };
  law.loading = [=](Stress const& at, Driving const& by) {
    return (G * by.shear / at.q + cone.M * K * by.volume) / scale;
  };
  return law;
}

}  // namespace

RateLaw cam_clay(Elasticity const& elastic, Ellipse const& ellipse, Hardening const& hardening) {
  double const K = elastic.K(), G = elastic.G();
  RateLaw law = on_ellipse(elastic, ellipse, hardening, false);
  law.flow = [=, p_c = law.strength](Stress const& at, Driving const& by) -> Flow {
    EllipseAt const e(ellipse, p_c(at.eps_V), at);
    double const H = strength_slope(hardening, at.eps_V, K);
    double const multiplier = (2 * G * by.shear - K * e.y_p * by.volume) /
                              (K * e.y_p * e.y_p + 4 * G * at.q * at.q + e.y_c * H * e.y_p);  // (3)
    return {multiplier, -multiplier * e.y_p};
  };
  return law;
}

RateLaw cam_clay_mu_i(Elasticity const& elastic, double beta, Hardening const& hardening, MuI const& m) {
  return on_dynamic_ellipse(elastic, {m.mu_1, beta}, hardening, [m](double mu, double P) {
    double const none = std::numeric_limits<double>::quiet_NaN();
    return mu < m.mu_2 ? m.Q() * std::sqrt(P) * (mu - m.mu_1) / (m.mu_2 - mu) : none;  // (5)
  });
}

RateLaw cam_clay_perzyna(Elasticity const& elastic, Ellipse const& ellipse, Hardening const& hardening,
                         Perzyna const& v) {
  return on_dynamic_ellipse(elastic, ellipse, hardening, [v, M = ellipse.M](double mu, double) {
    return (std::pow(mu / M, 1 / v.s) - 1) / v.t_v;  // (6)
  });
}

RateLaw cam_clay_duvaut_lions(Elasticity const& elastic, Ellipse const& ellipse, Hardening const& hardening,
                              DuvautLions const& v) {
  RateLaw law = on_ellipse(elastic, ellipse, hardening, true);
  law.flow = [=](Stress const& at, Driving const&) -> Flow {
    auto const m =
        cam_clay_projection<double>({elastic, ellipse, hardening, implicit_hardening}, {at.p, at.q, at.eps_V});
    double const gamma = (at.q - m.q) / (elastic.G() * v.t_v);
    return {at.q > 0 ? gamma / (2 * at.q) : 0, (m.p - at.p) / (elastic.K() * v.t_v)};  // (7)
  };
  return law;
}

RateLaw cone(Elasticity const& elastic, Cone const& cone) {
  RateLaw law = on_cone(elastic, cone, false);
  law.flow = [K = elastic.K(), G = elastic.G(), M = cone.M](Stress const& at, Driving const& by) -> Flow {
    return {(by.shear / at.q + M * K * by.volume / G) / (2 * at.q), 0};  // (8)
  };
  return law;
}

RateLaw cone_perzyna(Elasticity const& elastic, Cone const& cone, Perzyna const& v) {
  RateLaw law = on_cone(elastic, cone, true);
  law.flow = [cone, v](Stress const& at, Driving const&) -> Flow {
    return {(std::pow(at.q / (cone.M * at.p + cone.c), 1 / v.s) - 1) / (2 * v.t_v * at.q), 0};  // (9)
  };
  return law;
}

RateLaw cone_duvaut_lions(Elasticity const& elastic, Cone const& cone, DuvautLions const& v) {
  RateLaw law = on_cone(elastic, cone, true);
  law.flow = [cone, v, G = elastic.G()](Stress const& at, Driving const&) -> Flow {
    return {(at.q - cone.M * at.p - cone.c) / (2 * G * v.t_v * at.q), 0};  // (10)
  };
  return law;
}

}  // namespace talus::reference
