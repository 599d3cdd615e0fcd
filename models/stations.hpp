#pragma once
/// Stations as documents declare them: boxes in which a flow is measured.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>

#include "core/config/choice.hpp"
#include "core/station.hpp"

namespace talus {

/// Axes of space, as documents choose one.
namespace flow_axis {
struct NoParameters {
  static constexpr auto table() { return std::tuple{}; }
};
struct X {
  static constexpr std::string_view name = "x", title = "The first axis, down the slope";
  static constexpr std::size_t number = 0;
  using Parameters = NoParameters;
};
struct Y {
  static constexpr std::string_view name = "y", title = "The second axis, away from the bed";
  static constexpr std::size_t number = 1;
  using Parameters = NoParameters;
};
struct Z {
  static constexpr std::string_view name = "z", title = "The third axis; not in the plane";
  static constexpr std::size_t number = 2;
  using Parameters = NoParameters;
};
}  // namespace flow_axis

using AxisChoice = Choice<TypeList<flow_axis::X, flow_axis::Y, flow_axis::Z>>;

/// A station; what it adds to the series is in core/station.cpp.
struct StationEntry {
  std::string name;
  Coordinates min, max;
  AxisChoice flow = AxisChoice::of<flow_axis::X>(), depth = AxisChoice::of<flow_axis::Y>();
  std::optional<std::int64_t> bins;
  static constexpr auto table() {
    return std::tuple{
        parameter(&StationEntry::name, "name",
                  "what the station is called: letters, digits and _; its columns of the series begin with it")
            .required(),
        parameter(&StationEntry::min, "min", "x_{min}", "m", "corner with the least coordinates").per_axis().required(),
        parameter(&StationEntry::max, "max", "x_{max}", "m",
                  "corner with the greatest coordinates; where an axis repeats, at most one period away")
            .per_axis()
            .required(),
        parameter(&StationEntry::flow, "flow", "axis along the flow"),
        parameter(&StationEntry::depth, "depth", "axis away from the base, which is the box's lower face along it"),
        parameter(&StationEntry::bins, "bins", "n", "1",
                  "equal parts of the depth in profiles; as long as nothing is said, one a cell of the grid",
                  closed(1, 100000))};
  }
};

struct Case;

/// The stations of a consistent case.
[[nodiscard]] std::vector<Station> stations_of(Case const& document);

/// Adds what a table cannot say of stations: each mistake as "pointer: what is wrong; what is allowed".
void check_stations(Case const& document, int D, std::vector<std::string>& wrong);

}  // namespace talus
