#pragma once
/// Results as pictures, drawn by gnuplot.

#include <filesystem>
#include <string>
#include <vector>

#include "benchmarks/report/result.hpp"

namespace talus::bench {

/// Draws each chart into a folder as <name>.png and <name>.svg; the script pictures.gp stays there. Returns why there
/// are none, for people; nothing where all is well. Throws FileError.
[[nodiscard]] std::string draw_charts(std::filesystem::path const& folder, std::vector<Chart> const& charts);

}  // namespace talus::bench
