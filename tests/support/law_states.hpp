#pragma once
/// Strains and states to try laws at.

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "core/law.hpp"

namespace talus::support {

inline double tan_deg(double degrees) {
  return std::tan(degrees * std::numbers::pi / 180);
}

/// The elastic strain whose Hencky stress has pressure p and shear stress q [Pa]; every entry of its deviator is at
/// work.
template <class Shape, class Law>
Symmetric<double, Shape> strain_of(Law const& law, double p, double q) {
  constexpr std::array<double, 6> solid{0.5, -0.3, -0.2, 0.4, 0.1, -0.25}, plane_strain{0.5, -0.4, -0.1, 0.3},
      plane{0.5, -0.5, 0.7};
  Symmetric<double, Shape> dev;
  for (int k = 0; k < dev.size; ++k) {
    auto const e = static_cast<std::size_t>(k);
    dev[k] = Shape::plane == 3 ? solid[e] : Shape::normals == 3 ? plane_strain[e] : plane[e];
  }
  double const K = law.template bulk<Shape>();
  return (q / (std::sqrt(2.0) * law.G * norm(dev))) * dev + isotropic<Shape>(-p / (K * Shape::normals));
}

/// Numbers spread evenly over the decades from `low` to `high`, of either sign.
class LogUniform {
 public:
  LogUniform(double low, double high, unsigned seed)
      : log_low_(std::log(low)), log_high_(std::log(high)), engine_(seed) {}
  double positive() { return std::exp(log_low_ + (log_high_ - log_low_) * unit_(engine_)); }
  double signed_() { return unit_(engine_) < 0.5 ? -positive() : positive(); }
  double unit() { return unit_(engine_); }

 private:
  double log_low_, log_high_;
  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> unit_{0, 1};
};

template <class Shape, class T>
Symmetric<double, Shape> lane_of(Symmetric<T, Shape> const& a, int lane) {
  Symmetric<double, Shape> r;
  for (int k = 0; k < r.size; ++k) r[k] = a[k][lane];
  return r;
}
template <class List, class T>
Record<double, List> lane_of(Record<T, List> const& a, int lane) {
  Record<double, List> r;
  for (std::size_t k = 0; k < r.values.size(); ++k) r.values[k] = a.values[k][lane];
  return r;
}
template <class Shape>
void set_lane(Symmetric<Lanes, Shape>& a, int lane, Symmetric<double, Shape> const& value) {
  for (int k = 0; k < a.size; ++k) a[k].set(lane, value[k]);
}
template <class List>
void set_lane(Record<Lanes, List>& a, int lane, Record<double, List> const& value) {
  for (std::size_t k = 0; k < a.values.size(); ++k) a.values[k].set(lane, value.values[k]);
}

/// Largest entry in magnitude.
template <class Shape>
double largest(Symmetric<double, Shape> const& a) {
  double r = 0;
  for (double const x : a.entries) r = std::max(r, std::abs(x));
  return r;
}

}  // namespace talus::support
