#include "benchmarks/report/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace talus::bench {

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

Cells cells_of(Row const& row) {
  bool const once = row.value.repeats <= 1;
  Cells cells{row.name,
              in_short(row.value.median),
              row.unit,
              once ? "" : fmt::format("± {:.1f} %", row.value.spread),
              once ? "" : fmt::to_string(row.value.repeats),
              bar_text(row),
              verdict_text(row)};
  cells.insert(cells.end(), row.more.begin(), row.more.end());
  return cells;
}

/// Lines of a table: the columns as wide as they must be, empty ones left out.
std::string lines_of(std::vector<Cells> const& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (std::size_t c = 0; c < widths.size(); ++c) {
    bool const filled =
        std::any_of(rows.begin() + 1, rows.end(), [&](Cells const& row) { return c < row.size() && !row[c].empty(); });
    for (Cells const& row : rows)
      if (filled && c < row.size()) widths[c] = std::max(widths[c], width_of(row[c]));
  }
  std::string text;
  for (Cells const& row : rows) {
    std::string line = " ";
    for (std::size_t c = 0; c < row.size(); ++c)
      if (widths[c] > 0) line += " " + padded(row[c], widths[c] + 1, c == 1 || c == 3 || c == 4 || c > 6);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace

std::string in_short(double value) {
  double const size = std::abs(value);
  if (size < 1e7 && value == std::floor(value)) return fmt::format("{:.0f}", value);
  if (value != 0 && (size >= 1e7 || size < 1e-3)) return fmt::format("{:.3e}", value);
  int const before = size >= 1 ? 1 + static_cast<int>(std::floor(std::log10(size))) : 0;
  return fmt::format("{:.{}f}", value, std::max(0, 4 - std::max(1, before)));
}

std::string bar_text(Row const& row) {
  if (!row.bar) return "";
  std::string text;
  if (row.bar->least) text += fmt::format("≥ {:g}", *row.bar->least);
  if (row.bar->most) text += fmt::format("{}≤ {:g}", text.empty() ? "" : ", ", *row.bar->most);
  if (row.bar->stretch) text += fmt::format(" (stretch {:g})", *row.bar->stretch);
  return text;
}

std::string verdict_text(Row const& row) {
  if (!row.bar) return "";
  if (!row.bar->met(row.value.median)) return "FAIL";
  return row.bar->stretch && row.value.median >= *row.bar->stretch ? "pass, stretch" : "pass";
}

bool all_met(Result const& result) {
  for (Table const& table : result.tables)
    for (Row const& row : table.rows)
      if (row.bar && !row.bar->met(row.value.median)) return false;
  return true;
}

std::string text_of(Measured const& measured) {
  std::string text = fmt::format("== {}: {} ({:.0f} s)\n", measured.name, measured.what, measured.seconds);
  for (Table const& table : measured.result.tables) {
    Cells head{"", "value", "", "spread", "n", "bar", ""};
    head.insert(head.end(), table.columns.begin(), table.columns.end());
    std::vector<Cells> rows{head};
    for (Row const& row : table.rows) rows.push_back(cells_of(row));
    text += "\n" + table.title + "\n" + lines_of(rows);
    for (std::string const& note : table.notes) text += "  " + note + "\n";
  }
  return text + "\n";
}

}  // namespace talus::bench
