#pragma once
/// Curves over a common axis, as a script for gnuplot.

#include <cstddef>
#include <string>
#include <vector>

#include "core/io/picture_page.hpp"

namespace talus::io {

/// Two columns (counted from 1) of a file of numbers with a header, separated by commas: of `rows` rows from `first` on,
/// or of all if `rows` is 0.
struct CsvCurve {
  std::string label, file;
  std::size_t x = 1, y = 2;
  std::size_t first = 0, rows = 0;
};

struct CurvePage {
  std::string name, title, x_label, y_label;
  bool dots = false;  ///< the points are marked
  std::vector<CsvCurve> curves;
};

/// Commands that draw a page into `<name>.<extension>.tmp`. Curves have no names where there is one only.
[[nodiscard]] std::string curve_script(CurvePage const& page, PictureFormat const& format);

}  // namespace talus::io
