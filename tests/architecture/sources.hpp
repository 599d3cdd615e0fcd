#pragma once
/// The project's own source files, as the tests in this folder read them.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace talus::architecture {

/// A file: its path from the project's root, with slashes, and its lines.
struct Source {
  std::string path;
  std::vector<std::string> lines;
};

/// What an #include names, without its quotes or brackets.
struct Include {
  std::string target;
  bool quoted;
};

/// The project's root: the variable TALUS_SOURCE_DIR, which ctest sets, else the working directory.
inline std::filesystem::path project_root() {
  char const* const given = std::getenv("TALUS_SOURCE_DIR");
  return given != nullptr ? std::filesystem::path(given) : std::filesystem::current_path();
}

inline Source read_source(std::string const& path) {
  std::ifstream file(project_root() / path);
  if (!file) throw std::runtime_error("cannot read " + path);
  Source source{path, {}};
  for (std::string line; std::getline(file, line);) source.lines.push_back(line);
  return source;
}

/// Every header and translation unit of the project, sorted by path.
inline std::vector<Source> read_sources() {
  std::vector<std::string> paths;
  for (char const* const folder : {"core", "models", "verification", "benchmarks", "tests"})
    for (auto const& entry : std::filesystem::recursive_directory_iterator(project_root() / folder))
      if (auto const extension = entry.path().extension(); extension == ".hpp" || extension == ".cpp")
        paths.push_back(entry.path().lexically_relative(project_root()).generic_string());
  std::sort(paths.begin(), paths.end());
  std::vector<Source> sources;
  for (auto const& path : paths) sources.push_back(read_source(path));
  return sources;
}

inline std::vector<Include> includes_of(Source const& source) {
  static std::regex const pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<Include> includes;
  for (std::smatch found; auto const& line : source.lines)
    if (std::regex_search(line, found, pattern)) includes.push_back({found[2], found[1] == "\""});
  return includes;
}

/// Headers of the policies that models/catalogue.cmake lists.
inline std::vector<std::string> listed_policies() {
  static std::regex const pattern(R"(^\s*talus_catalogue\(.*\s(\S+\.hpp)\s*\))");
  std::vector<std::string> headers;
  for (std::smatch found; auto const& line : read_source("models/catalogue.cmake").lines)
    if (std::regex_search(line, found, pattern)) headers.push_back(found[1]);
  return headers;
}

/// What a test that expects no fault compares with "": every fault on a line of its own.
inline std::string joined(std::vector<std::string> const& faults) {
  std::string text;
  for (auto const& fault : faults) text += "\n" + fault;
  return text;
}

/// The first folder of a path: "core" of "core/io/vtu.hpp".
inline std::string first_folder(std::string const& path) {
  return path.substr(0, path.find('/'));
}

/// The folder of a file: "core/io" of "core/io/vtu.hpp".
inline std::string folder_of(std::string const& path) {
  return path.substr(0, path.rfind('/'));
}

inline bool is_below(std::string_view path, std::string_view folder) {
  return path.starts_with(folder) && path.substr(folder.size()).starts_with('/');
}

inline bool is_below_any(std::string_view path, std::vector<std::string_view> const& folders) {
  return std::any_of(folders.begin(), folders.end(), [&](auto folder) { return is_below(path, folder); });
}

}  // namespace talus::architecture
