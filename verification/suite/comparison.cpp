#include "verification/suite/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "core/config/json.hpp"
#include "core/errors.hpp"
#include "core/io/files.hpp"
#include "core/io/text.hpp"
#include "verification/suite/document.hpp"

namespace talus::verification {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Change beside(std::string const& id, Row const& row, Row const* earlier) {
  return {id,          row.subject,
          row.measure, row.unit,
          row.found,   earlier == nullptr ? nan : earlier->found,
          row.verdict, earlier == nullptr ? std::nullopt : std::optional(earlier->verdict)};
}

void compare_case(std::vector<Change>& changes, Result const& result, Result const* earlier) {
  std::vector<Row const*> left;
  if (earlier != nullptr)
    for (Row const& row : earlier->findings.rows) left.push_back(&row);
  for (Row const& row : result.findings.rows) {
    auto const found = std::find_if(left.begin(), left.end(), [&](Row const* before) {
      return before->subject == row.subject && before->measure == row.measure;
    });
    changes.push_back(beside(result.id, row, found == left.end() ? nullptr : *found));
    if (found != left.end()) left.erase(found);
  }
  for (Row const* row : left)
    changes.push_back({result.id, row->subject, row->measure, row->unit, nan, row->found, {}, row->verdict});
}

Result const* find(std::vector<Result> const& results, std::string const& id) {
  auto const found = std::find_if(results.begin(), results.end(), [&](Result const& r) { return r.id == id; });
  return found == results.end() ? nullptr : &*found;
}

/// A member that is a text; nothing where it is missing or something else.
std::string text_of(nlohmann::json const& object, char const* name) {
  auto const found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

nlohmann::json change_document(Change const& change) {
  nlohmann::json document{
      {"case", change.id}, {"subject", change.subject}, {"measure", change.measure}, {"unit", change.unit}};
  io::set_number(document, "found", change.found);
  io::set_number(document, "earlier", change.earlier);
  if (change.verdict) document["verdict"] = word_of(*change.verdict);
  if (change.earlier_verdict) document["earlier_verdict"] = word_of(*change.earlier_verdict);
  document["text"] = change_text(change);
  return document;
}

}  // namespace

std::optional<double> Change::relative() const {
  if (found == earlier) return 0;
  double const change = found / earlier - 1;
  return std::isfinite(change) ? std::optional(change) : std::nullopt;
}

Comparison compare(std::vector<Result> const& results, std::vector<Result> const& earlier) {
  Comparison comparison;
  for (Result const& result : results) compare_case(comparison.changes, result, find(earlier, result.id));
  for (Result const& before : earlier)
    if (find(results, before.id) == nullptr) comparison.not_run.push_back(before.id);
  return comparison;
}

Comparison compare_with(std::vector<Result> const& results, std::string const& folder) {
  auto const path = std::filesystem::path(folder) / "results.json";
  auto const document = json_of(io::read_file(path));
  if (document.is_discarded()) throw InputError(path.string() + " is no JSON");
  Comparison comparison = compare(results, results_of(document));
  comparison.folder = folder;
  if (auto const provenance = document.find("provenance"); provenance != document.end() && provenance->is_object()) {
    comparison.version = text_of(*provenance, "version");
    comparison.start = text_of(*provenance, "start");
  }
  return comparison;
}

std::string change_text(Change const& change) {
  if (change.vanished()) return "gone";
  if (change.is_new()) return "new";
  auto const relative = change.relative();
  if (relative && *relative == 0) return "same";
  if (std::isnan(change.found) && std::isnan(change.earlier)) return "same";
  // beyond a factor of ten a percentage is hard to read
  if (!relative || std::abs(*relative) > 9) return value_text(change.earlier, change.unit) + " before";
  double const percent = 100 * *relative;
  return std::abs(percent) < 0.005 ? fmt::format("{:+.0e} %", percent) : fmt::format("{:+.2f} %", percent);
}

nlohmann::json document_of(Comparison const& comparison) {
  nlohmann::json changes = nlohmann::json::array();
  for (Change const& change : comparison.changes) changes.push_back(change_document(change));
  return {{"folder", comparison.folder},
          {"version", comparison.version},
          {"start", comparison.start},
          {"not_run", comparison.not_run},
          {"changes", changes}};
}

}  // namespace talus::verification
