#include "verification/reference/flow/confined.hpp"

namespace talus::reference::flow {

namespace {

/// Of a pressure and a shear stress that depend on the place; `lever`: shear rate over the rate of the flow.
ShearFlow flow(Fluid const& fluid, double from, double to, Function const& p, Function const& q,
               Function const& lever) {
  return {from, to, [=](double x) { return fluid.rate(q(x), p(x)) / lever(x); },
          [=](double x, double rate) {
            return fluid.stress(rate * lever(x), p(x), fluid.critical_strength(p(x))) / q(x) - 1;
          }};
}

double one(double) {
  return 1;
}

}  // namespace

double PlaneShear::shear_stress() const {
  return fluid.ratio(fluid.friction.d * speed / gap * std::sqrt(fluid.friction.rho_s / pressure)) * pressure;
}

double PlaneShear::shear_stress_by_root() const {
  double const least = fluid.omega() * fluid.friction.mu_1 * pressure;
  double const most = fluid.omega() * fluid.friction.mu_2 * pressure;
  return root([&](double q) { return fluid.rate(q, pressure) * gap - speed; }, least, most * (1 - 1e-12));
}

double PlateOnBed::depth(double T) const {
  return (T / (fluid.omega() * fluid.friction.mu_1) - load) / (fluid.density * gravity);
}

double PlateOnBed::speed(double T) const {
  double const mu_1 = fluid.friction.mu_1, mu_2 = fluid.friction.mu_2, z_2 = std::sqrt(T / mu_2);
  auto const F = [&](double z) {
    double const logarithm = std::log((z - z_2) / (z + z_2));
    return -2 * mu_1 / (3 * mu_2) * z * z * z + 2 * T * (mu_2 - mu_1) / (mu_2 * mu_2) * (z + z_2 / 2 * logarithm);
  };
  double const w = fluid.omega() * fluid.density * gravity;
  return fluid.friction.Q() / w * (F(std::sqrt(T / mu_1)) - F(std::sqrt(fluid.omega() * load)));
}

ShearFlow PlateOnBed::flow(double T) const {
  auto const p = [*this](double x) { return load + fluid.density * gravity * x; };
  return flow::flow(
      fluid, depth(T), 0, p, [T](double) { return T; }, one);
}

namespace {

template <class Speed>
double plate_stress(PlateOnBed const& bed, double speed, Speed const& of) {
  double const least = bed.fluid.omega() * bed.fluid.friction.mu_1 * bed.load;
  double const most = bed.fluid.omega() * bed.fluid.friction.mu_2 * bed.load;
  return root([&](double T) { return of(T) - speed; }, least * (1 + 1e-6), most * (1 - 1e-6));
}

}  // namespace

double PlateOnBed::shear_stress(double target) const {
  return plate_stress(*this, target, [&](double T) { return speed(T); });
}

double PlateOnBed::shear_stress_by_quadrature(double target) const {
  return plate_stress(*this, target, [&](double T) { return speed_by_quadrature(flow(T), 0); });
}

double VerticalChute::plug() const {
  return fluid.friction.mu_1 * fluid.omega() * pressure / (fluid.density * gravity);
}

double VerticalChute::speed(double x) const {
  double const mu_1 = fluid.friction.mu_1, mu_2 = fluid.friction.mu_2, S = fluid.omega() * pressure;
  double const weight = fluid.density * gravity, s = std::max(weight * x / S, mu_1), wall = weight * half_width / S;
  double const A = fluid.friction.Q() * std::sqrt(S) * S / weight;
  return A * ((mu_2 - mu_1) * std::log((mu_2 - s) / (mu_2 - wall)) - (wall - s));
}

ShearFlow VerticalChute::flow() const {
  auto const q = [weight = fluid.density * gravity](double x) { return weight * x; };
  return flow::flow(
      fluid, half_width, plug(), [p = pressure](double) { return p; }, q, one);
}

double AnnularCouette::reach(double s_i) const {
  return inner_radius * std::sqrt(s_i / fluid.friction.mu_1);
}

double AnnularCouette::angular_speed(double s_i, double r) const {
  double const mu_1 = fluid.friction.mu_1, mu_2 = fluid.friction.mu_2;
  double const s = std::max(s_i * inner_radius * inner_radius / (r * r), mu_1);
  return fluid.friction.Q() * std::sqrt(fluid.omega() * pressure) / 2 *
         (-mu_1 / mu_2 * std::log(s / mu_1) - (1 - mu_1 / mu_2) * std::log((mu_2 - s) / (mu_2 - mu_1)));
}

ShearFlow AnnularCouette::flow(double s_i) const {
  double const moment = fluid.omega() * pressure * s_i * inner_radius * inner_radius;
  return flow::flow(
      fluid, reach(s_i), inner_radius, [p = pressure](double) { return p; },
      [moment](double r) { return moment / (r * r); }, [](double r) { return r; });
}

double AnnularCouette::wall_ratio(double target) const {
  return root([&](double s) { return angular_speed(s, inner_radius) - target; }, fluid.friction.mu_1,
              fluid.friction.mu_2 * (1 - 1e-12));
}

double ChannelFlow::depth() const {
  return width * (std::tan(slope) - fluid.omega() * fluid.friction.mu_1) / wall_friction;
}

double ChannelFlow::speed(double z) const {
  double const z_f = depth(), z_c = width * (fluid.omega() * fluid.friction.mu_2 - std::tan(slope)) / wall_friction;
  double const B = fluid.friction.Q() * std::sqrt(fluid.omega() * fluid.density * gravity * std::cos(slope));
  auto const F = [&](double w) {
    return (z_f + z_c) * (w - std::sqrt(z_c) * std::atan(w / std::sqrt(z_c))) - w * w * w / 3;
  };
  return 2 * B * (F(std::sqrt(z_f)) - F(std::sqrt(std::min(z, z_f))));
}

ShearFlow ChannelFlow::flow() const {
  double const weight = fluid.density * gravity * std::cos(slope);
  auto const p = [weight](double z) { return weight * z; };
  auto const q = [*this, p](double z) { return p(z) * (std::tan(slope) - wall_friction * z / width); };
  return flow::flow(fluid, depth(), 0, p, q, one);
}

}  // namespace talus::reference::flow
