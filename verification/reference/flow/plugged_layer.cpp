#include "verification/reference/flow/plugged_layer.hpp"

#include <gsl/gsl_sf_lambert.h>

#include <algorithm>
#include <cmath>

#include "verification/reference/flow/gsl.hpp"
#include "verification/reference/flow/layer.hpp"

namespace talus::reference::flow {

namespace {

/// J of the plug at a pressure, (1).
double plug_stretch(CompressiblePluggedLayer const& plugged, double p) {
  Fluid const& fluid = plugged.layer.fluid;
  return std::pow(fluid.hardening.p_c0 / plugged.kept, 1 / fluid.hardening.xi) * std::exp(-p / fluid.elastic.K());
}

}  // namespace

double CompressiblePluggedLayer::pressure(double Y) const {
  double const N = layer.normal_stress(Y), K = layer.fluid.elastic.K();
  if (kept <= 0 || Y < plug_begin()) return layer.pressure(N);
  return K * gsl_sf_lambert_W0(N * plug_stretch(*this, 0) / K);
}

double CompressiblePluggedLayer::strength(double Y) const {
  return Y < plug_begin() ? layer.fluid.critical_strength(pressure(Y)) : kept;
}

double CompressiblePluggedLayer::stretch(double Y) const {
  double const p = pressure(Y);
  return kept <= 0 || Y < plug_begin() ? layer.stretch(p) : plug_stretch(*this, p);
}

double CompressiblePluggedLayer::plug_begin() const {
  if (kept <= 0) return layer.h_0;
  double const p = kept / plug_ratio(layer.fluid, layer.slope);
  return std::clamp(layer.h_0 - p / plug_stretch(*this, p) / layer.weight(), 0.0, layer.h_0);
}

ShearFlow CompressiblePluggedLayer::below() const {
  auto const pressure_below = [critical = layer](double Y) { return critical.pressure(critical.normal_stress(Y)); };
  auto const rate = [=, critical = layer](double Y) {
    double const p = pressure_below(Y);
    return p > 0 ? critical.fluid.rate(p * std::tan(critical.slope), p) * critical.stretch(p) : 0;
  };
  auto const imbalance = [=, critical = layer](double Y, double shear) {
    double const p = pressure_below(Y), p_c = critical.fluid.critical_strength(p);
    return critical.fluid.stress(shear / critical.stretch(p), p, p_c) / (p * std::tan(critical.slope)) - 1;
  };
  return {0, plug_begin(), rate, imbalance};
}

double CompressiblePluggedLayer::height(double Y) const {
  auto const J = [this](double at) { return stretch(at); };
  double const bend = std::min(Y, plug_begin());
  return integral(J, 0, bend) + (Y > bend ? integral(J, bend, Y) : 0);
}

}  // namespace talus::reference::flow
