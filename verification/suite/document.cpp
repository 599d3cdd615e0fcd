#include "verification/suite/document.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/errors.hpp"
#include "core/io/text.hpp"

namespace talus::verification {

namespace {

using Json = nlohmann::json;

Json interval_document(Interval const& interval) {
  Json document = Json::object();
  if (interval.low) io::set_number(document, "low", *interval.low);
  if (interval.high) io::set_number(document, "high", *interval.high);
  return document;
}

Interval interval_of(Json const& document) {
  Interval interval;
  if (document.contains("low")) interval.low = io::number_of(document, "low");
  if (document.contains("high")) interval.high = io::number_of(document, "high");
  return interval;
}

Json cost_document(Cost const& cost) {
  Json document{{"steps", cost.steps}};
  io::set_number(document, "seconds", cost.seconds);
  io::set_number(document, "particle_steps", cost.particle_steps);
  return document;
}

Cost cost_of(Json const& document) {
  return {io::number_of(document, "seconds"), document.at("steps").get<long>(),
          io::number_of(document, "particle_steps")};
}

Json row_document(Row const& row) {
  Json document{{"subject", row.subject},
                {"measure", row.measure},
                {"unit", row.unit},
                {"allowed", interval_document(row.allowed)},
                {"uncertainty", interval_document(row.uncertainty)},
                {"verdict", word_of(row.verdict)},
                {"because", row.because},
                {"cost", cost_document(row.cost)}};
  io::set_number(document, "found", row.found);
  return document;
}

Row row_of(Json const& document) {
  return {document.at("subject"),
          document.at("measure"),
          document.at("unit"),
          io::number_of(document, "found"),
          interval_of(document.at("allowed")),
          interval_of(document.at("uncertainty")),
          verdict_named(document.at("verdict").get<std::string>()),
          document.at("because"),
          cost_of(document.at("cost"))};
}

Json points_document(std::vector<double> const& values) {
  Json document = Json::array();
  for (double const value : values) document.push_back(std::isfinite(value) ? Json(value) : Json());
  return document;
}

std::vector<double> points_of(Json const& document) {
  std::vector<double> values;
  for (Json const& value : document)
    values.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>());
  return values;
}

Json plot_document(Plot const& plot) {
  Json curves = Json::array();
  for (Curve const& c : plot.curves)
    curves.push_back({{"name", c.name}, {"x", points_document(c.x)}, {"y", points_document(c.y)}, {"guide", c.guide}});
  return {{"title", plot.title}, {"x_label", plot.x_label}, {"y_label", plot.y_label},
          {"log_x", plot.log_x}, {"log_y", plot.log_y},     {"curves", curves}};
}

Plot plot_of(Json const& document) {
  Plot plot{document.at("title"), document.at("x_label"), document.at("y_label"),
            document.at("log_x"), document.at("log_y"),   {}};
  for (Json const& c : document.at("curves"))
    plot.curves.push_back({c.at("name"), points_of(c.at("x")), points_of(c.at("y")), c.at("guide")});
  return plot;
}

Json work_document(WorkPoint const& point) {
  Json document{
      {"problem", point.problem},   {"error_name", point.error_name},       {"kernel", point.kernel},
      {"transfer", point.transfer}, {"per_direction", point.per_direction}, {"cost", cost_document(point.cost)}};
  io::set_number(document, "cells", point.cells);
  io::set_number(document, "error", point.error);
  return document;
}

WorkPoint work_of(Json const& document) {
  return {document.at("problem"),           document.at("error_name"),    document.at("kernel"),
          document.at("transfer"),          document.at("per_direction"), io::number_of(document, "cells"),
          io::number_of(document, "error"), cost_of(document.at("cost"))};
}

template <class Things, class Write>
Json list_of(Things const& things, Write const& write) {
  Json list = Json::array();
  for (auto const& thing : things) list.push_back(write(thing));
  return list;
}

Findings read_findings(Json const& document) {
  Findings findings;
  for (Json const& row : document.at("rows")) findings.rows.push_back(row_of(row));
  for (Json const& plot : document.at("plots")) findings.plots.push_back(plot_of(plot));
  for (Json const& point : document.at("work")) findings.work.push_back(work_of(point));
  return findings;
}

Json result_document(Result const& result) {
  Json document = document_of(result.findings);
  document.update({{"id", result.id},
                   {"title", result.title},
                   {"truth", result.truth},
                   {"source", result.source},
                   {"tier", result.tier},
                   {"green", is_green(totals(result.findings))},
                   {"seconds", result.seconds},
                   {"processor_seconds", result.processor_seconds},
                   {"peak_memory", result.peak_memory}});
  return document;
}

[[noreturn]] void refuse(Json::exception const& error) {
  throw InputError(std::string("this is no document of talus verify: ") + error.what());
}

}  // namespace

Json document_of(Findings const& findings) {
  return {{"rows", list_of(findings.rows, row_document)},
          {"plots", list_of(findings.plots, plot_document)},
          {"work", list_of(findings.work, work_document)}};
}

Findings findings_of(Json const& document) {
  try {
    return read_findings(document);
  } catch (Json::exception const& error) {
    refuse(error);
  }
}

Json document_of(std::vector<Result> const& results, Json const& provenance, double seconds, int jobs) {
  auto const all = totals(results);
  Json counts;
  for (std::size_t k = 0; k < all.size(); ++k) counts[std::string(word_of(static_cast<Verdict>(k)))] = all[k];
  return {{"schema", results_schema},
          {"provenance", provenance},
          {"green", is_green(all)},
          {"totals", counts},
          {"seconds", seconds},
          {"jobs", jobs},
          {"cases", list_of(results, result_document)}};
}

std::vector<Result> results_of(Json const& document) {
  try {
    if (document.at("schema") != results_schema)
      throw InputError("this is no document of talus verify: its schema is not " + std::string(results_schema));
    std::vector<Result> results;
    for (Json const& c : document.at("cases"))
      results.push_back({c.at("id"), c.at("title"), c.at("truth"), c.at("source"), c.at("tier"), read_findings(c),
                         c.at("seconds"), c.at("processor_seconds"), c.at("peak_memory")});
    return results;
  } catch (Json::exception const& error) {
    refuse(error);
  }
}

}  // namespace talus::verification
