#pragma once

#include <string_view>
#include <tuple>

#include "core/tensor.hpp"

namespace talus::kinematics {

/// Plane strain in full: motion in the plane, F_zz = 1, but strain and stress across it as well; d_s = 3.
///
/// The elastic strain across the plane is minus the plastic one there, eps_zz^E = -eps_zz^P, and is carried as a fourth
/// number; p = -(tau_xx + tau_yy + tau_zz)/3, K = lambda + 2 G/3, q from the full deviator. This is what a
/// three-dimensional slab between frictionless walls does.
///
/// Equal to plane_strain_reduced in the motion of an elastic material (the stress in the plane is the same), and in p
/// and q of steady isochoric shear at the critical state, where tau_zz tends to -p.
///
/// Source: de Souza Neto, Perić & Owen (2008), doi:10.1002/9780470694626 (not re-read).
struct PlaneStrain {
  static constexpr std::string_view name = "plane_strain", title = "Plane strain with stress across the plane",
                                    source = "de Souza Neto, Perić & Owen (2008), doi:10.1002/9780470694626";
  static constexpr int dimension = 2;
  using Shape = shape::PlaneStrain;
  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };
};

}  // namespace talus::kinematics
