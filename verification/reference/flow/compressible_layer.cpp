#include "verification/reference/flow/compressible_layer.hpp"

#include <gsl/gsl_sf_lambert.h>

#include <array>

#include "verification/reference/flow/banded.hpp"
#include "verification/reference/flow/gsl.hpp"

namespace talus::reference::flow {

namespace {

/// The layer by its coordinate s, (7), and what it sums up from the base, as rates of s: y, u and h_0 times both means.
class ByShear {
 public:
  static constexpr std::size_t sums = 4;
  explicit ByShear(CompressibleLayer const& layer) : layer_(layer), T_(std::tan(layer.slope)) {}

  [[nodiscard]] double pressure(double s) const { return G_ * s * (1 / (T_ * std::cosh(s)) - std::tanh(s)); }
  [[nodiscard]] double normal_stress(double s) const {
    return G_ * s / (T_ * std::cosh(s) * layer_.stretch(pressure(s)));
  }
  [[nodiscard]] double coordinate(double Y) const {
    double const N = layer_.normal_stress(Y), near = layer_.pressure(N) * T_ / G_;
    return root([&](double s) { return normal_stress(s) - N; }, 0.5 * near, 1.5 * near);
  }
  [[nodiscard]] CompressibleState state(double s) const {
    return {0, 0, pressure(s), G_ * s, layer_.stretch(pressure(s))};
  }
  /// d/d(-s) of the sums: dy = -J dN/w, du = gamma cosh(s) dy, dY = dy/J.
  [[nodiscard]] std::array<double, sums> rates(double s) const {
    double const cosh = std::cosh(s), tanh = std::tanh(s), p = pressure(s), f = G_ * s / (T_ * cosh);
    double const df = G_ / (T_ * cosh) * (1 - s * tanh);
    double const dp = df - G_ * (tanh + s / (cosh * cosh));
    double const a = 1 / layer_.fluid.hardening.xi, K = layer_.fluid.elastic.K();
    double const dy = (df + f * (a / p + 1 / K) * dp) / layer_.weight(), dY = dy / layer_.stretch(p);
    double const du = layer_.fluid.rate(G_ * s, p) * cosh * dy;
    return {dy, du, normal_stress(s) / layer_.weight() * du, G_ * s / p * dY};
  }

 private:
  CompressibleLayer const& layer_;
  double T_, G_ = layer_.fluid.elastic.G();
};

void finish(CompressibleProfile& profile, CompressibleLayer const& layer, std::array<double, 4> const& sums) {
  profile.h = sums[0], profile.surface_speed = sums[1];
  profile.mean_speed = sums[2] / layer.h_0, profile.mean_ratio = sums[3] / layer.h_0;
  profile.solid_fraction = layer.fluid.solid_fraction() * layer.h_0 / profile.h;
}

/// By a function that sums up from the base to a height Y, h_0 for the whole.
template <class Sums>
CompressibleProfile summed(CompressibleLayer const& layer, std::vector<double> const& Y, Sums const& sums) {
  ByShear const column(layer);
  CompressibleProfile profile{};
  for (double const height : Y) {
    auto state = column.state(column.coordinate(height));
    auto const sum = sums(height);
    state.y = sum[0], state.u = sum[1];
    profile.at.push_back(state);
  }
  finish(profile, layer, sums(layer.h_0));
  return profile;
}

}  // namespace

double CompressibleLayer::pressure(double N) const {
  if (N <= 0) return 0;
  double const a = 1 / fluid.hardening.xi, K = fluid.elastic.K();
  double const c = std::pow(fluid.hardening.p_c0 * (1 - fluid.beta) / 2, a);
  return (1 + a) * K * gsl_sf_lambert_W0(std::pow(c * N, 1 / (1 + a)) / ((1 + a) * K));
}

double CompressibleLayer::stretch(double p) const {
  return std::pow(fluid.hardening.p_c0 * (1 - fluid.beta) / (2 * p), 1 / fluid.hardening.xi) *
         std::exp(-p / fluid.elastic.K());
}

CompressibleProfile small_shear_profile(CompressibleLayer const& layer, std::vector<double> const& Y) {
  double const a = 1 / layer.fluid.hardening.xi, K = layer.fluid.elastic.K(), w = layer.weight();
  double const T = std::tan(layer.slope), A = layer.fluid.rate(T, 1.0);
  auto const depth = [&](double p) { return ((1 + a) * p + p * p / (2 * K)) / w; };
  auto const lag = [&](double p) { return A * std::pow(p, 1.5) * (2.0 / 3 * (1 + a) + 0.4 * p / K) / w; };
  double const p_b = layer.pressure(layer.normal_stress(0));
  CompressibleProfile profile{};
  for (double const height : Y) {
    double const p = layer.pressure(layer.normal_stress(height));
    profile.at.push_back({depth(p_b) - depth(p), lag(p_b) - lag(p), p, T * p, layer.stretch(p)});
  }
  auto const momentum = [&](double p) {  // N gamma dy/dp over w
    return p / layer.stretch(p) / w * A * std::sqrt(p) * (1 + a + p / K) / w;
  };
  finish(profile, layer, {depth(p_b), lag(p_b), integral(momentum, 0, p_b), T * layer.h_0});
  return profile;
}

CompressibleProfile profile_by_quadrature(CompressibleLayer const& layer, std::vector<double> const& Y) {
  ByShear const column(layer);
  double const base = column.coordinate(0);
  return summed(layer, Y, [&](double height) {
    double const s = height < layer.h_0 ? column.coordinate(height) : 0;
    std::array<double, ByShear::sums> sums{};
    for (std::size_t k = 0; k < sums.size(); ++k)
      sums[k] = integral([&](double x) { return column.rates(x)[k]; }, s, base);
    return sums;
  });
}

CompressibleProfile profile_by_cvode(CompressibleLayer const& layer, std::vector<double> const& Y) {
  ByShear const column(layer);
  double const base = column.coordinate(0);
  auto const middle = column.rates(0.5 * base);
  return summed(layer, Y, [&](double height) {
    double const way = base - (height < layer.h_0 ? column.coordinate(height) : 0);
    std::array<double, ByShear::sums> sums{};
    if (way <= 0) return sums;
    auto const rates = [&](double const* y, double* f) {
      auto const d = column.rates(std::max(base - y[0] * way, 1e-16 * base));
      f[0] = 1;
      for (std::size_t k = 0; k < sums.size(); ++k) f[k + 1] = d[k] / middle[k];
      return true;
    };
    Start const start{std::vector<double>(5, 0.0), std::vector<double>(5, 1.0), 1e-13};
    auto const y = cvode_banded({5, 4, 0}, rates, start, {1.0}).back();
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] = way * middle[k] * y[k + 1];
    return sums;
  });
}

