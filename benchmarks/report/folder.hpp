#pragma once
/// The folder of a run of benchmarks.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "benchmarks/report/document.hpp"

namespace talus::bench {

/// Program, build, machine and command. `start` in UTC.
[[nodiscard]] nlohmann::json provenance(std::vector<std::string> const& command_line, std::string const& start,
                                        int threads);

/// Writes results.json, the pictures, and report.html. `document`: of document_of. Throws FileError.
void write_folder(std::filesystem::path const& folder, std::vector<Measured> const&, nlohmann::json const& document);

}  // namespace talus::bench
