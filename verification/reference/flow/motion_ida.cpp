#include <stdexcept>

#include "verification/reference/flow/motion_cells.hpp"

namespace talus::reference::flow {

std::vector<Snapshot> motion_by_ida(Motion const& motion, int n, std::vector<double> const& times, double tolerance) {
  MotionCells const cells(motion, n);
  constexpr std::size_t width = 4;  // tau, eps, g_p in the middle of a cell, u at its upper node
  double const rate_size = cells.speed_size() / motion.h_0;
  Start first{{}, {}, tolerance};
  std::vector<bool> differential;
  auto const start = cells.start();
  for (std::size_t k = 0; k < cells.count(); ++k) {
    auto const& cell = start[k];
    double const flow = cells.plastic_rate(cells.local(k, cell.eps), cell.tau);
    first.y.insert(first.y.end(), {cell.tau, cell.eps, flow, cell.u});
    first.sizes.insert(first.sizes.end(), {cells.stress_size(k), 1e-2, rate_size, cells.speed_size()});
    differential.insert(differential.end(), {true, true, false, true});
  }
  auto const residual = [&](double const* y, double const* dy, double* out) {
    for (std::size_t k = 0; k < cells.count(); ++k) {
      double const *const here = y + width * k, *const slope = dy + width * k;
      double* const lack = out + width * k;
      bool const last = k + 1 == cells.count();
      auto const local = cells.local(k, here[1]);
      double const below = k == 0 ? 0 : *(here - 1);
      double const push = last ? 0 : here[width] / cells.local(k + 1, here[width + 1]).stretch;
      lack[0] = slope[0] - cells.stress_rate(k, local, below, here[3], here[2]);
      lack[1] = slope[1] - cells.volume_rate(local, here[0], here[2]);
      lack[2] = cells.flow_imbalance(local, here[0], here[2]);
      lack[3] = slope[3] - cells.acceleration(k, here[0] / local.stretch, push);
      if (!std::isfinite(lack[2])) return false;
    }
    return true;
  };
  std::vector<double> slopes(first.y.size(), 0.0), lack(first.y.size());
  if (!residual(first.y.data(), slopes.data(), lack.data()))
    throw std::domain_error("the motion starts where no flow is");
  for (std::size_t i = 0; i < lack.size(); ++i)
    if (differential[i]) slopes[i] = -lack[i];
  Band const band{static_cast<int>(width * cells.count()), 3, 3};
  return cells.snapshots(ida_banded(band, residual, first, slopes, differential, times), times, width, 3);
}

}  // namespace talus::reference::flow
