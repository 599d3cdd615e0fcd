#include "core/config/manual.hpp"

#include <nlohmann/json.hpp>

namespace talus {

namespace {

std::string default_of(Outline const& outline) {
  if (outline.initial) return '`' + outline.initial->dump() + '`';
  if (must_be_given(outline)) return "required";
  return outline.is_optional ? "left out" : "";
}

/// The names that a choice has, or the range of a number.
std::string range_of(Outline const& outline) {
  std::string names;
  for (Alternative const& alternative : outline.alternatives) {
    names += (names.empty() ? "`" : ", `") + std::string(alternative.name) + '`';
  }
  bool const is_quantity = !outline.row.unit.empty();
  return outline.kind == Kind::choice ? names : is_quantity ? to_text(outline.row.range) : "";
}

std::string meaning_of(Description const& row) {
  std::string meaning(row.meaning);
  if (row.source.empty() && row.tried.bounded_above()) meaning += " (usually " + to_text(row.tried) + ')';
  if (!row.source.empty()) meaning += " (validated for " + to_text(row.tried) + ": " + std::string(row.source) + ')';
  return meaning;
}

/// A cell may not hold the mark that ends it.
std::string cell(std::string_view text) {
  std::string escaped;
  for (char const c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return ' ' + escaped + " |";
}

void add_rows(std::vector<Outline> const& parameters, std::string const& before, std::string& table) {
  for (Outline const& outline : parameters) {
    Description const& row = outline.row;
    std::string const name = before + std::string(row.name);
    std::string const symbol = row.symbol.empty() ? "" : '$' + std::string(row.symbol) + '$';
    table += '|' + cell('`' + name + '`') + cell(symbol) + cell(row.unit) + cell(default_of(outline)) +
             cell(range_of(outline)) + cell(meaning_of(row)) + '\n';
    if (outline.kind == Kind::group) add_rows(outline.parts, name + '/', table);
    if (outline.kind == Kind::list && outline.parts.front().kind == Kind::group) {
      add_rows(outline.parts.front().parts, name + "/0/", table);
    }
  }
}

}  // namespace

std::string parameter_table(std::vector<Outline> const& parameters) {
  if (parameters.empty()) return "No parameters.\n";
  std::string table =
      "| name | symbol | unit | default | range | meaning |\n"
      "|---|---|---|---|---|---|\n";
  add_rows(parameters, "", table);
  return table;
}

std::string policy_page(Alternative const& policy) {
  std::string page = "### " + std::string(policy.title) + "\n\n`{\"type\": \"" + std::string(policy.name) + "\"}`\n\n";
  if (!policy.source.empty()) page += "Source: " + std::string(policy.source) + "\n\n";
  return page + parameter_table(policy.parameters);
}

}  // namespace talus
