#pragma once
/// Where incompressible flow by mu(I) is well posed.

#include <utility>

#include "verification/reference/flow/fluid.hpp"

namespace talus::reference::flow {

/// Short waves grow without bound, whatever their direction, where C > 0:
///
///   C = 4 X^2 - 4 X + mu^2 (1 - X/2)^2,   X = I mu'(I)/mu(I)                                                       (1)
///
/// mu(I): fluid.hpp, (3), with cohesion as well. Source: Barker, Schaeffer, Bohorquez & Gray (2015),
/// doi:10.1017/jfm.2015.412.
[[nodiscard]] double ill_posedness(Fluid const&, double I);

/// I between which C <= 0; both are 0 where there is none. By bisection between changes of sign on a fine grid, and as
/// roots of a polynomial: with b = sqrt(omega) I_0, m_k = omega mu_k, B = b + I, N = m_1 b + m_2 I, Z = I (m_2 - m_1) b
///
///   C B^4 N^2 = 4 Z^2 B^2 - 4 Z B^3 N + N^2 (B N - Z/2)^2                                                          (2)
[[nodiscard]] std::pair<double, double> well_posed_window(Fluid const&);
[[nodiscard]] std::pair<double, double> well_posed_window_by_polynomial(Fluid const&);

}  // namespace talus::reference::flow
