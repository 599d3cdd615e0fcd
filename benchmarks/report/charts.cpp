#include "benchmarks/report/charts.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/io/files.hpp"
#include "core/io/gnuplot.hpp"

namespace talus::bench {

namespace {

constexpr int width = 1000, height = 560;

/// Colours that the colour-blind tell apart. Source: Okabe & Ito (2008), Color Universal Design.
char const* colour(std::size_t k) {
  constexpr std::array colours{"#0072b2", "#e69f00", "#009e73", "#d55e00", "#cc79a7", "#56b4e9"};
  return colours[k % colours.size()];
}

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.8g}", value) : "NaN";
}

/// The numbers of a chart: of bars a line a label with all curves side by side, else a block of lines a curve.
std::string data_of(Chart const& chart) {
  std::string text = "$data << END\n";
  if (!chart.labels.empty()) {
    for (std::size_t k = 0; k < chart.labels.size(); ++k) {
      text += "\"" + chart.labels[k] + "\"";
      for (Curve const& curve : chart.curves) text += " " + number(curve.y[k]);
      text += "\n";
    }
    return text + "END\n";
  }
  for (Curve const& curve : chart.curves) {
    for (std::size_t k = 0; k < curve.x.size(); ++k)
      text += fmt::format("{} {} {} {}\n", number(curve.x[k]), number(curve.y[k]),
                          number(curve.low.empty() ? curve.y[k] : curve.low[k]),
                          number(curve.high.empty() ? curve.y[k] : curve.high[k]));
    text += "\n\n";
  }
  return text + "END\n";
}

std::string plots_of(Chart const& chart) {
  std::vector<std::string> plots;
  for (std::size_t k = 0; k < chart.curves.size(); ++k) {
    auto const title = io::gnuplot_string(chart.curves[k].name);
    if (chart.labels.empty())
      plots.push_back(
          fmt::format("$data index {} using 1:2:3:4 with yerrorlines pt 7 ps 0.9 lw 1.6 lc rgb '{}' title {}", k,
                      colour(k), title));
    else
      plots.push_back(fmt::format("$data using {}:xtic(1) with histograms lc rgb '{}' fs solid 0.9 noborder title {}",
                                  k + 2, colour(k), title));
  }
  std::string text = "plot ";
  for (std::size_t k = 0; k < plots.size(); ++k) text += (k > 0 ? ", \\\n  " : "") + plots[k];
  return text + "\n";
}

std::string script_of(Chart const& chart, bool svg) {
  auto text = fmt::format("reset\nset terminal {} size {},{} font 'sans,13' noenhanced{}\nset output '{}.{}'\n",
                          svg ? "svg" : "pngcairo", width, height, svg ? fmt::format(" name '{}'", chart.name) : "",
                          chart.name, svg ? "svg" : "png");
  text += "set border 3 lc rgb '#555555'\nset tics out nomirror\nset grid y lc rgb '#dddddd' lt 1 lw 0.7\n";
  text += "set key outside top center horizontal\nset yrange [0:*]\nset offsets graph 0, 0, graph 0.05, 0\n";
  text += fmt::format("set title {}\nset xlabel {}\nset ylabel {}\n", io::gnuplot_string(chart.title),
                      io::gnuplot_string(chart.x_label), io::gnuplot_string(chart.y_label));
  if (chart.log_x) text += "set logscale x\nset format x '%.0f'\nset rmargin 8\nset offsets 0, 0, graph 0.05, 0\n";
  if (!chart.labels.empty()) {
    text += "set style data histograms\nset style histogram clustered gap 1\nset boxwidth 0.9\n";
    if (chart.labels.size() > 5) text += "set xtics rotate by -30 left\nset rmargin 14\n";
  }
  for (double const y : chart.lines)
    text +=
        fmt::format("set arrow from graph 0, first {0:g} to graph 1, first {0:g} nohead dt 2 lc rgb '#777777'\n", y);
  return text + plots_of(chart) + "unset output\n";
}

}  // namespace

std::string draw_charts(std::filesystem::path const& folder, std::vector<Chart> const& charts) {
  if (charts.empty()) return "";
  std::string script;
  for (Chart const& chart : charts) script += data_of(chart) + script_of(chart, false) + script_of(chart, true);
  io::write_atomically(folder / "pictures.gp", script);
  return io::run_gnuplot(folder, "pictures.gp");
}

}  // namespace talus::bench