namespace {

/// Unknown p, q and gamma of one place in units of N, N and sqrt(N) Q; what (6) and the law lack, over N.
void imbalance(CompressibleLayer const& layer, double N, double const* y, double* out) {
  Fluid const& f = layer.fluid;
  double const p = y[0] * N, q = y[1] * N, gamma = y[2] * f.friction.Q() * std::sqrt(N), s = q / f.elastic.G();
  double const J = layer.stretch(p);
  out[0] = (p + q * std::tanh(s)) / N - J;
  out[1] = q / std::cosh(s) / N - J * std::tan(layer.slope);
  out[2] = (q - f.stress(gamma, p, f.critical_strength(p))) / N;
}

/// From the base up to Y. The depth is graded to the surface, h_0 - Y = h_0 (m + (1 - m) t^4), where J -> infinity.
std::array<double, ByShear::sums> kinsol_sums(CompressibleLayer const& layer, double Y) {
  constexpr int n = 64;
  auto const rule = gauss_rule(n);
  double const m = 1 - Y / layer.h_0, T = std::tan(layer.slope);
  auto const depth = [&](std::size_t k) { return m + (1 - m) * std::pow(rule.x[k], 4); };
  double const whole = layer.normal_stress(0);
  auto const equations = [&](double const* y, double* out) {
    for (std::size_t k = 0; k < n; ++k) {
      if (!(y[3 * k] > 0 && y[3 * k + 2] >= 0)) return false;
      imbalance(layer, depth(k) * whole, y + 3 * k, out + 3 * k);
    }
    return true;
  };
  Start start{{}, std::vector<double>(3 * n, 1.0), 1e-14};
  for (int k = 0; k < n; ++k) start.y.insert(start.y.end(), {1, T, 0});
  auto const y = kinsol_banded({3 * n, 2, 2}, equations, start, NewtonSteps::searched);
  std::array<double, ByShear::sums> sums{};
  for (std::size_t k = 0; k < n; ++k) {
    double const N = depth(k) * whole, p = y[3 * k] * N, q = y[3 * k + 1] * N;
    double const dY = rule.w[k] * layer.h_0 * (1 - m) * 4 * std::pow(rule.x[k], 3), dy = layer.stretch(p) * dY;
    double const gamma = y[3 * k + 2] * layer.fluid.friction.Q() * std::sqrt(N);
    double const du = gamma * std::cosh(q / layer.fluid.elastic.G()) * dy;
    sums[0] += dy, sums[1] += du, sums[2] += depth(k) * layer.h_0 * du, sums[3] += q / p * dY;
  }
  return sums;
}

}  // namespace

CompressibleProfile profile_by_kinsol(CompressibleLayer const& layer, std::vector<double> const& Y) {
  return summed(layer, Y, [&](double height) { return kinsol_sums(layer, height); });
}

}  // namespace talus::reference::flow
