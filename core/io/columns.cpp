#include "core/io/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace talus::io {

namespace {

using Cells = std::vector<std::string>;

/// Characters of a text in UTF-8.
std::size_t width_of(std::string const& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(std::string const& text, std::size_t width, bool right) {
  std::string const space(width - std::min(width, width_of(text)), ' ');
  return right ? space + text : text + space;
}

}  // namespace

std::string in_four_digits(double value) {
  double const size = std::abs(value);
  if (size < 1e7 && value == std::floor(value)) return fmt::format("{:.0f}", value);
  if (value != 0 && (size >= 1e7 || size < 1e-3)) return fmt::format("{:.3e}", value);
  int const before = size >= 1 ? 1 + static_cast<int>(std::floor(std::log10(size))) : 0;
  return fmt::format("{:.{}f}", value, std::max(0, 4 - std::max(1, before)));
}

std::string columns(std::vector<Cells> const& rows, std::string_view sides) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (std::size_t c = 0; c < widths.size(); ++c) {
    bool const filled =
        std::any_of(rows.begin() + 1, rows.end(), [&](Cells const& row) { return c < row.size() && !row[c].empty(); });
    for (Cells const& row : rows)
      if (filled && c < row.size()) widths[c] = std::max(widths[c], width_of(row[c]));
  }
  std::string text;
  for (Cells const& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < std::min(row.size(), widths.size()); ++c)
      if (widths[c] > 0) line += "  " + padded(row[c], widths[c], c < sides.size() && sides[c] == 'r');
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace talus::io
