#pragma once
/// Shipped documents of shear flow along x, with some things changed, and their profiles.

#include <string>
#include <vector>

#include "verification/reference/materials.hpp"
#include "verification/suite/findings.hpp"

namespace talus::verification {

inline constexpr int slices = 20;  ///< of a profile, of equal mass

/// The periodic column of bagnold_column.json: h = 0.05 m, mu_2 = tan 40 deg, E = 1 MPa; here with the associated flow rule
/// on a wall that mirrors, particles on a lattice, 12 cells wide. `changes`: what else is set, in the words of the document.
struct FlowColumn {
  std::string name;
  int cells = 20;        ///< in the height
  double slope = 28;     ///< [deg]
  double gradient = 20;  ///< of the initial velocity [1/s]
  std::vector<std::string> changes = {};

  static constexpr double height = 0.05;  ///< unstrained [m]
  static constexpr char const* study = "bagnold_column.json";
  [[nodiscard]] std::vector<std::string> all_changes() const;
};

/// Means over slices of equal mass, from the lowest on. Stress is Kirchhoff stress.
struct FlowProfile {
  std::vector<double> y = std::vector<double>(slices), u = y;             ///< [m], [m/s]
  std::vector<double> pressure = y, shear_stress = y, normal_stress = y;  ///< p, tau_xy, -tau_yy [Pa]
  double thickness = 0;                                                   ///< twice the mean height [m]
  double stretch = 0;                                                     ///< volume over unstrained volume, J [1]
  double scatter =
      0;  ///< standard deviation of p about its line over y in a slice, over its mean; of the inner ones [1]

  /// Of the uppermost slice: 5 % of the mass [m/s].
  [[nodiscard]] double surface() const { return u.back(); }
  /// Mobilised by the layer as a whole: shear stress over pressure [1].
  [[nodiscard]] double friction() const;
};

/// A particle as far as a profile needs it: place [m], speed [m/s], elastic strain, plastic volumetric strain.
struct FlowSample {
  double y, u, eps_xx, eps_yy, eps_xy, eps_V;
};
[[nodiscard]] FlowProfile profile_of(std::vector<FlowSample> samples, reference::Elasticity const& elastic);

/// The profiles of a study's document with these changes at some times [s]; E = 1 MPa, nu = 0.3.
[[nodiscard]] std::vector<FlowProfile> profiles_of(std::string const& study, std::vector<std::string> const& changes,
                                                   std::vector<double> const& times, Cost& cost);

[[nodiscard]] FlowProfile mean_of(std::vector<FlowProfile> const& profiles);

/// An exact profile as slices of equal mass see it: means of heights [m] and speeds [m/s] from the lowest on.
struct ExactProfile {
  std::vector<double> y = std::vector<double>(slices), u = y;
};
/// Of heights and speeds at the middles of parts of equal mass, `slices` times as many as a whole number.
[[nodiscard]] ExactProfile sliced(std::vector<double> const& y, std::vector<double> const& u);

/// sqrt(sum (u - u_exact)^2 / sum u_exact^2) over the slices at their heights; the exact one is linear between its own.
[[nodiscard]] double profile_error(FlowProfile const& profile, ExactProfile const& exact);

/// n + 1 times from `from` to `to`.
[[nodiscard]] std::vector<double> evenly(double from, double to, int n);

}  // namespace talus::verification
