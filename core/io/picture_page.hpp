#pragma once
/// A page of panels that show dots, as a script for gnuplot.

#include <cstddef>
#include <string>
#include <vector>

#include "core/io/scatter.hpp"

namespace talus::io {

/// The part of the plane that a panel shows [m].
struct Window {
  double left = 0, right = 1, bottom = 0, top = 1;
  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return top - bottom; }
};

/// A line of text at a place of the plane, or a line between two.
struct Mark {
  double x, y;
  std::string text;
};
struct Line {
  double x0, y0, x1, y1;
};

/// One view of one instant. `data` names a file of rows `x y value` beside the script.
struct Panel {
  std::string title, data;
  std::size_t dots = 0;
  std::size_t thinned = 1;  ///< every n-th particle is among them
  double spacing = 0;       ///< about the distance between particles [m]
  int dimension = 2;        ///< of the space that the dots fill
  Window window;
  bool axes = true;                ///< with x and y axes in metres; else only the lines and marks
  double lowest = 0, highest = 0;  ///< values of the dots
  std::vector<Line> lines;
  std::vector<Mark> marks;
};

/// Panels under one title that share one scale of colours.
struct Page {
  std::string name, title, colour_label;
  double colour_low = 0, colour_high = 1;
  std::vector<Panel> panels;
};

/// What pictures are written as; `most_dots` on a page keeps the file small.
struct PictureFormat {
  std::string extension, terminal;
  double dot_size;  ///< diameter [px] of a point of size 1
  std::size_t most_dots;
};
[[nodiscard]] std::vector<PictureFormat> const& picture_formats();

/// Commands that draw a page into `<name>.<extension>.tmp`.
[[nodiscard]] std::string page_script(Page const& page, PictureFormat const& format);

}  // namespace talus::io
