#pragma once

#include <string_view>
#include <tuple>

#include "core/tensor.hpp"

namespace talus::kinematics {

/// Plane strain of which only the plane is looked at: d_s = 2, p = -(tau_xx + tau_yy)/2, K = lambda + G.
///
/// The elastic strain across the plane stays zero, the stress there enters neither p nor q nor the flow rule, and
/// plastic dilation is shared by the two directions in the plane. Two-dimensional results of the source were obtained
/// this way.
///
/// Differs from plane_strain where yielding changes volume or is about to start: under uniaxial elastic
/// compression q/p is 1 - 2 nu (0.4 for nu = 0.3), against 0.533 in full. Equal to it in the motion of an elastic
/// material, and in p and q of steady isochoric shear at the critical state (so the steady profiles of flows down a
/// slope agree).
///
/// Source: Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643 (equations not re-read).
struct PlaneStrainReduced {
  static constexpr std::string_view name = "plane_strain_reduced",
                                    title = "Plane strain, invariants of the plane alone",
                                    source = "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643";
  static constexpr int dimension = 2;
  using Shape = shape::Plane;
  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };
};

}  // namespace talus::kinematics
