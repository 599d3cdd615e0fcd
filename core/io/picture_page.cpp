#include "core/io/picture_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/io/gnuplot.hpp"

namespace talus::io {

namespace {

constexpr int page_width = 1600, font_size = 16;
constexpr int left_margin = 125, right_margin = 180, top_margin = 70, bottom_margin = 78;
constexpr int panel_title = 34, axis_numbers = 26, gap = 46;

/// Where the panels of a page lie [px]: all equally wide, each row as high as its highest panel.
struct Arrangement {
  std::size_t columns = 1;
  int panel_width = 0, page_height = 0;
  std::vector<int> tops, heights;  ///< of the panels; from the top of the page
};

Arrangement arrange(std::vector<Panel> const& panels, std::size_t columns) {
  Arrangement a;
  a.columns = columns;
  auto const gaps = static_cast<int>(columns) - 1;
  a.panel_width = (page_width - left_margin - right_margin - gaps * gap) / (gaps + 1);
  int top = top_margin;
  for (std::size_t k = 0; k < panels.size(); k += columns) {
    auto const end = std::min(panels.size(), k + columns);
    int highest = 0;
    for (auto i = k; i < end; ++i) {
      auto const& window = panels[i].window;
      a.heights.push_back(static_cast<int>(std::lround(a.panel_width * window.height() / window.width())));
      a.tops.push_back(top + panel_title);
      highest = std::max(highest, a.heights.back());
    }
    top += panel_title + highest + axis_numbers;
  }
  a.page_height = top + bottom_margin - axis_numbers;
  return a;
}

/// The number of columns that brings the page nearest to the shape of a screen.
Arrangement best_arrangement(std::vector<Panel> const& panels) {
  auto const off = [](Arrangement const& a) { return std::abs(std::log(1.7 * a.page_height / page_width)); };
  auto best = arrange(panels, 1);
  for (std::size_t columns = 2; columns <= std::min<std::size_t>(3, panels.size()); ++columns)
    if (auto other = arrange(panels, columns); off(other) < off(best)) best = std::move(other);
  return best;
}

/// Viridis, as far as few colours tell it: equally spaced to the eye, and in grey (Smith & van der Walt 2015, CC0).
std::string palette() {
  return "set palette defined (0 '#440154', 1 '#482878', 2 '#3e4989', 3 '#31688e', 4 '#26828e', 5 '#1f9e89',"
         " 6 '#35b779', 7 '#6ece58', 8 '#b5de2b', 9 '#fde725')\n";
}

std::string page_head(Page const& page, Arrangement const& a, PictureFormat const& format) {
  auto const screen = [&](int y) { return 1 - static_cast<double>(y) / a.page_height; };
  auto head = fmt::format("reset\nset terminal {} size {},{} font 'sans,{}' enhanced\nset output '{}.{}.tmp'\n",
                          format.terminal, page_width, a.page_height, font_size, page.name, format.extension);
  head += palette() + "unset key\nset tics out nomirror scale 0.5\nset border 3 lc rgb '#555555'\n";
  head += "set grid lc rgb '#dddddd' lt 1 lw 0.7\n";
  head += fmt::format("set cbrange [{}:{}]\n", page.colour_low, page.colour_high);
  constexpr double bar_left = static_cast<double>(page_width - right_margin + 36) / page_width;
  constexpr double bar_width = 24.0 / page_width;
  auto const middle = (screen(a.tops.back() + a.heights.back()) + screen(a.tops.front())) / 2;
  auto const length = std::min(2 * (screen(a.tops.front()) - middle), 460.0 / a.page_height);
  head += fmt::format("set colorbox user origin {:.5f},{:.5f} size {:.5f},{:.5f} noborder\n", bar_left,
                      middle - length / 2, bar_width, length);
  auto const label = [](int tag, std::string const& text, double x, double y, std::string_view place, int size) {
    return fmt::format("set label {} {} at screen {:.5f},{:.5f} {} noenhanced font ',{}'\n", tag, gnuplot_string(text),
                       x, y, place, size);
  };
  head += "set multiplot\n" +
          label(1, page.title, static_cast<double>(left_margin) / page_width, screen(30), "left", font_size + 3);
  head += label(2, page.colour_label, bar_left, middle + length / 2 + 28.0 / a.page_height, "left", font_size);
  return head;
}

/// The panel's place on the page and the part of the plane that it shows: equal scales on both axes.
std::string place_script(Panel const& panel, Arrangement const& a, std::size_t k) {
  auto const left = left_margin + static_cast<int>(k % a.columns) * (a.panel_width + gap);
  auto const across = [](int x) { return static_cast<double>(x) / page_width; };
  auto const up = [&](int y) { return 1 - static_cast<double>(y) / a.page_height; };
  auto const& window = panel.window;
  return fmt::format(
      "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\nset tmargin at screen {:.6f}\n"
      "set bmargin at screen {:.6f}\nset xrange [{:.8g}:{:.8g}]\nset yrange [{:.8g}:{:.8g}]\n",
      across(left), across(left + a.panel_width), up(a.tops[k]), up(a.tops[k] + a.heights[k]), window.left,
      window.right, window.bottom, window.top);
}

/// 1, 2 or 5 times a power of ten: the least distance of numbers [m] that lie `apart` pixels from each other.
double tic_distance(double pixels_per_metre, double apart) {
  double const least = apart / pixels_per_metre, power = std::pow(10.0, std::floor(std::log10(least)));
  double const ratio = least / power;
  return power * (ratio <= 1 ? 1 : ratio <= 2 ? 2 : ratio <= 5 ? 5 : 10);
}

std::string axes_script(Panel const& panel, double pixels_per_metre, bool leftmost, bool lowest) {
  if (!panel.axes) return "unset border\nunset xtics\nunset ytics\nunset grid\nset xlabel ''\nset ylabel ''\n";
  return fmt::format(
      "set xtics {:.3g}\nset ytics {:.3g}\nset format x '{}'\nset format y '{}'\n"
      "set xlabel '{}' offset 0,0.4\nset ylabel '{}' offset 0.3,0\n",
      tic_distance(pixels_per_metre, 80), tic_distance(pixels_per_metre, 40), lowest ? "%g" : "", leftmost ? "%g" : "",
      lowest ? "x (m)" : "", leftmost ? "y (m)" : "");
}

std::string marks_script(Panel const& panel) {
  std::string text = "unset arrow\n";
  for (auto const& line : panel.lines)
    text += fmt::format("set arrow from {:.6g},{:.6g} to {:.6g},{:.6g} nohead back lc rgb '#bbbbbb' lw 1.2\n", line.x0,
                        line.y0, line.x1, line.y1);
  int number = 3;
  for (auto const& mark : panel.marks)
    text += fmt::format("set label {} {} at {:.6g},{:.6g} center noenhanced tc rgb '#555555'\n", number++,
                        gnuplot_string(mark.text), mark.x, mark.y);
  return text;
}

/// Dots larger than their distance, so that a body looks closed; more so where some are left out of a plane, as the
/// rest do not lie evenly.
std::string plot_command(Panel const& panel, std::size_t every, double pixels_per_metre, PictureFormat const& format) {
  constexpr double smallest = 1.6, largest = 24;
  auto const thinned = static_cast<double>(panel.thinned * every);
  double const overlap = thinned > 1 && panel.dimension == 2 ? 2.1 : 1.5;
  double const spacing = panel.spacing * std::pow(thinned, 1.0 / panel.dimension);
  double const diameter = std::clamp(overlap * spacing * pixels_per_metre, smallest, largest);
  return fmt::format("plot '{}' using 1:2:3 every {} with points pt 7 ps {:.4f} lc palette\n", panel.data, every,
                     diameter / format.dot_size);
}

}  // namespace

std::vector<PictureFormat> const& picture_formats() {
  static std::vector<PictureFormat> const formats{{"png", "pngcairo", 6.1, 150000},
                                                  {"svg", "svg", 0.75 * font_size, 20000}};
  return formats;
}

std::string page_script(Page const& page, PictureFormat const& format) {
  auto const a = best_arrangement(page.panels);
  std::size_t dots = 0;
  for (auto const& panel : page.panels) dots += panel.dots;
  auto const every = std::max<std::size_t>(1, (dots + format.most_dots - 1) / format.most_dots);
  auto script = page_head(page, a, format);
  for (std::size_t k = 0; k < page.panels.size(); ++k) {
    auto const& panel = page.panels[k];
    script += place_script(panel, a, k);
    script += fmt::format("set title {} noenhanced offset 0,-0.7\n", gnuplot_string(panel.title));
    double const scale = a.panel_width / panel.window.width();  // pixels per metre
    bool const lowest = k + a.columns >= page.panels.size() || !page.panels[k + a.columns].axes;
    script += axes_script(panel, scale, k % a.columns == 0, lowest) + marks_script(panel);
    script += plot_command(panel, every, scale, format);
    script += "unset colorbox\nunset label\n";
  }
  return script + "unset multiplot\nunset output\n";
}

}  // namespace talus::io
