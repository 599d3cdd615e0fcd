#pragma once
/// The return map of Cam-Clay in fifty digits by bisection: the judge of the one that is used.

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "models/laws/cam_clay_mu_i.hpp"
#include "models/laws/modified_cam_clay.hpp"

namespace talus::support {

using Real = boost::multiprecision::cpp_bin_float_50;

/// Root of a function that is negative at `a` and positive at `b`.
template <class F>
Real bisect(F f, Real a, Real b) {
  for (int k = 0; k < 180; ++k) {
    Real const middle = (a + b) / 2;
    (f(middle) > 0 ? b : a) = middle;
  }
  return (a + b) / 2;
}

/// A plastic step of the mu(I) law: the map with the plastic multiplier written out, by bisection from the
/// critical-state pressure to the trial pressure.
struct ExactCamClay {
  Real p, p_c, q_y, eps_V, q, rate;

  ExactCamClay(law::CamClayMuI const& law, double bulk, Real p_tr, Real q_tr, Real eps_n, double dt) {
    Real const M = law.surface.M, beta = law.surface.beta, K = bulk, G = law.G, xi = law.hardening.xi;
    auto const strength = [&](Real x) { return law.hardening.p_c0 * exp(-xi * (eps_n + (x - p_tr) / K)); };
    auto const D = [&](Real x) { return Real(2 * x - (1 - beta) * strength(x)); };
    Real const side = D(p_tr) > 0 ? 1 : -1;
    Real const far = p_tr - side * 1e5;
    Real const critical = bisect([&](Real x) { return Real(side * D(x)); }, far, p_tr);
    auto const r = [&](Real x) {
      Real const multiplier = (p_tr - x) / (K * M * M * D(x)), q_x = q_tr / (1 + 2 * G * multiplier);
      return Real(q_x * q_x + M * M * (x - strength(x)) * (x + beta * strength(x)));
    };
    p = D(p_tr) == 0 ? p_tr : bisect(r, critical, p_tr);
    p_c = strength(p);
    Real const P = p + beta * p_c, S = sqrt((p_c - p) * P);
    q_y = M * S;
    eps_V = eps_n + (p - p_tr) / K;

    Real const A = G * Real(dt), O = q_tr - q_y, Q = law.rate.Q;
    Real const B = Real(law.rate.mu_2 - law.rate.mu_1) * S + A * Q * sqrt(P) - O, C = O * Q * sqrt(P);
    rate = (-B + sqrt(B * B + 4 * A * C)) / (2 * A);
    q = q_tr - A * rate;
  }
};

}  // namespace talus::support
