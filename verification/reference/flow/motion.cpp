#include "verification/reference/flow/motion.hpp"

#include "verification/reference/flow/motion_cells.hpp"

namespace talus::reference::flow {

double Snapshot::mean_speed() const {
  std::size_t const n = u.size() - 1;
  double sum = 0;  // of 2 s u over s = 1 - k/n
  for (std::size_t k = 0; k < n; ++k) {
    double const weight = k == 0 ? 1 : (k % 2 == 1 ? 4 : 2);
    sum += weight * 2 * (1 - static_cast<double>(k) / static_cast<double>(n)) * u[k];
  }
  return sum / (3 * static_cast<double>(n));
}

std::vector<Snapshot> motion_by_cvode(Motion const& motion, int n, std::vector<double> const& times, double tolerance) {
  MotionCells const cells(motion, n);
  constexpr std::size_t width = 3;  // tau, eps, u: of half a node below, and of the node
  auto const start = cells.start();
  Start first{{}, {}, tolerance};
  for (std::size_t k = 0; k < cells.count(); ++k) {
    auto const& cell = start[k];
    first.y.insert(first.y.end(), {cell.tau, cell.eps, cell.u});
    first.sizes.insert(first.sizes.end(), {cells.stress_size(k), 1e-2, cells.speed_size()});
  }
  auto const rates = [&](double const* y, double* f) {
    for (std::size_t k = 0; k < cells.count(); ++k) {
      double const *const here = y + width * k, *const above = k + 1 < cells.count() ? here + width : nullptr;
      auto const local = cells.local(k, here[1]);
      double const flow = cells.plastic_rate(local, here[0]);
      if (!std::isfinite(flow)) return false;
      double const below = k == 0 ? 0 : here[2 - static_cast<std::ptrdiff_t>(width)];
      f[width * k] = cells.stress_rate(k, local, below, here[2], flow);
      f[width * k + 1] = cells.volume_rate(local, here[0], flow);
      double const push = above == nullptr ? 0 : above[0] / cells.local(k + 1, above[1]).stretch;
      f[width * k + 2] = cells.acceleration(k, here[0] / local.stretch, push);
    }
    return true;
  };
  auto const states = cvode_banded({static_cast<int>(width * cells.count()), 2, 2}, rates, first, times);
  return cells.snapshots(states, times, width, 2);
}

ExtrapolatedMotion extrapolated_motion(Motion const& motion, int n, std::vector<double> const& times,
                                       double tolerance) {
  auto const coarse = motion_by_cvode(motion, n, times, tolerance),
             middle = motion_by_cvode(motion, 2 * n, times, tolerance),
             fine = motion_by_cvode(motion, 4 * n, times, tolerance);
  ExtrapolatedMotion result{coarse, 0, 0};
  for (std::size_t t = 0; t < times.size(); ++t)
    for (std::size_t k = 0; k < coarse[t].u.size(); ++k) {
      double const a = coarse[t].u[k], b = middle[t].u[2 * k], c = fine[t].u[4 * k];
      double const best = c + (c - b) / 3, before = b + (b - a) / 3;
      Snapshot& at = result.at[t];
      at.u[k] = best;
      at.y[k] = fine[t].y[4 * k] + (fine[t].y[4 * k] - middle[t].y[2 * k]) / 3;
      for (auto* list : {&at.tau, &at.p, &at.p_c, &at.stretch}) list->clear();
      result.correction = std::max(result.correction, std::abs(best - c));
      result.error = std::max(result.error, std::abs(best - before));
    }
  return result;
}

}  // namespace talus::reference::flow
