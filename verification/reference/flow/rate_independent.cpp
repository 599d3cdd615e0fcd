#include "verification/reference/flow/rate_independent.hpp"

#include "verification/reference/flow/banded.hpp"

namespace talus::reference::flow {

namespace {

/// The layer between two steps: u of nodes 1 ... n, tau of the cells below them, in units of its limit.
struct Steps {
  RateIndependentLayer const& layer;
  double density, G, dt, width;
  std::vector<double> u, tau, limit;

  /// u of node k + 1 after a step with those stresses.
  [[nodiscard]] double speed(std::size_t k, double const* s) const {
    bool const last = k + 1 == u.size();
    double const above = last ? 0 : s[k + 1] * limit[k + 1], mass = density * width * (last ? 0.5 : 1);
    return u[k] + dt * (gravity * std::sin(layer.slope) + (above - s[k] * limit[k]) / mass);
  }

  void step() {
    std::size_t const n = u.size();
    double const c = 1 / (1 + 3 * G * dt * dt / (density * width * width));
    auto const equations = [&](double const* s, double* out) {
      for (std::size_t k = 0; k < n; ++k) {
        double const strain = dt * (speed(k, s) - (k == 0 ? 0 : speed(k - 1, s))) / width;
        double const lack = s[k] - tau[k] - G * strain / limit[k];
        out[k] = s[k] - std::clamp(s[k] - c * lack, -1.0, 1.0);
      }
      return true;
    };
    Start const start{tau, std::vector<double>(n, 1.0), 1e-11};
    auto const s = kinsol_banded({static_cast<int>(n), 1, 1}, equations, start, NewtonSteps::full);
    std::vector<double> next(n);
    for (std::size_t k = 0; k < n; ++k) next[k] = speed(k, s.data());
    u = next, tau = s;
  }
};

}  // namespace

std::vector<std::vector<double>> rate_independent_steps(RateIndependentLayer const& layer, double density, double G,
                                                        int n, double dt, std::vector<double> const& times) {
  Steps column{layer, density, G, dt, layer.h / n, {}, {}, {}};
  double const w = density * gravity * std::cos(layer.slope);
  for (int k = 0; k < n; ++k) {
    column.u.push_back(layer.U * (k + 1) / n);
    column.limit.push_back(layer.mu * w * (layer.h - (k + 0.5) * column.width));
  }
  column.tau.assign(column.limit.size(), 1.0);
  std::vector<std::vector<double>> states;
  long done = 0;
  for (double const t : times) {
    for (; done < std::lround(t / dt); ++done) column.step();
    states.push_back(column.u);
    states.back().insert(states.back().begin(), 0.0);
  }
  return states;
}

}  // namespace talus::reference::flow
