#include "core/io/curve_page.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "core/io/gnuplot.hpp"

namespace talus::io {

namespace {

/// Okabe & Ito (2008), told apart by all eyes; dashes where there are more curves than colours.
constexpr std::array<std::string_view, 7> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#e69f00", "#56b4e9", "#000000"};

}  // namespace

std::string curve_script(CurvePage const& page, PictureFormat const& format) {
  bool const named = page.curves.size() > 1;
  auto script = fmt::format(
      "reset\nset terminal {} size {},640 font 'sans,15' noenhanced\nset output '{}.{}.tmp'\n"
      "set datafile separator comma\nset datafile missing 'nan'\nset tics out nomirror\n"
      "set border 3 lc rgb '#555555'\nset grid lc rgb '#dddddd' lt 1 lw 0.7\nset key {}\n"
      "set title {}\nset xlabel {}\nset ylabel {}\nset offsets graph 0.03, graph 0.03, graph 0.05, graph 0.03\n",
      format.terminal, named ? 1150 : 900, page.name, format.extension, named ? "outside right top" : "off",
      gnuplot_string(page.title), gnuplot_string(page.x_label), gnuplot_string(page.y_label));
  std::string plots;
  for (std::size_t k = 0; k < page.curves.size(); ++k) {
    CsvCurve const& curve = page.curves[k];
    std::string const every =
        curve.rows > 0 ? fmt::format(" every ::{}::{}", curve.first, curve.first + curve.rows - 1) : "";
    plots += fmt::format("{} {} skip 1{} using {}:{} with {} lw 2 dt {} lc rgb '{}'{} title {}",
                         k == 0 ? "plot" : ", \\\n    ", gnuplot_string(curve.file), every, curve.x, curve.y,
                         page.dots ? "linespoints" : "lines", 1 + k / colours.size() % 5, colours[k % colours.size()],
                         page.dots ? " pt 7 ps 0.7" : "", gnuplot_string(curve.label));
  }
  return script + plots + "\nunset output\n";
}

}  // namespace talus::io
