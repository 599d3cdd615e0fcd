#include <fmt/format.h>

#include <filesystem>

#include "core/io/files.hpp"
#include "core/io/text.hpp"
#include "verification/report/page_parts.hpp"
#include "verification/report/report.hpp"
#include "verification/suite/document.hpp"

namespace talus::verification {

namespace {

/// The document as it may stand in a script element: nothing in it can end the element.
std::string embedded(nlohmann::json const& document) {
  auto const json = document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  std::string text;
  for (char const c : json) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

void put(std::string& page, std::string_view place, std::string_view text) {
  page.replace(page.find(place), place.size(), text);
}

}  // namespace

nlohmann::json document_of(Report const& report) {
  auto document = document_of(report.results, report.provenance, report.seconds, report.jobs);
  if (report.against) document["against"] = document_of(*report.against);
  return document;
}

std::string page_of(Report const& report) {
  std::string page(page_template);
  put(page, "/* the style */", page_style);
  put(page, "/* the script */", page_script);
  put(page, "{\"the\": \"results\"}", embedded(document_of(report)));
  return page;
}

void write_folder(std::string const& folder, Report const& report) {
  std::filesystem::path const path(folder);
  io::write_atomically(path / "results.csv", csv_of(report));
  io::write_atomically(path / "junit.xml", junit_of(report));
  io::write_atomically(path / "report.md", markdown_of(report));
  io::write_atomically(path / "report.html", page_of(report));
  io::write_atomically(path / "results.json", io::json_text(document_of(report)));
}

}  // namespace talus::verification
