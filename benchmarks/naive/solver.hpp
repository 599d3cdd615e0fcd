#pragma once
/// The textbook material point method: the baseline that the speed of Talus is a multiple of.
///
/// One thread; particles are an array of structures in the order they were given, the grid is dense, and each particle
/// loops over the nodes it sees. The mathematics is that of Talus with transfer::Apic, integrator::Usl and law::Hencky:
///
///   m_i      = sum_p w_ip m_p                                                             (1)
///   m_i v_i  = sum_p w_ip m_p (v_p + C_p (x_i - x_p)) - dt sum_p V_p^0 tau_p grad w_ip    (2)
///   v_i     <- walls(v_i + dt g)                                                          (3)
///   v_p      = sum_i w_ip v_i,   x_p <- x_p + dt v_p                                      (4)
///   C_p      = D_p^-1 sum_i w_ip v_i (x_i - x_p)^T,   D_p = inertia h^2 I                 (5)
///   F_p     <- (I + dt sum_i v_i grad w_ip^T) F_p                                         (6)
///
/// It is tuned as such codes are (one singular value decomposition a particle and step, weights once an axis, fixed
/// sizes, impulse added to the momentum at once), and no further: no intrinsics, no packing, no sorting, no blocks, no
/// factorised sums.
/// Source: Sulsky, Chen & Schreyer (1994), doi:10.1016/0045-7825(94)90112-0; Jiang et al. (2015),
/// doi:10.1145/2766996; layout and loops as in Jiang et al. (2016), doi:10.1145/2897826.2927348 (none re-read).

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "benchmarks/naive/grid.hpp"
#include "benchmarks/naive/hencky.hpp"
#include "benchmarks/naive/splines.hpp"
#include "benchmarks/scenes/cloud.hpp"

namespace talus::naive {

template <int D>
struct Particle {
  using Tensor = Eigen::Matrix<double, D, D>;
  Point<D> x, v;                  ///< [m], [m/s]
  Tensor C = Tensor::Zero();      ///< affine velocity [1/s]
  Tensor F = Tensor::Identity();  ///< elastic deformation gradient [1]
  double mass = 0, V0 = 0;        ///< [kg], volume at rest [m^D]
};

/// A cloud of one elastic material between the coordinate planes through its corner: it sticks to the floor (axis 1),
/// and the others only push.
template <int D, class Spline>
class Solver {
 public:
  /// gravity [m/s^2]. The grid leaves room for half of the block's size above it.
  Solver(bench::Cloud<D> const& cloud, Material const& material, Point<D> gravity)
      : material_(material),
        gravity_(gravity),
        corner_(cloud.low),
        spacing_(cloud.spacing),
        grid_(spacing_, cloud.low - Point<D>::Constant(3 * spacing_),
              cloud.high + 0.5 * (cloud.high - cloud.low) + Point<D>::Constant(3 * spacing_)) {
    for (std::size_t k = 0; k < cloud.count(); ++k) {
      Particle<D> p{cloud.places[k], cloud.velocities[k]};
      p.mass = material.density * cloud.volume;
      p.V0 = cloud.volume;
      particles_.push_back(p);
      expect_inside(p);
    }
  }

  /// From t to t + dt [s]. Throws std::runtime_error where a particle leaves the grid.
  void step(double dt) {
    grid_.clear();
    particles_to_grid(dt);
    move_grid(dt);
    grid_to_particles(dt);
  }

  /// In the order of the cloud.
  [[nodiscard]] std::vector<Particle<D>> const& particles() const { return particles_; }

 private:
  using Tensor = Eigen::Matrix<double, D, D>;

  void particles_to_grid(double dt) {
    for (Particle<D> const& p : particles_) {
      Point<D> const momentum = p.mass * p.v;
      Tensor const affine = p.mass * p.C, push = -dt * p.V0 * hencky_stress<D>(p.F, material_);
      grid_.for_each(grid_.template about<Spline>(p.x),
                     [&](Node<D>& node, double w, Point<D> const& grad_w, Point<D> const& arm) {
                       node.mass += w * p.mass;                                  // (1)
                       node.v += w * (momentum + affine * arm) + push * grad_w;  // (2)
                     });
    }
  }

  /// A wall acts on a node that would move into it; the floor, which sticks, on one that is in it, too.
  void move_grid(double dt) {
    grid_.for_each_massive([&](Node<D>& node, Point<D> const& x) {
      Point<D> v = node.v / node.mass + dt * gravity_;
      Point<D> const above = x + dt * v - corner_;
      for (int d = 0; d < D; ++d)
        if (above[d] <= 0) v[d] = std::max(v[d], 0.0);
      if (above[1] <= 0 || x[1] <= corner_[1]) v.setZero();
      node.v = v;  // (3)
    });
  }

  void grid_to_particles(double dt) {
    double const inverse_inertia = 1 / (Spline::inertia * spacing_ * spacing_);
    for (Particle<D>& p : particles_) {
      Point<D> v = Point<D>::Zero();
      Tensor B = Tensor::Zero(), L = Tensor::Zero();
      grid_.for_each(grid_.template about<Spline>(p.x),
                     [&](Node<D> const& node, double w, Point<D> const& grad_w, Point<D> const& arm) {
                       v += w * node.v;
                       B.noalias() += (w * node.v) * arm.transpose();
                       L.noalias() += node.v * grad_w.transpose();
                     });
      p.v = v;
      p.x += dt * v;                              // (4)
      p.C = inverse_inertia * B;                  // (5)
      p.F = (Tensor::Identity() + dt * L) * p.F;  // (6)
      expect_inside(p);
    }
  }

  void expect_inside(Particle<D> const& p) const {
    if (!grid_.template holds<Spline>(p.x))
      throw std::runtime_error("particle " + std::to_string(&p - particles_.data()) + " has left the grid");
  }

  Material material_;
  Point<D> gravity_, corner_;
  double spacing_;
  Grid<D> grid_;
  std::vector<Particle<D>> particles_;
};

}  // namespace talus::naive
