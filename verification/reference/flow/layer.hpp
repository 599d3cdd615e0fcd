#pragma once
/// Steady layers down a slope, incompressible: at critical state, and below a plug that keeps its strength.

#include "verification/reference/flow/fluid.hpp"
#include "verification/reference/flow/shear_flow.hpp"

namespace talus::reference::flow {

/// A layer of thickness h [m] on a slope [rad], y [m] up from its base, with rho the density of the fluid:
///
///   p = rho g cos(slope) (h - y),   q = rho g sin(slope) (h - y)                                                   (1)
struct Layer {
  Fluid fluid;
  double slope, h;

  [[nodiscard]] double pressure(double y) const { return fluid.density * gravity * std::cos(slope) * (h - y); }
  [[nodiscard]] double shear(double y) const { return fluid.density * gravity * std::sin(slope) * (h - y); }
};

/// All of it at critical state: flows where  omega mu_1 < tan(slope) < omega mu_2,  with u [m/s]
///
///   u = v (1 - (1 - y/h)^(3/2)),   v = (2/3) (I/d) sqrt(rho g cos(slope)/rho_s) h^(3/2),   mean u = (3/5) v        (2)
///
/// I from tan(slope) = q/p. Source: Bagnold (1954), doi:10.1098/rspa.1954.0186, and GDR MiDi (2004) without cohesion;
/// else derived.
[[nodiscard]] double bagnold_surface_speed(Layer const&);
[[nodiscard]] double bagnold_speed(Layer const&, double y);
[[nodiscard]] ShearFlow bagnold_flow(Layer const&);

/// The largest cohesion with which such a layer flows on a slope [rad],  omega mu_1 = tan(slope):
///
///   beta* = (tan(slope) - mu_1)/(tan(slope) + mu_1)                                                                (3)
[[nodiscard]] double largest_cohesion(double slope, double mu_1);
/// The same as a root in beta of the speed's sign.
[[nodiscard]] double largest_cohesion_by_root(Fluid, double slope);

/// Surface material that keeps a strength `kept` [Pa] beyond that of the critical state,
///
///   p_c = max(2 p/(1 - beta), kept)                                                                                (4)
///
/// does not shear where q <= mu_1 S. With p_c = kept and r = kept/p that is (r - 1)(1 + beta r) >= (tan(slope)/mu_1)^2:
///
///   beta r^2 + (1 - beta) r - 1 - (tan(slope)/mu_1)^2 = 0,   p < kept/r  in the plug.                              (5)
///
/// Pre: the layer flows at critical state, and tan(slope)/mu_1 > omega, by which r > 2/(1 - beta): the plug ends where
/// p_c is still `kept`. Derived.
[[nodiscard]] double plug_ratio(Fluid const&, double slope);  ///< r of (5), slope in rad
struct PluggedLayer {
  Layer layer;
  double kept;

  [[nodiscard]] double strength(double y) const;    ///< (4)
  [[nodiscard]] double plug_depth() const;          ///< (5) in closed form [m], at most h
  [[nodiscard]] double plug_depth_by_root() const;  ///< from q = mu_1 S
  [[nodiscard]] double critical_depth() const;      ///< from the surface to where 2 p/(1 - beta) = kept [m]
  [[nodiscard]] ShearFlow below_kept() const;       ///< from the base to the critical depth
  [[nodiscard]] ShearFlow between() const;          ///< from the critical depth to the plug
  /// [m/s] of the plug, in one of the three ways. Below the critical depth the speed is that of (2).
  template <class Way>
  [[nodiscard]] double plug_speed(Way const& way) const {
    auto const low = below_kept(), high = between();
    return way(low, low.to) + way(high, high.to);
  }
};

}  // namespace talus::reference::flow
