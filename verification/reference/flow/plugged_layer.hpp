#pragma once
/// The steady layer down a slope with its change of volume, whose surface keeps a strength of its own.

#include "verification/reference/flow/compressible_layer.hpp"
#include "verification/reference/flow/shear_flow.hpp"

namespace talus::reference::flow {

/// A compressible layer (compressible_layer.hpp) with a plug at its surface, which keeps a strength `kept` [Pa]:
///
///   p_c = kept  in the plug,  2 p/(1 - beta) below,   J = (p_c0/p_c)^(1/xi) exp(-p/K),   p = J N,   q = p tan(slope)  (1)
///
/// The plug reaches down to p = kept/r, r from (5) of layer.hpp: there q is what it bears, mu_1 S. What shears comes to
/// critical state whatever its strength was; where that was `kept`, it dilates and loses it. In the height Y of the
/// unstrained layer:
///
///   dy/dY = J,   du/dY = gamma(q, p, p_c) J                                                                        (2)
///
/// With a = 1/xi and N = w (h_0 - Y), p in closed form:
///
///   p = K W0(N (p_c0/kept)^a/K)   in the plug; below as in compressible_layer.hpp, (3)                             (3)
///
/// kept = 0: no plug. Small elastic shear, q << G. Pre: the layer flows at critical state, tan(slope) > omega mu_1.
/// Derived.
struct CompressiblePluggedLayer {
  CompressibleLayer layer;
  double kept = 0;

  [[nodiscard]] double pressure(double Y) const;  ///< p [Pa]
  [[nodiscard]] double strength(double Y) const;  ///< p_c [Pa]
  [[nodiscard]] double stretch(double Y) const;   ///< J [1]

  [[nodiscard]] double plug_begin() const;  ///< Y [m] from which on nothing shears
  [[nodiscard]] ShearFlow below() const;    ///< du/dY from the base to the plug

  /// y [m] of Y, by quadrature.
  [[nodiscard]] double height(double Y) const;
  /// u [m/s] of Y, in one of the ways of shear_flow.hpp.
  template <class Way>
  [[nodiscard]] double speed(Way const& way, double Y) const {
    auto const flow = below();
    return way(flow, std::min(Y, flow.to));
  }
};

}  // namespace talus::reference::flow
