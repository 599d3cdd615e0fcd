#include "benchmarks/report/document.hpp"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "benchmarks/report/text.hpp"
#include "core/errors.hpp"
#include "core/io/text.hpp"

namespace talus::bench {

namespace {

using Json = nlohmann::json;

Json row_document(Table const& table, Row const& row) {
  Json document{{"name", row.name}, {"unit", row.unit}, {"repeats", row.value.repeats}};
  io::set_number(document, "value", row.value.median);
  io::set_number(document, "spread_percent", row.value.spread);
  if (row.bar) {
    Json bar = Json::object();
    if (row.bar->least) bar["at_least"] = *row.bar->least;
    if (row.bar->most) bar["at_most"] = *row.bar->most;
    if (row.bar->stretch) bar["stretch"] = *row.bar->stretch;
    document["bar"] = bar;
    document["met"] = row.bar->met(row.value.median);
  }
  for (std::size_t k = 0; k < std::min(row.more.size(), table.columns.size()); ++k)
    if (!row.more[k].empty()) document["more"][table.columns[k]] = row.more[k];
  return document;
}

Json table_document(Table const& table) {
  Json rows = Json::array();
  for (Row const& row : table.rows) rows.push_back(row_document(table, row));
  return {{"title", table.title}, {"rows", rows}, {"notes", table.notes}};
}

/// Values by benchmark, table and row.
using Earlier = std::map<std::string, double>;

std::string key(std::string const& benchmark, std::string const& table, std::string const& row) {
  return benchmark + "\n" + table + "\n" + row;
}

Earlier values_of(Json const& document) {
  Earlier values;
  try {
    for (Json const& benchmark : document.at("benchmarks"))
      for (Json const& table : benchmark.at("tables"))
        for (Json const& row : table.at("rows"))
          if (row.at("value").is_number())
            values[key(benchmark.at("name"), table.at("title"), row.at("name"))] = row.at("value");
  } catch (Json::exception const&) {
    throw InputError("what to compare with is no results.json of talus bench");
  }
  return values;
}

}  // namespace

Json document_of(std::vector<Measured> const& all, Json const& provenance) {
  Json benchmarks = Json::array();
  bool met = true;
  for (Measured const& measured : all) {
    Json tables = Json::array();
    for (Table const& table : measured.result.tables) tables.push_back(table_document(table));
    met = met && all_met(measured.result);
    benchmarks.push_back({{"name", measured.name},
                          {"what", measured.what},
                          {"seconds", measured.seconds},
                          {"met", all_met(measured.result)},
                          {"tables", tables}});
  }
  return {{"schema", "talus/bench/1"}, {"provenance", provenance}, {"met", met}, {"benchmarks", benchmarks}};
}

void compare(std::vector<Measured>& all, Json const& earlier) {
  Earlier const values = values_of(earlier);
  for (Measured& measured : all)
    for (Table& table : measured.result.tables) {
      table.columns.emplace_back("against earlier");
      for (Row& row : table.rows) {
        row.more.resize(table.columns.size() - 1);
        auto const found = values.find(key(measured.name, table.title, row.name));
        bool const known = found != values.end() && found->second != 0;
        row.more.push_back(known ? fmt::format("{:+.1f} %", 100 * (row.value.median / found->second - 1)) : "new");
      }
    }
}

}  // namespace talus::bench
