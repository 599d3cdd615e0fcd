#pragma once

#include <string_view>
#include <tuple>

namespace talus::integrator {

/// Update stress last: the velocity gradient is that of the moved nodes, the stress follows from it.
///
///   particles to nodes; v_i = v_i^old + dt (f_i/m_i + g); walls; nodes to particles: v_p, L_p, x_p; stress
///
/// Source: Sulsky, Chen & Schreyer (1994), doi:10.1016/0045-7825(94)90112-0 (not re-read).
struct Usl {
  static constexpr std::string_view name = "usl", title = "Symplectic Euler, stress updated last (USL)",
                                    source = "Sulsky, Chen & Schreyer (1994), doi:10.1016/0045-7825(94)90112-0";
  static constexpr bool remaps = false;
  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };
};

}  // namespace talus::integrator
