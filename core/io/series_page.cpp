#include "core/io/series_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/io/gnuplot.hpp"

namespace talus::io {

namespace {

struct Curve {
  std::size_t column;  ///< counted from 1, as gnuplot does
  std::string label;
  std::string_view colour;
  double low, high;  ///< what its axis shows
};

/// The curve of a column, if any of its values is finite. What stays constant is shown in the middle of its axis.
std::optional<Curve> curve_of(Series const& series, std::size_t k, std::string_view label, std::string_view colour) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low = infinity, high = -infinity;
  for (double const value : series.values[k])
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  if (low > high) return {};
  double const margin = high > low ? 0.05 * (high - low) : low != 0 ? 0.1 * std::abs(low) : 1;
  return Curve{k + 1, fmt::format("{} ({})", label, series.columns[k].unit), colour, low - margin, high + margin};
}

/// The curves that the series has. Colours: Okabe & Ito (2008), told apart by all eyes.
std::vector<Curve> curves_of(Series const& series) {
  struct Known {
    std::string_view name, label, colour;
  };
  constexpr std::array<Known, 4> known{{{"front", "front", "#d55e00"},
                                        {"centre_of_mass_x", "centre of mass x", "#0072b2"},
                                        {"centre_of_mass_y", "centre of mass y", "#009e73"},
                                        {"centre_of_mass_z", "centre of mass z", "#cc79a7"}}};
  std::vector<Curve> curves;
  for (auto const& each : known)
    for (std::size_t k = 0; k < series.columns.size(); ++k)
      if (series.columns[k].name == each.name)
        if (auto curve = curve_of(series, k, each.label, each.colour)) curves.push_back(std::move(*curve));
  return curves;
}

}  // namespace

std::string motion_script(Series const& series, PictureFormat const& format) {
  constexpr int width = 1100, panel_height = 230, left = 130, right = 40, top = 30, bottom = 75, gap = 26;
  auto const curves = curves_of(series);
  auto const* time = series.find("time");
  if (curves.empty() || time == nullptr || time->size() < 2 || !(time->front() < time->back())) return "";
  auto const time_column = static_cast<std::size_t>(series.find("time") - series.values.data()) + 1;
  int const height = top + static_cast<int>(curves.size()) * (panel_height + gap) - gap + bottom;
  auto script = fmt::format(
      "reset\nset terminal {} size {},{} font 'sans,15' enhanced\nset output 'motion.{}.tmp'\n"
      "set datafile separator comma\nset datafile missing 'nan'\nunset key\nset tics out nomirror scale 0.5\n"
      "set border 3 lc rgb '#555555'\nset grid lc rgb '#dddddd' lt 1 lw 0.7\n"
      "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset multiplot\nset format x ''\n",
      format.terminal, width, height, format.extension, static_cast<double>(left) / width,
      static_cast<double>(width - right) / width);
  script += fmt::format("set xrange [{}:{}]\nset ytics autofreq\n", time->front(), time->back());
  int from_top = top;
  for (auto const& curve : curves) {
    if (&curve == &curves.back()) script += "set format x '%g'\nset xlabel 'time (s)'\n";
    script += fmt::format(
        "set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\nset ylabel {} noenhanced\n"
        "set yrange [{}:{}]\n",
        1 - static_cast<double>(from_top) / height, 1 - static_cast<double>(from_top + panel_height) / height,
        gnuplot_string(curve.label), curve.low, curve.high);
    script += fmt::format("plot '../series.csv' skip 1 using {}:{} with lines lw 2.5 lc rgb '{}'\n", time_column,
                          curve.column, curve.colour);
    from_top += panel_height + gap;
  }
  return script + "unset multiplot\nunset output\n";
}

}  // namespace talus::io
