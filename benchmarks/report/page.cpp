#include "benchmarks/report/page.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "benchmarks/report/text.hpp"
#include "core/io/columns.hpp"
#include "core/io/files.hpp"
#include "core/io/xml.hpp"

namespace talus::bench {

namespace {

constexpr std::string_view style = R"(
body { font: 15px/1.45 system-ui, sans-serif; color: #222; max-width: 76rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.25rem; margin-top: 2.5rem; border-bottom: 1px solid #ccc; }
h3 { font-size: 1rem; margin: 1.6rem 0 0.4rem; }
table { border-collapse: collapse; font-size: 0.9rem; }
th, td { padding: 0.15rem 0.7rem; text-align: left; border-bottom: 1px solid #e4e4e4; white-space: nowrap; }
td.n { text-align: right; font-variant-numeric: tabular-nums; }
.pass { color: #00664b; } .fail { color: #b03000; font-weight: 600; }
p.note { color: #555; font-size: 0.85rem; margin: 0.3rem 0; } svg { max-width: 100%; height: auto; }
pre { background: #f6f6f6; padding: 0.8rem; overflow-x: auto; font-size: 0.8rem; white-space: pre-wrap; }
)";

std::string cell(std::string const& text, std::string_view kind = "") {
  return kind.empty() ? fmt::format("<td>{}</td>", io::xml::escape(text))
                      : fmt::format("<td class=\"{}\">{}</td>", kind, io::xml::escape(text));
}

std::string html_of(Row const& row, std::size_t columns) {
  bool const once = row.value.repeats <= 1;
  auto const verdict = verdict_text(row);
  auto html = "<tr>" + cell(row.name) + cell(io::in_four_digits(row.value.median) + " " + row.unit, "n") +
              cell(once ? "" : fmt::format("± {:.1f} %", row.value.spread), "n") +
              cell(once ? "" : fmt::to_string(row.value.repeats), "n") + cell(bar_text(row), "n") +
              cell(verdict, verdict == "FAIL" ? "fail" : "pass");
  for (std::size_t k = 0; k < columns; ++k) html += cell(k < row.more.size() ? row.more[k] : "", "n");
  return html + "</tr>\n";
}

std::string html_of(Table const& table) {
  auto html = fmt::format(
      "<h3>{}</h3>\n<table>\n<tr><th></th><th>median</th><th>spread</th><th>repeats</th>"
      "<th>bar</th><th></th>",
      io::xml::escape(table.title));
  for (std::string const& column : table.columns) html += "<th>" + io::xml::escape(column) + "</th>";
  html += "</tr>\n";
  for (Row const& row : table.rows) html += html_of(row, table.columns.size());
  html += "</table>\n";
  for (std::string const& note : table.notes) html += "<p class=\"note\">" + io::xml::escape(note) + "</p>\n";
  return html;
}

/// The picture without the head of its file; empty where it was not drawn.
std::string inlined(std::filesystem::path const& file) {
  if (!std::filesystem::exists(file)) return "";
  auto const svg = io::read_file(file);
  auto const begin = svg.find("<svg");
  return begin == svg.npos ? "" : svg.substr(begin);
}

/// What a reader asks first of where numbers come from; then all of it.
std::string html_of(nlohmann::json const& provenance) {
  auto short_form = provenance;
  short_form["build"]["git"].erase("diff");
  return "<h2>Where this comes from</h2>\n<pre>" + io::xml::escape(short_form.dump(2)) + "</pre>\n";
}

}  // namespace

std::string page_of(std::vector<Measured> const& all, nlohmann::json const& provenance,
                    std::filesystem::path const& folder) {
  auto html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>What Talus costs</title>\n"
      "<style>{}</style></head><body>\n<h1>What Talus costs</h1>\n"
      "<p class=\"note\">Median of the repeats; spread: half of the interquartile range. Times on one thread are of "
      "that thread; ratios are of pairs of slices that ran in turns.</p>\n",
      style);
  for (Measured const& measured : all) {
    html += fmt::format("<h2>{}</h2>\n<p>{} ({:.0f} s)</p>\n", io::xml::escape(measured.name),
                        io::xml::escape(measured.what), measured.seconds);
    for (Table const& table : measured.result.tables) html += html_of(table);
    for (Chart const& chart : measured.result.charts) html += inlined(folder / (chart.name + ".svg"));
  }
  return html + html_of(provenance) + "</body></html>\n";
}

}  // namespace talus::bench
