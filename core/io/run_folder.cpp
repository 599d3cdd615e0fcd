#include "core/io/run_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <limits>
#include <regex>
#include <system_error>

#include "core/config/json.hpp"
#include "core/io/text.hpp"

namespace talus::io {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view status_schema = "talus/status/1";
constexpr std::array<std::string_view, 4> outcome_names{"running", "done", "failed", "stopped"};
constexpr std::array<char const*, 3> subfolders{"frames", "checkpoints", "plots"};  // every run has them
constexpr char const* profiles = "profiles";                                        // one with stations
constexpr std::array<char const*, 5> everywhere{"frames", "checkpoints", "plots", profiles, ""};

/// The names, relative to the folder, of the files that Talus writes into it, and of what a kill leaves of them.
/// Without status.json, which marks the folder as a run's: it is replaced, never removed.
bool is_ours(std::string const& name) {
  static std::regex const ours(
      R"(((case|resolved|provenance|summary)\.json|series\.csv|log\.txt|report\.html|frames\.pvd)"
      R"(|frames/f_\d{6,}\.vtu|checkpoints/ck_\d{12,}\.h5|profiles/\w+\.csv)"
      R"(|plots/(particles(_side|_last)?|motion|profile_\w+)\.(png|svg))"
      R"(|plots/pictures\.(gp|log)|plots/(side|oblique)_\d{6,}\.dat)(\.tmp)?)");
  return std::regex_match(name, ours);
}

void make_folder(fs::path const& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw FileError("cannot make the folder " + path.string() + ": " + error.message());
}

/// Nothing, or what a kill leaves of a run that had only just begun.
bool holds_nothing(fs::path const& path) {
  std::error_code error;
  for (auto const& entry : fs::directory_iterator(path, error))
    if (entry.path().filename() != "status.json.tmp") return false;
  if (error) throw FileError("cannot read the folder " + path.string() + ": " + error.message());
  return true;
}

/// Removes our files that end so from `path / below`, never through a link to elsewhere: a folder that should be empty
/// must not be one, rests may stay.
void clear(fs::path const& path, std::string const& below, std::string_view ending) {
  if (!fs::exists(path / below)) return;
  if (fs::is_symlink(path / below)) {
    if (!ending.empty()) return;
    throw FileError((path / below).string() + " is a link: will not clear it");
  }
  std::vector<fs::path> found;
  for (auto const& entry : fs::directory_iterator(path / below))
    if (auto const name = entry.path().filename().string();
        !entry.is_directory() && name.ends_with(ending) && is_ours((below.empty() ? "" : below + "/") + name))
      found.push_back(entry.path());
  for (auto const& file : found) fs::remove(file);
}

/// Removes our files that end so from the folder of a run.
void clear_run(fs::path const& path, std::string_view ending) {
  static_cast<void>(read_status(path));  // throws where this is not the folder of a run
  try {
    for (std::string const below : everywhere) clear(path, below, ending);
  } catch (fs::filesystem_error const& error) {
    throw FileError("cannot clear the folder " + path.string() + ": " + error.code().message());
  }
}

void put_status(fs::path const& path, Status const& status) {
  nlohmann::json document = {{"schema", status_schema},
                             {"status", outcome_names[static_cast<std::size_t>(status.outcome)]},
                             {"exit_code", nullptr},
                             {"step", status.step},
                             {"written", utc_now()}};
  if (status.exit_code) document["exit_code"] = *status.exit_code;
  set_number(document, "time", status.time);
  write_atomically(path / "status.json", json_text(document));
}

}  // namespace

Descriptor lock_folder(fs::path const& path) {
  Descriptor folder(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.number() < 0) throw file_error("cannot open the folder", path);
  if (::flock(folder.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw FileError("another process is at work in the folder " + path.string());
  return folder;
}

void remove_run(fs::path const& path) {
  if (fs::is_symlink(path)) throw FileError(path.string() + " is a link: will not clear it");
  auto const held = lock_folder(path);
  try {
    for (std::string const below : everywhere) clear(path, below, "");
    std::error_code kept;  // what holds other files
    for (auto const* name : subfolders) fs::remove(path / name, kept);
    fs::remove(path / profiles, kept);
    for (auto const& entry : fs::directory_iterator(path))
      if (auto const name = entry.path().filename(); name != "status.json" && name != "status.json.tmp") return;
    for (auto const* name : {"status.json", "status.json.tmp", ""}) fs::remove(path / name);
  } catch (fs::filesystem_error const& error) {
    throw FileError("cannot clear the folder " + path.string() + ": " + error.code().message());
  }
}

RunFolder::RunFolder(fs::path path, Descriptor lock)
    : path_(std::move(path)), lock_(std::move(lock)), log_(path_ / "log.txt") {}

RunFolder RunFolder::create(fs::path const& path, bool force) {
  make_folder(path);
  auto held = lock_folder(path);
  if (!holds_nothing(path)) {
    if (!force)
      throw FileError("the folder " + path.string() + " is not empty; choose another, or replace its run with --force");
    clear_run(path, "");
  }
  put_status(path, {});
  RunFolder folder(path, std::move(held));
  for (auto const* name : subfolders) make_folder(path / name);
  sync_folder(path);
  return folder;
}

RunFolder RunFolder::open(fs::path const& path) {
  static_cast<void>(read_status(path));  // throws where this is not the folder of a run
  auto held = lock_folder(path);
  clear_run(path, ".tmp");  // what a kill left half written
  RunFolder folder(path, std::move(held));
  for (auto const* name : subfolders) make_folder(path / name);
  return folder;
}

fs::path RunFolder::profile(std::string_view station) const {
  make_folder(path_ / profiles);
  return path_ / profiles / (std::string(station) + ".csv");
}

void RunFolder::write(std::string_view name, std::string_view bytes) const {
  write_atomically(path_ / name, bytes);
}

void RunFolder::write(std::string_view name, nlohmann::json const& document) const {
  write_atomically(path_ / name, json_text(document));
}

void RunFolder::write_status(Status const& status) const {
  put_status(path_, status);
}

void RunFolder::add_frame(Snapshot const& snapshot, std::vector<Frame>& frames) const {
  auto const file = fmt::format("frames/f_{:06}.vtu", frames.size());
  write_vtu(path_ / file, snapshot);
  frames.push_back({snapshot.time, file});
  write_frame_list(frame_list(), frames);
}

void RunFolder::log(std::string_view line) {
  log_.append(fmt::format("{} {}\n", utc_now(), line));
}

Status read_status(fs::path const& run_folder) {
  auto const foreign = FileError(run_folder.string() + " is not the folder of a run: it has no status.json of Talus");
  auto const file = run_folder / "status.json";
  if (std::error_code error; !fs::is_regular_file(file, error)) throw foreign;
  try {
    auto const document = json_of(read_file(file));
    auto const found = std::ranges::find(outcome_names, document.at("status").get<std::string>());
    if (document.at("schema") != status_schema || found == outcome_names.end()) throw foreign;
    Status status;
    status.outcome = static_cast<Outcome>(found - outcome_names.begin());
    if (auto const& code = document.at("exit_code"); !code.is_null()) status.exit_code = code.get<int>();
    auto const& time = document.at("time");
    status.time = time.is_null() ? std::numeric_limits<double>::quiet_NaN() : time.get<double>();
    status.step = document.at("step").get<std::int64_t>();
    return status;
  } catch (nlohmann::json::exception const&) {
    throw foreign;
  }
}

}  // namespace talus::io
