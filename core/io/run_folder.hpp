#pragma once
/// The folder of a run: who may write into it, what is in it, how it stands.

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/files.hpp"
#include "core/io/vtu.hpp"

namespace talus::io {

/// How a run stands, or how it ended.
enum class Outcome { running, done, failed, stopped };

/// The contents of status.json. Time [s] and step are the last that were reached; no exit code while it runs.
struct Status {
  Outcome outcome = Outcome::running;
  std::optional<int> exit_code;
  double time = 0;
  std::int64_t step = 0;
};

/// A run's folder, held by one process at a time:
///
///   case.json resolved.json provenance.json status.json summary.json series.csv log.txt report.html
///   frames.pvd  frames/f_000000.vtu ...  profiles/STATION.csv ...  checkpoints/ck_000000000000.h5 ...  plots/
///
/// Every file but series.csv, profiles and log.txt, which grow, is replaced as a whole: a kill at any moment leaves a usable
/// folder.
class RunFolder {
 public:
  /// Makes the folder, or takes an empty one. With `force` an earlier run's folder is taken too, and what Talus wrote
  /// there is removed; other files stay. Throws FileError where the folder is not empty and not forced, is not the
  /// folder of a run, is in use by another process, or cannot be written.
  [[nodiscard]] static RunFolder create(std::filesystem::path const& path, bool force);

  /// Takes the folder of an earlier run, to go on with it. Throws FileError where it is none, or in use.
  [[nodiscard]] static RunFolder open(std::filesystem::path const& path);

  [[nodiscard]] std::filesystem::path const& path() const { return path_; }
  [[nodiscard]] std::filesystem::path frames() const { return path_ / "frames"; }
  [[nodiscard]] std::filesystem::path checkpoints() const { return path_ / "checkpoints"; }
  [[nodiscard]] std::filesystem::path series() const { return path_ / "series.csv"; }
  [[nodiscard]] std::filesystem::path frame_list() const { return path_ / "frames.pvd"; }

  /// The file of a station's profiles; makes its folder. Throws FileError.
  [[nodiscard]] std::filesystem::path profile(std::string_view station) const;

  /// Writes a file byte for byte (case.json, report.html), atomically. Throws FileError.
  void write(std::string_view name, std::string_view bytes) const;
  void write(std::string_view name, std::string const& bytes) const { write(name, std::string_view(bytes)); }
  /// Writes a document (resolved.json, provenance.json, summary.json), atomically. Throws FileError.
  void write(std::string_view name, nlohmann::json const& document) const;
  void write_status(Status const& status) const;

  /// Writes the next frame and the list with it; `frames` holds those so far. Throws FileError.
  void add_frame(Snapshot const& snapshot, std::vector<Frame>& frames) const;

  /// Adds a line to log.txt, with the time in UTC before it. Throws FileError.
  void log(std::string_view line);

 private:
  RunFolder(std::filesystem::path path, Descriptor lock);

  std::filesystem::path path_;
  Descriptor lock_;
  GrowingFile log_;
};

/// Takes a folder for this process. The lock goes with the descriptor, and so with the process, however it ends. Throws
/// FileError where another process has it.
[[nodiscard]] Descriptor lock_folder(std::filesystem::path const& path);

/// Removes what Talus wrote into a folder, whole or not, and the folder where nothing else is in it; else status.json
/// stays, so that a run may take the folder. Throws FileError, also where it is a link or in use.
void remove_run(std::filesystem::path const& path);

/// How the run in a folder stands. Throws FileError where it is not the folder of a run.
[[nodiscard]] Status read_status(std::filesystem::path const& run_folder);

}  // namespace talus::io
