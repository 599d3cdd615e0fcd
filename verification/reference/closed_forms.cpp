#include "verification/reference/closed_forms.hpp"

#include <gsl/gsl_sf_lambert.h>

#include <cmath>
#include <string>

#include "verification/reference/gsl_calls.hpp"

namespace talus::reference {

namespace {

/// W0(x): W exp(W) = x. GSL's tolerance is a few epsilon.
double lambert(double x) {
  gsl::Quiet const quiet;
  gsl_sf_result result{};
  gsl::check(gsl_sf_lambert_W0_e(x, &result), "gsl_sf_lambert_W0_e(" + std::to_string(x) + ")");
  return result.val;
}

}  // namespace

double isotropic_compression(double K, ExponentialStrength const& h, double eps_v) {
  return K / h.xi * lambert(h.xi * h.p_c0 / K * std::exp(h.xi * eps_v));
}

PressureAndShear constant_volume_critical_state(double K, Ellipse const& e, ExponentialStrength const& h, double p_i) {
  double const p = K / h.xi * lambert((1 - e.beta) * h.xi * h.p_c0 / (2 * K) * std::exp(h.xi * p_i / K));
  return {p, e.M * p * (1 + e.beta) / (1 - e.beta)};
}

double MuIStartUp::limit() const {
  double const a = law.Q() * std::sqrt(P);
  return (shear_rate * law.mu_2 + a * law.mu_1) / (shear_rate + a);
}

double MuIStartUp::time(double x) const {
  double const a = law.Q() * std::sqrt(P), end = limit();
  return S / (G * (shear_rate + a)) * ((x - law.mu_1) - (law.mu_2 - end) * std::log((end - x) / (end - law.mu_1)));
}

double MuIStartUp::friction(double t) const {
  double const a = law.Q() * std::sqrt(P), end = limit(), range = law.mu_2 - end, u = (end - law.mu_1) / range;
  return end - range * lambert(u * std::exp(u - G * (shear_rate + a) / (S * range) * t));
}

double critical_friction(MuI const& m, double beta, double p, double shear_rate) {
  double const omega = (1 + beta) / (1 - beta), I = m.d * shear_rate * std::sqrt(m.rho_s / p);
  return omega * (m.mu_1 + (m.mu_2 - m.mu_1) / (std::sqrt(omega) * m.I_0 / I + 1));
}

double linear_viscous_stress(double G, double q_y, double eta, double q_0, double shear_rate, double t) {
  double const end = q_y + eta * shear_rate;
  return end + (q_0 - end) * std::exp(-G * t / eta);
}

DirectShear steady_direct_shear(double G, MuI const& m, ExponentialStrength const& h, double sigma_n,
                                double shear_rate) {
  double p = sigma_n, q = 0, gamma = shear_rate;
  for (int k = 0; k < 100; ++k) {  // contracts by q/G a time
    q = critical_friction(m, 0, p, gamma) * p;
    p = sigma_n - q * std::tanh(q / G);
    gamma = std::abs(shear_rate) / std::cosh(q / G);
  }
  return {p, q, q / std::cosh(q / G), gamma, std::log(h.p_c0 / (2 * p)) / h.xi};
}

}  // namespace talus::reference
