#pragma once
/// Results for people, as one file that a browser shows.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "benchmarks/report/result.hpp"

namespace talus::bench {

/// The page report.html: tables, the charts as they lie in `folder` in SVG, and the provenance. Nothing else is loaded.
[[nodiscard]] std::string page_of(std::vector<Measured> const&, nlohmann::json const& provenance,
                                  std::filesystem::path const& folder);

}  // namespace talus::bench
