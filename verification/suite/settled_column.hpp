#pragma once
/// A periodic column on a slope, begun at rest across the slope; and the steady layer that it is to become.

#include <functional>
#include <vector>

#include "verification/reference/flow/plugged_layer.hpp"
#include "verification/suite/findings.hpp"
#include "verification/suite/flow_profile.hpp"
#include "verification/suite/scheme.hpp"

namespace talus::verification {

/// The layer of glass beads to 40 degrees, 0.05 m thick where unstrained, on a slope [deg].
[[nodiscard]] reference::flow::CompressiblePluggedLayer bead_layer(double slope_deg, double beta = 0, double kept = 0);

/// The exact steady flow of a layer: heights [m] and speeds [m/s], the surface last.
struct SteadyLayer {
  std::vector<double> y, u;
  double surface = 0;         ///< mean speed of the uppermost 5 % of the mass [m/s]
  double thickness = 0;       ///< twice the mean height by mass [m]
  double solid_fraction = 0;  ///< phi_0 over the mean of J by mass [1]

  /// Finite elastic shear where all is at critical state, else small.
  explicit SteadyLayer(reference::flow::CompressiblePluggedLayer const& layer);
  /// At a share of the mass below [m/s].
  [[nodiscard]] double speed(double below) const;
};

/// Begun with each particle where the layer has it, with the elastic strain and the strength of its pressure, without
/// shear stress; the associated law on a wall that mirrors. (Documents begin without stress: the layer then falls by 3 %
/// of its height and bounces for a second.)
struct SettledColumn {
  reference::flow::CompressiblePluggedLayer layer;
  std::function<double(double)> speed;  ///< the initial one, of the unstrained height [m/s]
  int cells = 20;                       ///< in the height
  int per_axis = 3;                     ///< particles in a cell along an axis
  int width = 12;                       ///< in cells
  Scheme scheme = {"quadratic", "aflip", "usl", 0.95};
};
[[nodiscard]] std::vector<FlowProfile> profiles_of(SettledColumn const& column, std::vector<double> const& times,
                                                   Cost& cost);

/// The same begun in its exact steady flow.
[[nodiscard]] SettledColumn steady_column(reference::flow::CompressiblePluggedLayer const& layer,
                                          SteadyLayer const& exact, int cells = 20);

}  // namespace talus::verification
