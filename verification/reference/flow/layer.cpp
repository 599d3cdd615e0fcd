#include "verification/reference/flow/layer.hpp"

namespace talus::reference::flow {

namespace {

/// Shearing from y = `from` to `to` with that strength.
ShearFlow flow(Layer const& layer, double from, double to, Function const& strength) {
  auto const rate = [=](double y) {
    double const p = layer.pressure(y);
    return p > 0 ? layer.fluid.rate(layer.shear(y), p, strength(y)) : 0;
  };
  auto const imbalance = [=](double y, double gamma) {
    return layer.fluid.stress(gamma, layer.pressure(y), strength(y)) / layer.shear(y) - 1;
  };
  return {from, to, rate, imbalance};
}

}  // namespace

double bagnold_surface_speed(Layer const& layer) {
  Fluid const& f = layer.fluid;
  double const I = f.inertial_number(std::tan(layer.slope));
  if (!(I > 0)) return 0;
  return 2.0 / 3 * I / f.friction.d *
         std::sqrt(f.density * gravity * std::cos(layer.slope) / f.friction.rho_s * layer.h) * layer.h;
}

double bagnold_speed(Layer const& layer, double y) {
  return bagnold_surface_speed(layer) * (1 - std::pow(1 - y / layer.h, 1.5));
}

ShearFlow bagnold_flow(Layer const& layer) {
  return flow(layer, 0, layer.h, [=](double y) { return layer.fluid.critical_strength(layer.pressure(y)); });
}

double largest_cohesion(double slope, double mu_1) {
  return (std::tan(slope) - mu_1) / (std::tan(slope) + mu_1);
}

double largest_cohesion_by_root(Fluid fluid, double slope) {
  return root(
      [&](double beta) {
        fluid.beta = beta;
        return std::tan(slope) - fluid.ratio(0);
      },
      0, 0.9);
}

double PluggedLayer::strength(double y) const {
  return std::max(layer.fluid.critical_strength(layer.pressure(y)), kept);
}

double plug_ratio(Fluid const& fluid, double slope) {
  double const b = 1 - fluid.beta;
  double const steep = std::tan(slope) / fluid.friction.mu_1, c = 1 + steep * steep;
  return 2 * c / (b + std::sqrt(b * b + 4 * fluid.beta * c));
}

double PluggedLayer::plug_depth() const {
  return std::min(kept / plug_ratio(layer.fluid, layer.slope) / layer.pressure(0), 1.0) * layer.h;
}

double PluggedLayer::plug_depth_by_root() const {
  return layer.h - root(
                       [&](double y) {
                         double const p = layer.pressure(y);
                         double const S = p < strength(y) ? layer.fluid.size(p, strength(y)) : 0;
                         return layer.shear(y) - layer.fluid.friction.mu_1 * S;
                       },
                       layer.h - critical_depth(), layer.h * (1 - 1e-9));
}

double PluggedLayer::critical_depth() const {
  return std::min(kept * (1 - layer.fluid.beta) / (2 * layer.pressure(0)), 1.0) * layer.h;
}

ShearFlow PluggedLayer::below_kept() const {
  return flow(layer, 0, layer.h - critical_depth(), [*this](double y) { return strength(y); });
}

ShearFlow PluggedLayer::between() const {
  return flow(layer, layer.h - critical_depth(), layer.h - plug_depth(), [*this](double) { return kept; });
}

}  // namespace talus::reference::flow
