#include "verification/reference/flow/plugged_layer.hpp"

#include <gsl/gsl_sf_lambert.h>

#include <algorithm>
#include <cmath>

#include "verification/reference/flow/gsl.hpp"

namespace talus::reference::flow {

namespace {

/// (4).
double critical_pressure(CompressibleLayer const& layer, double N) {
  Fluid const& fluid = layer.fluid;
  double const a = 1 / fluid.hardening.xi, K = fluid.elastic.K();
  double const c = std::pow(fluid.hardening.p_c0 * (1 - fluid.beta) / 2, a);
  return N > 0 ? (1 + a) * K * gsl_sf_lambert_W0(std::pow(c * N, 1 / (1 + a)) / ((1 + a) * K)) : 0;
}

/// J of p and p_c, (1).
double stretch_of(Fluid const& fluid, double p, double p_c) {
  return std::pow(fluid.hardening.p_c0 / p_c, 1 / fluid.hardening.xi) * std::exp(-p / fluid.elastic.K());
}

}  // namespace

double CompressiblePluggedLayer::pressure(double Y) const {
  double const N = layer.normal_stress(Y), K = layer.fluid.elastic.K();
  if (kept <= 0 || Y < plug_begin()) return critical_pressure(layer, N);
  double const loose = std::pow(layer.fluid.hardening.p_c0 / kept, 1 / layer.fluid.hardening.xi);
  return K * gsl_sf_lambert_W0(N * loose / K);
}

double CompressiblePluggedLayer::strength(double Y) const {
  return Y < plug_begin() ? layer.fluid.critical_strength(pressure(Y)) : kept;
}

double CompressiblePluggedLayer::stretch(double Y) const {
  return stretch_of(layer.fluid, pressure(Y), strength(Y));
}

double CompressiblePluggedLayer::plug_begin() const {
  if (kept <= 0) return layer.h_0;
  double const beta = layer.fluid.beta, b = 1 - beta;
  double const steep = std::tan(layer.slope) / layer.fluid.friction.mu_1, c = 1 + steep * steep;
  double const p = kept * (b + std::sqrt(b * b + 4 * beta * c)) / (2 * c);
  return std::clamp(layer.h_0 - p / stretch_of(layer.fluid, p, kept) / layer.weight(), 0.0, layer.h_0);
}

ShearFlow CompressiblePluggedLayer::below() const {
  Fluid const fluid = layer.fluid;
  double const slope = std::tan(layer.slope);
  auto const rate = [=, *this](double Y) {
    double const p = critical_pressure(layer, layer.normal_stress(Y)), p_c = fluid.critical_strength(p);
    return p > 0 ? fluid.rate(p * slope, p, p_c) * stretch_of(fluid, p, p_c) : 0;
  };
  auto const imbalance = [=, *this](double Y, double shear) {
    double const p = critical_pressure(layer, layer.normal_stress(Y)), p_c = fluid.critical_strength(p);
    return fluid.stress(shear / stretch_of(fluid, p, p_c), p, p_c) / (p * slope) - 1;
  };
  return {0, plug_begin(), rate, imbalance};
}

double CompressiblePluggedLayer::height(double Y) const {
  auto const J = [this](double at) { return stretch(at); };
  double const bend = std::min(Y, plug_begin());
  return integral(J, 0, bend) + (Y > bend ? integral(J, bend, Y) : 0);
}

}  // namespace talus::reference::flow
