#pragma once
/// A column under its own weight that is compressed by much: Hencky's law, uniaxial strain, in closed form.
///
/// X [m]: place in the unloaded column, foot at 0, top at H. F = dx/dX, P = M ln F/F the stress on the unloaded area:
///
///   P = -rho_0 g (H - X)   =>   F = exp(-W(s)),  s = rho_0 g (H - X)/M,  W exp(W) = s                             (1)
///   x(X) = (M/(rho_0 g)) [W + W^2/2] between s(X) and s(0)                                                        (2)
///
/// (2) by dX = -(M/(rho_0 g)) (1 + W) exp(W) dW. W: Lambert's function. Derived.

namespace talus::reference {

struct HenckyColumn {
  double modulus;  ///< M = lambda + 2 G [Pa]
  double density;  ///< rho_0, unloaded [kg/m^3]
  double gravity;  ///< g [m/s^2]
  double height;   ///< H [m]

  [[nodiscard]] double log_stretch(double X) const;  ///< ln F = -W
  [[nodiscard]] double place(double X) const;        ///< (2)
};

}  // namespace talus::reference
