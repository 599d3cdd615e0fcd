#pragma once
/// The folder of a study, of runs or of material points: who may write into it, and what is in it.

#include <filesystem>
#include <string>
#include <string_view>

#include "core/config/json.hpp"
#include "core/io/files.hpp"

namespace talus::cli {

/// A study's folder, held by one process at a time:
///
///   resolved_study.json study.json results.json results.csv  cases/case_000/ ...
///
/// and of points provenance.json and plots/.
class StudyFolder {
 public:
  /// Makes the folder, or takes an empty one, and writes the document: as it runs, and as it was given. With `force`
  /// that of an earlier study or point is taken too, and what Talus wrote there is removed; other files stay. Throws
  /// FileError where the folder is not empty and not forced, is another's, is in use by another process, or cannot be
  /// written; then nothing was removed.
  [[nodiscard]] static StudyFolder create(std::filesystem::path const& path, bool force, Document const& document,
                                          std::string_view given);

  /// Takes the folder of a study, to go on with it. Throws FileError where it is in use.
  [[nodiscard]] static StudyFolder open(std::filesystem::path const& path);

  /// Whether a folder is that of a study or point.
  [[nodiscard]] static bool is_one(std::filesystem::path const& path);

  [[nodiscard]] std::filesystem::path const& path() const { return path_; }
  /// The folder of a case, below the study's.
  [[nodiscard]] static std::string case_folder(std::size_t number);
  /// The document as it ran, changes of the command line included. Throws InputError, FileError.
  [[nodiscard]] Document document() const;

  /// Writes a file byte for byte, atomically. Throws FileError.
  void write(std::string_view name, std::string_view bytes) const { io::write_atomically(path_ / name, bytes); }
  /// Takes away results that cases have gone beyond.
  void remove_results() const;

 private:
  StudyFolder(std::filesystem::path path, io::Descriptor lock) : path_(std::move(path)), lock_(std::move(lock)) {}

  std::filesystem::path path_;
  io::Descriptor lock_;
};

}  // namespace talus::cli
