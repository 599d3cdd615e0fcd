#include "verification/reference/flow/rate_independent.hpp"

#include "verification/reference/flow/banded.hpp"

namespace talus::reference::flow {

namespace {

/// The layer between two steps: u of nodes 1 ... n, tau of the cells below them.
struct Steps {
  RateIndependentLayer const& layer;
  double density, G, dt, width;
  std::vector<double> u, tau, limit;

  /// (3), of the cell below node k + 1, with those speeds of its ends.
  [[nodiscard]] double stress(std::size_t k, double const* v) const {
    double const strain = dt * (v[k] - (k == 0 ? 0 : v[k - 1])) / width;
    return std::clamp(tau[k] + G * strain, -limit[k], limit[k]);
  }

  void step() {
    std::size_t const n = u.size();
    double const drive = gravity * std::sin(layer.slope);
    auto const equations = [&](double const* v, double* out) {
      for (std::size_t k = 0; k < n; ++k) {
        double const mass = density * width * (k + 1 < n ? 1 : 0.5);
        double const pull = (k + 1 < n ? stress(k + 1, v) : 0) - stress(k, v);
        out[k] = (v[k] - u[k] - dt * (drive + pull / mass)) / layer.U;
      }
      return true;
    };
    std::vector<double> const sizes(n, layer.U);
    auto const v = kinsol_banded({static_cast<int>(n), 1, 1}, equations, {u, sizes, 1e-10});
    std::vector<double> next(n);
    for (std::size_t k = 0; k < n; ++k) next[k] = stress(k, v.data());
    u = v, tau = next;
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
  column.tau = column.limit;
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
