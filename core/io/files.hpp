#pragma once
/// Files that a kill or a full disk cannot leave half written.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/errors.hpp"

namespace talus::io {

/// An open file, closed at the end of its life. For the classes below.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor();
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] int release();

 private:
  int number_;
};

/// The error of the last system call on `path`: "cannot write out/series.csv: No space left on device".
[[nodiscard]] FileError file_error(std::string_view what_failed, std::filesystem::path const& path);

/// All bytes of a file. Throws FileError.
[[nodiscard]] std::string read_file(std::filesystem::path const& path);

/// Makes a folder's entries (new, renamed and removed files) survive a power cut. Throws FileError.
void sync_folder(std::filesystem::path const& folder);

/// Makes a folder for results unless it is there. Throws FileError where that fails, or where the folder holds the file
/// `mark`, which tells that results are in it already; an empty mark asks for nothing.
void make_folder(std::filesystem::path const& folder, std::string_view mark);

/// A file that appears under its name only when it is complete: bytes go to `<name>.tmp` in the same folder, `commit`
/// syncs and renames it. Without `commit` the old file stays and the temporary one is removed.
class PendingFile {
 public:
  /// Throws FileError where the folder is missing or not writable.
  explicit PendingFile(std::filesystem::path path);
  PendingFile(PendingFile const&) = delete;
  PendingFile& operator=(PendingFile const&) = delete;
  ~PendingFile();
  /// Throws FileError (disk full, ...).
  void write(std::string_view bytes);
  void write(void const* data, std::size_t size) { write({static_cast<char const*>(data), size}); }
  /// Puts the file in place, whatever was there before. Throws FileError.
  void commit();

 private:
  std::filesystem::path path_, temporary_;
  Descriptor file_;
};

/// Writes a whole file so that its name always leads to the old or to the new content. Throws FileError.
void write_atomically(std::filesystem::path const& path, std::string_view bytes);

/// A file that grows at its end, made if it is not there.
class GrowingFile {
 public:
  /// Goes on at the end of the file. Throws FileError.
  explicit GrowingFile(std::filesystem::path path);
  /// Keeps the first `keep` bytes of the file and goes on behind them. Throws FileError, also where the file is shorter
  /// than that.
  GrowingFile(std::filesystem::path path, std::uintmax_t keep);
  /// Hands the bytes to the system at once. Throws FileError (disk full, ...).
  void append(std::string_view bytes);
  /// Waits until all that was appended is on the disk. Throws FileError.
  void sync();

 private:
  std::filesystem::path path_;
  Descriptor file_;
};

}  // namespace talus::io
