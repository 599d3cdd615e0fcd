#include "core/cli/study_folder.hpp"

#include <fmt/format.h>

#include <regex>
#include <vector>

#include "core/errors.hpp"
#include "core/io/run_folder.hpp"

namespace talus::cli {

namespace fs = std::filesystem;

namespace {

/// Removes the files of these names, and what a kill leaves of them.
void remove_files(fs::path const& folder, std::initializer_list<std::string_view> names) {
  for (std::string_view const name : names)
    for (std::string_view const ending : {"", ".tmp"}) fs::remove(folder / fmt::format("{}{}", name, ending));
}

void remove_cases(fs::path const& cases) {
  static std::regex const of_a_case("case_\\d{3,}");
  std::vector<fs::path> found;
  if (fs::is_directory(fs::symlink_status(cases)))
    for (auto const& entry : fs::directory_iterator(cases))
      if (entry.is_directory() && std::regex_match(entry.path().filename().string(), of_a_case))
        found.push_back(entry.path());
  for (fs::path const& folder : found) io::remove_run(folder);
}

}  // namespace

StudyFolder StudyFolder::create(fs::path const& path, bool force) try {
  fs::create_directories(path);
  StudyFolder folder(path, io::lock_folder(path));
  if (fs::exists(path / "status.json"))
    throw FileError(fmt::format("{} is the folder of a run; give another folder", path.string()));
  if (!force && !fs::is_empty(path))
    throw FileError(fmt::format("{} is not empty; give another folder or --force", path.string()));
  remove_files(path, {"results.json", "results.csv", "resolved_study.json"});
  remove_cases(path / "cases");
  fs::create_directories(path / "cases");
  return folder;
} catch (fs::filesystem_error const& error) {
  throw FileError(fmt::format("cannot make the folder {}: {}", path.string(), error.code().message()));
}

StudyFolder StudyFolder::open(fs::path const& path) {
  StudyFolder folder(path, io::lock_folder(path));
  if (!fs::exists(folder.as_run()))
    throw CheckpointError(
        fmt::format("there is nothing to resume in {}: it is the folder of a material point, or of a study that was "
                    "stopped before it began; run its document again with --force",
                    path.string()));
  remove_files(path, {"results.json", "results.csv"});
  return folder;
}

bool StudyFolder::is_one(fs::path const& path) {
  return !fs::exists(path / "status.json") &&
         (fs::exists(path / "resolved_study.json") || fs::exists(path / "study.json"));
}

fs::path StudyFolder::case_folder(std::size_t number) const {
  return path_ / "cases" / fmt::format("case_{:03}", number);
}

}  // namespace talus::cli
