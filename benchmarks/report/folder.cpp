#include "benchmarks/report/folder.hpp"

#include <nlohmann/json.hpp>

#include "benchmarks/registry.hpp"
#include "benchmarks/report/charts.hpp"
#include "benchmarks/report/page.hpp"
#include "core/io/files.hpp"
#include "core/io/provenance.hpp"
#include "core/io/text.hpp"

namespace talus::bench {

nlohmann::json provenance(std::vector<std::string> const& command_line, std::string const& start, int threads) {
  return io::provenance_document(
      {.command_line = command_line, .threads = threads, .inputs = {}, .start = start, .end = io::utc_now()});
}

void write_folder(std::filesystem::path const& folder, std::vector<Measured> const& all,
                  nlohmann::json const& document) {
  io::write_atomically(folder / "results.json", io::json_text(document));
  std::vector<Chart> charts;
  for (Measured const& measured : all)
    charts.insert(charts.end(), measured.result.charts.begin(), measured.result.charts.end());
  if (auto const trouble = draw_charts(folder, charts); !trouble.empty()) say("no pictures: " + trouble);
  io::write_atomically(folder / "report.html", page_of(all, document.at("provenance"), folder));
}

}  // namespace talus::bench
