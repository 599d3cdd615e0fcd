#pragma once
/// Stations: boxes in which a flow is measured at output times, as a whole and in bins over its depth.
///
/// A station sees the particles whose centre lies in it. Heights are measured from its lower face along its axis of
/// depth. Means are by mass; the stress is Kirchhoff's, as everywhere. Where there is no particle, mass and flux are 0
/// and all means are nan.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/snapshot.hpp"

namespace talus {

/// Names of the axes of space.
inline constexpr std::string_view axis_names[] = {"x", "y", "z"};

/// A quantity of the time series.
struct Quantity {
  std::string name, symbol, unit, meaning;
};

struct Station {
  std::string name;
  std::vector<double> low, high;         ///< corners of the box [m]
  std::size_t flow = 0, depth = 1;       ///< axes: along the flow, and away from the base
  int bins = 1;                          ///< equal parts of the depth
  std::vector<double> initial_fraction;  ///< phi_0 of each material [1]; empty where not every law tells of grains

  [[nodiscard]] double extent(std::size_t axis) const { return high[axis] - low[axis]; }
};

/// What a station takes of each particle, besides fields of its own choice; the names of the columns of its samples.
namespace sample {
inline constexpr std::string_view mass = "mass", height = "height", flow_velocity = "flow_velocity",
                                  initial_volume = "initial_volume", solid_volume = "solid_volume",
                                  pressure = "pressure", shear_stress = "shear_stress", volume_ratio = "volume_ratio";
}  // namespace sample

/// The columns that a station adds to the series: `<station>_depth`, ... .
[[nodiscard]] std::vector<Quantity> station_quantities(Station const& station);

/// Their values. samples: of the particles in the station, scalars alone; a value that a particle has not is nan.
[[nodiscard]] std::vector<double> measure(Station const& station, Snapshot const& samples);

/// A station's bins at one time: a row each, from the base upwards.
struct Profile {
  std::string station;
  std::vector<Quantity> quantities;
  std::vector<std::vector<double>> rows;
};

/// Time, middle of the bin, then mass and means over its particles, of every column of the samples.
[[nodiscard]] Profile profile(Station const& station, Snapshot const& samples);

}  // namespace talus
