#include "core/io/picture_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/io/files.hpp"

namespace talus::io {

namespace {

constexpr std::size_t most_dots_per_panel = 20000;

std::array<double, 2> seen(Direction const& p, View const& view) {
  std::array<double, 2> place{};
  for (std::size_t k = 0; k < 3; ++k) {
    place[0] += p[k] * view.right[k];
    place[1] += p[k] * view.up[k];
  }
  return place;
}

/// Corner of a box: bit k says whether it lies at the high end of axis k.
Direction corner(Bounds const& box, std::size_t bits) {
  Direction p{};
  for (std::size_t k = 0; k < 3; ++k) p[k] = (bits >> k & 1) != 0 ? box.high[k] : box.low[k];
  return p;
}

/// What a view shows of a box: with a margin, and neither too flat nor too slender to be drawn.
Window window_around(Bounds const& box, View const& view) {
  Bounds shown;
  for (std::size_t bits = 0; bits < 8; ++bits) {
    auto const place = seen(corner(box, bits), view);
    shown.include({place[0], place[1], 0});
  }
  constexpr double flattest = 8, most_slender = 1.5, margin = 1.08, least = 1e-6;
  double const width = shown.high[0] - shown.low[0], height = shown.high[1] - shown.low[1];
  double const wide = margin * std::max({width, height / most_slender, least});
  double const high = std::max(margin * height, wide / flattest);
  double const middle = (shown.low[0] + shown.high[0]) / 2;
  double const bottom = shown.low[1] - (1 - 1 / margin) / 2 * high;
  return {middle - wide / 2, middle + wide / 2, bottom, bottom + high};
}

/// The edges of the box, and the axes' names at three of them in front.
void draw_box(Panel& panel, Bounds const& box, View const& view) {
  for (std::size_t from = 0; from < 8; ++from)
    for (std::size_t k = 0; k < 3; ++k) {
      if ((from >> k & 1) != 0) continue;
      auto const a = seen(corner(box, from), view), b = seen(corner(box, from | std::size_t{1} << k), view);
      panel.lines.push_back({a[0], a[1], b[0], b[1]});
    }
  struct Named {
    char const* axis;
    std::size_t from, to;  // corners
    double right, up;      // where the name stands beside the edge
  };
  constexpr std::array<Named, 3> edges{{{"x", 4, 5, -0.2, -1}, {"y", 4, 6, -1.4, 0}, {"z", 5, 1, 0.8, -0.6}}};
  double const away = 0.025 * panel.window.width();
  for (auto const& edge : edges) {
    auto const a = seen(corner(box, edge.from), view), b = seen(corner(box, edge.to), view);
    panel.marks.push_back({(a[0] + b[0]) / 2 + edge.right * away, (a[1] + b[1]) / 2 + edge.up * away, edge.axis});
  }
}

}  // namespace

Panel make_panel(Scenery const& scenery, Snapshot const& snapshot, std::string const& number, bool oblique) {
  auto const view = oblique ? oblique_view() : side_view();
  auto const dots = dots_of(snapshot, view, scenery.field);
  auto const every = std::max<std::size_t>(1, (dots.size() + most_dots_per_panel - 1) / most_dots_per_panel);
  Panel panel;
  panel.title = fmt::format("t = {:.4g} s", snapshot.time);
  panel.data = fmt::format("{}_{}.dat", oblique ? "oblique" : "side", number);
  panel.dimension = snapshot.dimension;
  panel.thinned = every;
  panel.spacing = scenery.spacing;
  panel.window = window_around(scenery.bounds, view);
  panel.axes = !oblique;
  if (oblique) draw_box(panel, scenery.bounds, view);
  std::string rows;
  for (std::size_t k = 0; k < dots.size(); k += every, ++panel.dots) {
    rows += fmt::format("{:.6g} {:.6g} {:.5g}\n", dots[k].x, dots[k].y, dots[k].value);
    panel.lowest = std::min(panel.lowest, dots[k].value);
    panel.highest = std::max(panel.highest, dots[k].value);
  }
  write_atomically(scenery.folder / panel.data, rows);
  return panel;
}

}  // namespace talus::io
