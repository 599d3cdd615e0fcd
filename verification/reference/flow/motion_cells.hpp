#pragma once
/// The cells of a layer in motion: what CVODE's rates and IDA's residual have in common.

#include <vector>

#include "verification/reference/flow/banded.hpp"
#include "verification/reference/flow/motion.hpp"

namespace talus::reference::flow {

/// Cell k, from 0 at the base, has tau and eps in its middle and u at its upper node. Nodes and middles are even in
/// s = (1 - Y/h_0)^(1/2), in which the speed of a steady layer is smooth:  node k at s = 1 - k/n. A node has the mass
/// between the middles next to it, the uppermost one that from the last middle up.
class MotionCells {
 public:
  struct Cell {
    double tau, eps, u;
  };
  /// Kirchhoff pressure, strength, S, P [Pa], J in the middle of a cell.
  struct Local {
    double p, p_c, S, P, stretch;
  };

  MotionCells(Motion const&, int n);

  [[nodiscard]] double node(double k) const;  ///< Y [m]; of k - 1/2: the middle of the cell below node k
  [[nodiscard]] std::size_t count() const { return normal_.size(); }
  [[nodiscard]] double stress_size(std::size_t k) const { return normal_[k]; }
  [[nodiscard]] double speed_size() const { return speed_size_; }
  [[nodiscard]] std::vector<Cell> start() const;

  [[nodiscard]] Local local(std::size_t k, double eps) const;
  [[nodiscard]] double plastic_rate(Local const&, double tau) const;  ///< g_p; not a number where it is not defined
  [[nodiscard]] double stress_rate(std::size_t k, Local const&, double u_below, double u_above,
                                   double plastic_rate) const;
  [[nodiscard]] double volume_rate(Local const&, double tau, double plastic_rate) const;  ///< (3), else 0
  /// Of the upper node of cell k, from Cauchy shear stress on both sides; `above` of the last one is 0.
  [[nodiscard]] double acceleration(std::size_t k, double below, double above) const;
  /// (4) over mu_2 S and a shear rate of the layer.
  [[nodiscard]] double flow_imbalance(Local const&, double tau, double plastic_rate) const;

  /// tau and eps are the first two of `width` unknowns of a cell, u is number `speed`.
  [[nodiscard]] std::vector<Snapshot> snapshots(std::vector<std::vector<double>> const& states,
                                                std::vector<double> const& times, std::size_t width,
                                                std::size_t speed) const;

 private:
  [[nodiscard]] double initial_eps(double N) const;

  Motion const& motion_;
  int n_;
  double speed_size_;
  std::vector<double> normal_;   // w (h_0 - Y) [Pa] in the middles
  std::vector<double> width_;    // of cells [m]
  std::vector<double> mass_;     // of nodes [kg/m^2]
  std::vector<Local> critical_;  // where volume is no unknown
};

}  // namespace talus::reference::flow
