#include "benchmarks/report/text.hpp"

#include <fmt/format.h>

#include "core/io/columns.hpp"

namespace talus::bench {

namespace {

using Cells = std::vector<std::string>;

std::string const sides = "lrlrrll";  ///< of the columns that every table has

Cells cells_of(Row const& row) {
  bool const once = row.value.repeats <= 1;
  Cells cells{row.name,
              io::in_four_digits(row.value.median),
              row.unit,
              once ? "" : fmt::format("± {:.1f} %", row.value.spread),
              once ? "" : fmt::to_string(row.value.repeats),
              bar_text(row),
              verdict_text(row)};
  cells.insert(cells.end(), row.more.begin(), row.more.end());
  return cells;
}

}  // namespace

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
    text += "\n" + table.title + "\n" + io::columns(rows, sides + std::string(table.columns.size(), 'r'));
    for (std::string const& note : table.notes) text += "  " + note + "\n";
  }
  return text + "\n";
}

}  // namespace talus::bench
