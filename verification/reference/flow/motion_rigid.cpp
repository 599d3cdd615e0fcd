#include <stdexcept>

#include "verification/reference/flow/banded.hpp"
#include "verification/reference/flow/motion.hpp"

namespace talus::reference::flow {

std::vector<Snapshot> rigid_motion(Motion const& motion, int n, std::vector<double> const& times, double tolerance) {
  Fluid const& f = motion.fluid;
  auto const size = static_cast<std::size_t>(n);
  double const h = motion.h_0, down = gravity * std::sin(motion.slope), across = gravity * std::cos(motion.slope);
  auto const height = [&](double k) { return h * (1 - std::pow(1 - k / n, 2)); };
  auto const stress_over_density = [&](std::size_t k, double const* u) {  // between nodes k and k + 1; node 0 rests
    double const low = static_cast<double>(k), p = f.density * across * (h - height(low + 0.5));
    double const gamma = (u[k] - (k == 0 ? 0 : u[k - 1])) / (height(low + 1) - height(low));
    return (gamma < 0 ? std::nan("") : f.stress(gamma, p, f.critical_strength(p))) / f.density;
  };
  auto const rates = [&](double const* u, double* out) {
    for (std::size_t k = 0; k < size; ++k) {
      double const node = static_cast<double>(k + 1), bottom = height(node - 0.5);
      bool const last = k + 1 == size;
      double const above = last ? 0 : stress_over_density(k + 1, u), top = last ? h : height(node + 0.5);
      out[k] = down + (above - stress_over_density(k, u)) / (top - bottom);
      if (!std::isfinite(out[k])) return false;
    }
    return true;
  };
  if (motion.volume != Motion::Volume::incompressible) throw std::invalid_argument("a rigid layer keeps its volume");
  Start start{{}, std::vector<double>(size, motion.speed(h)), tolerance};
  for (int k = 1; k <= n; ++k) start.y.push_back(motion.speed(height(k)));
  auto const states = cvode_banded({n, 1, 1}, rates, start, times);
  std::vector<Snapshot> list;
  for (std::size_t t = 0; t < times.size(); ++t) {
    Snapshot s{times[t], {0}, {0}, {0}, {}, {}, {}, {}};
    for (int k = 1; k <= n; ++k) s.Y.push_back(height(k)), s.y.push_back(height(k));
    s.u.insert(s.u.end(), states[t].begin(), states[t].end());
    list.push_back(std::move(s));
  }
  return list;
}

}  // namespace talus::reference::flow
