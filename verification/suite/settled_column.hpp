#pragma once
/// A periodic column on a slope, begun at rest across the slope; and the steady layer that it is to become.

#include <functional>
#include <string>
#include <vector>

#include "verification/reference/flow/plugged_layer.hpp"
#include "verification/suite/findings.hpp"
#include "verification/suite/flow_profile.hpp"
#include "verification/suite/scheme.hpp"

namespace talus::verification {

/// The layer of glass beads with that limiting angle, 0.05 m thick where unstrained, on a slope; angles in degrees.
[[nodiscard]] reference::flow::CompressiblePluggedLayer bead_layer(double slope, double beta = 0, double kept = 0,
                                                                   double limiting_angle = 40);

/// The exact steady flow of a layer, at the middles of parts of equal mass.
struct SteadyLayer {
  std::vector<double> y, u;   ///< heights [m], speeds [m/s]
  ExactProfile profile;       ///< of the same
  double top_speed = 0;       ///< at the surface itself [m/s]
  double thickness = 0;       ///< twice the mean height by mass [m]
  double solid_fraction = 0;  ///< phi_0 over the mean of J by mass [1]

  /// Mean speed of the uppermost 5 % of the mass [m/s].
  [[nodiscard]] double surface() const { return profile.u.back(); }

  /// Finite elastic shear where all is at critical state, else small.
  explicit SteadyLayer(reference::flow::CompressiblePluggedLayer const& layer);
  /// At a share of the mass below [m/s]; odd about the base.
  [[nodiscard]] double speed(double below) const;
};

/// Begun with each particle where the layer has it, with the elastic strain and the strength of its pressure, with or
/// without the shear stress of steady flow; the associated law on a wall that mirrors. (Documents begin without stress: the layer then falls by 3 %
/// of its height and bounces for a second.)
struct SettledColumn {
  reference::flow::CompressiblePluggedLayer layer;
  std::function<double(double)> speed;  ///< the initial one, of the unstrained height [m/s]
  bool sheared = false;                 ///< whether it begins with shear stress
  int cells = 20;                       ///< in the height
  int per_axis = 3;                     ///< particles in a cell along an axis
  int width = 12;                       ///< in cells
  Scheme scheme = {"quadratic", "aflip", "usl", 0.95};
};
[[nodiscard]] std::vector<FlowProfile> profiles_of(SettledColumn const& column, std::vector<double> const& times,
                                                   Cost& cost);

/// The same begun in its exact steady flow, with its shear stress.
[[nodiscard]] SettledColumn steady_column(reference::flow::CompressiblePluggedLayer const& layer,
                                          SteadyLayer const& exact, int cells = 20);

/// Rows of surface speed and profile against the exact layer. asked: the bar of both, or 0 where they are noted only.
void compare_with_layer(Findings& findings, std::string const& name, FlowProfile const& flow, SteadyLayer const& exact,
                        double asked, std::string const& because, Cost const& cost);

/// What becomes of a layer without a plug that begins with such speeds and no shear stress, by the method of lines.
[[nodiscard]] std::vector<ExactProfile> exact_motion(reference::flow::CompressibleLayer const& layer,
                                                     std::function<double(double)> const& speed,
                                                     std::vector<double> const& times);
/// Runs it, begun without shear stress, and checks the profiles at these times against `exact_motion`; draws them.
/// Returns the solver's and the exact ones.
struct Moved {
  std::vector<FlowProfile> found;
  std::vector<ExactProfile> exact;
};
Moved check_motion(Findings& findings, std::string const& name, SettledColumn const& column,
                   std::vector<double> const& times, double bar);

}  // namespace talus::verification
