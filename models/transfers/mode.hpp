#pragma once
/// Which velocity a particle shows the nodes around it: the same for all, or one with a gradient.

#include <string_view>

#include "core/fields.hpp"

namespace talus::field {

/// The velocity gradient that an affine transfer keeps of a particle:
///
///   C_p = B_p D_p^-1,  B_p = sum_i w_ip v_i (x_i - x_p)^T,  D_p = sum_i w_ip (x_i - x_p) (x_i - x_p)^T
///
/// Row i, column j: dv_i/dx_j.
///
/// Source: Jiang et al. (2015), doi:10.1145/2766996 (abstract read; the affine momentum as in Jiang, Schroeder & Teran
/// (2017), doi:10.1016/j.jcp.2017.02.050, abstract read).
inline constexpr struct AffineVelocity : MatrixField {
  static constexpr std::string_view name = "affine_velocity", symbol = "C_p", unit = "1/s",
                                    meaning = "velocity gradient that the particle shows the nodes, row by row";
} affine_velocity;

}  // namespace talus::field

namespace talus::transfer {

/// Every node sees v_p.
struct Constant {
  static constexpr bool affine = false;
  using State = Fields<>;
};

/// Node i sees v_p + C_p (x_i - x_p): angular momentum passes, and with it what PIC smears out.
struct Affine {
  static constexpr bool affine = true;
  using State = Fields<field::AffineVelocity>;
};

}  // namespace talus::transfer
