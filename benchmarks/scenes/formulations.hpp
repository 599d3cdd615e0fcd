#pragma once
/// The solvers that are measured, and their numbers: glass beads.

#include <type_traits>

#include "benchmarks/scenes/cloud.hpp"
#include "core/formulation.hpp"
#include "models/integrators/musl.hpp"
#include "models/integrators/usl.hpp"
#include "models/kernels/cubic.hpp"
#include "models/kernels/quadratic.hpp"
#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/cam_clay_mu_i.hpp"
#include "models/laws/drucker_prager.hpp"
#include "models/laws/hencky.hpp"
#include "models/laws/modified_cam_clay.hpp"
#include "models/transfers/aflip.hpp"
#include "models/transfers/apic.hpp"
#include "models/transfers/flip.hpp"
#include "models/transfers/pic.hpp"

namespace talus::bench {

/// In two dimensions the reduced plane strain, as in the source paper and in the baseline.
template <int D, class K, class T = transfer::Apic, class L = law::Hencky, class I = integrator::Usl>
struct Of {
  using Kinematics = std::conditional_t<D == 2, kinematics::PlaneStrainReduced, kinematics::Solid>;
  using Kernel = K;
  using Transfer = T;
  using Integrator = I;
  using Law = L;
};

/// Gravity along the second axis, downwards [m/s^2].
template <int D>
[[nodiscard]] Point<D> down() {
  Point<D> g = Point<D>::Zero();
  g[1] = -9.81;
  return g;
}

inline constexpr double density = 1550;  ///< of the packing [kg/m^3]

/// Young's modulus 1 MPa, Poisson's ratio 0.3, and the defaults of each law.
template <Formulation F>
[[nodiscard]] Setup<F> setup(double spacing) {
  Setup<F> s;
  s.spacing = spacing;
  s.density = density;
  s.gravity = down<F::Kinematics::dimension>();
  return s;
}

}  // namespace talus::bench
