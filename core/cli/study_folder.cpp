#include "core/cli/study_folder.hpp"

#include <fmt/format.h>

#include <regex>
#include <system_error>
#include <vector>

#include "core/config/json.hpp"
#include "core/io/run_folder.hpp"

namespace talus::cli {

namespace fs = std::filesystem;

namespace {

constexpr char const* as_run = "resolved_study.json";  // the first file of a study; it marks the folder as one

bool is_there(fs::path const& path) {
  std::error_code unknown;
  return fs::exists(path, unknown);
}

/// Nothing, or what a kill leaves of a study that had only just begun: the mark, with another ending behind its name.
bool holds_nothing(fs::path const& path) {
  for (auto const& entry : fs::directory_iterator(path))
    if (entry.path().stem() != as_run) return false;
  return true;
}

/// Whether a folder bears the mark of a study or point.
bool is_marked(fs::path const& path) try {
  auto const document = parse(io::read_file(path / as_run), as_run).value;
  auto const schema = document.value("schema", "");
  return schema.starts_with("talus/study/") || schema.starts_with("talus/point/");
} catch (std::exception const&) {  // no such file, or another's
  return false;
}

/// Folders of cases. Throws FileError where one is in use or a link to elsewhere, so that none is cleared then.
std::vector<fs::path> cases_in(fs::path const& path) {
  static std::regex const of_a_case("case_\\d{3,}");
  std::vector<fs::path> found;
  for (fs::path const below : {"cases", "plots"})
    if (fs::is_symlink(path / below))
      throw FileError(fmt::format("{} is a link: will not clear it", (path / below).string()));
  if (!is_there(path / "cases")) return found;
  for (auto const& entry : fs::directory_iterator(path / "cases"))
    if (entry.is_directory() && std::regex_match(entry.path().filename().string(), of_a_case))
      found.push_back(entry.path());
  for (fs::path const& folder : found) {
    if (fs::is_symlink(folder)) throw FileError(fmt::format("{} is a link: will not clear it", folder.string()));
    static_cast<void>(io::lock_folder(folder));
  }
  return found;
}

/// Removes what Talus wrote into the folder of a study, but for its mark.
void clear(fs::path const& path) {
  static std::regex const ours(
      R"(((study|results|provenance)\.json|results\.csv|plots/(pictures\.(gp|log)|\w+\.(png|svg)|end_\w+\.csv))(\.tmp)?)");
  for (fs::path const& folder : cases_in(path)) io::remove_run(folder);
  std::vector<fs::path> found;
  for (fs::path const below : {"", "plots"})
    if (is_there(path / below))
      for (auto const& entry : fs::directory_iterator(path / below))
        if (!entry.is_directory() && std::regex_match((below / entry.path().filename()).string(), ours))
          found.push_back(entry.path());
  for (fs::path const& file : found) fs::remove(file);
}

}  // namespace

StudyFolder StudyFolder::create(fs::path const& path, bool force, Document const& document,
                                std::string_view given) try {
  fs::create_directories(path);
  StudyFolder folder(path, io::lock_folder(path));
  if (!holds_nothing(path)) {
    if (!force) throw FileError(fmt::format("{} is not empty; give another folder or --force", path.string()));
    if (!is_marked(path))
      throw FileError(
          fmt::format("{} is not empty and not the folder of a study or point (it has no {} of Talus); give another",
                      path.string(), as_run));
    clear(path);
  }
  folder.write(as_run, document.value.dump(2) + "\n");
  folder.write("study.json", given);
  fs::create_directories(path / "cases");
  return folder;
} catch (fs::filesystem_error const& error) {
  throw FileError(fmt::format("cannot take the folder {}: {}", path.string(), error.code().message()));
}

StudyFolder StudyFolder::open(fs::path const& path) {
  return {path, io::lock_folder(path)};
}

bool StudyFolder::is_one(fs::path const& path) {
  return is_there(path / as_run);
}

Document StudyFolder::document() const {
  return parse(io::read_file(path_ / as_run), (path_ / as_run).string());
}

void StudyFolder::remove_results() const {
  for (auto const* name : {"results.json", "results.csv"}) fs::remove(path_ / name);
}

std::string StudyFolder::case_folder(std::size_t number) {
  return fmt::format("cases/case_{:03}", number);
}

}  // namespace talus::cli
