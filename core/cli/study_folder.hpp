#pragma once
/// The folder of a study, of runs or of material points: who may write into it, and what is in it.

#include <filesystem>
#include <string_view>

#include "core/io/files.hpp"

namespace talus::cli {

/// A study's folder, held by one process at a time:
///
///   study.json resolved_study.json results.json results.csv  cases/case_000/ ...
class StudyFolder {
 public:
  /// Makes the folder, or takes an empty one. With `force` that of an earlier study is taken too, and what Talus wrote
  /// there is removed; other files stay. Throws FileError where the folder is not empty and not forced, is the folder
  /// of a run, is in use by another process, or cannot be written.
  [[nodiscard]] static StudyFolder create(std::filesystem::path const& path, bool force);

  /// Takes the folder of a study of runs, to go on with it; its results, which are of before, are removed. Throws
  /// FileError where it is in use, CheckpointError where nothing in it can be resumed.
  [[nodiscard]] static StudyFolder open(std::filesystem::path const& path);

  /// Whether a folder is that of a study, begun or only just.
  [[nodiscard]] static bool is_one(std::filesystem::path const& path);

  [[nodiscard]] std::filesystem::path const& path() const { return path_; }
  [[nodiscard]] std::filesystem::path case_folder(std::size_t number) const;
  /// The document as it ran, changes of the command line included.
  [[nodiscard]] std::filesystem::path as_run() const { return path_ / "resolved_study.json"; }

  /// Writes a file byte for byte, atomically. Throws FileError.
  void write(std::string_view name, std::string_view bytes) const { io::write_atomically(path_ / name, bytes); }

 private:
  StudyFolder(std::filesystem::path path, io::Descriptor lock) : path_(std::move(path)), lock_(std::move(lock)) {}

  std::filesystem::path path_;
  io::Descriptor lock_;
};

}  // namespace talus::cli
