#pragma once
/// The profiles of a run's stations, as pages of curves.

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/curve_page.hpp"

namespace talus::io {

/// A page for each file below `profiles/`: flow velocity over height, at up to `instants` times at about equal distances,
/// of those at which the station was not empty. Files without such a time give none. Throws FileError.
[[nodiscard]] std::vector<CurvePage> profile_pages(std::filesystem::path const& run_folder, std::string const& title,
                                                   int instants);

}  // namespace talus::io
