#include "core/io/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

namespace talus::io {

namespace fs = std::filesystem;

namespace {

Descriptor open_file(fs::path const& path, int flags, std::string_view what_failed) {
  int number = -1;
  do number = ::open(path.c_str(), flags | O_CLOEXEC, 0666);
  while (number < 0 && errno == EINTR);
  if (number < 0) throw file_error(what_failed, path);
  return Descriptor(number);
}

void write_all(int file, std::string_view bytes, fs::path const& path) {
  while (!bytes.empty()) {
    auto const written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw file_error("cannot write", path);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// Devices and pipes cannot be synced and need not be.
void sync_descriptor(int file, fs::path const& path) {
  int result = -1;
  do result = ::fsync(file);
  while (result != 0 && errno == EINTR);
  if (result != 0 && errno != EINVAL && errno != EROFS) throw file_error("cannot write to the disk", path);
}

fs::path folder_of(fs::path const& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

}  // namespace

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

int Descriptor::release() {
  return std::exchange(number_, -1);
}

FileError file_error(std::string_view what_failed, fs::path const& path) {
  auto const reason = std::generic_category().message(errno);
  return FileError(fmt::format("{} {}: {}", what_failed, path.string(), reason));
}

std::string read_file(fs::path const& path) {
  auto const file = open_file(path, O_RDONLY, "cannot read");
  std::string bytes;
  std::array<char, 1 << 16> buffer;
  for (;;) {
    auto const count = ::read(file.number(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw file_error("cannot read", path);
    if (count == 0) return bytes;
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

void sync_folder(fs::path const& folder) {
  auto const file = open_file(folder, O_RDONLY | O_DIRECTORY, "cannot open the folder");
  sync_descriptor(file.number(), folder);
}

void make_folder(fs::path const& folder, std::string_view mark) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw FileError("cannot make the folder " + folder.string() + ": " + error.message());
  if (!mark.empty() && fs::exists(folder / mark))
    throw FileError(folder.string() + " holds results already; name another folder");
}

PendingFile::PendingFile(fs::path path)
    : path_(std::move(path)),
      temporary_(path_.string() + ".tmp"),
      file_(open_file(temporary_, O_WRONLY | O_CREAT | O_TRUNC, "cannot make the file")) {}

PendingFile::~PendingFile() {
  if (file_.number() >= 0) ::unlink(temporary_.c_str());
}

void PendingFile::write(std::string_view bytes) {
  write_all(file_.number(), bytes, temporary_);
}

void PendingFile::commit() {
  sync_descriptor(file_.number(), temporary_);
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) throw file_error("cannot put in place the file", path_);
  if (::close(file_.release()) != 0) throw file_error("cannot close", path_);
  sync_folder(folder_of(path_));
}

void write_atomically(fs::path const& path, std::string_view bytes) {
  PendingFile file(path);
  file.write(bytes);
  file.commit();
}

GrowingFile::GrowingFile(fs::path path)
    : path_(std::move(path)), file_(open_file(path_, O_WRONLY | O_CREAT | O_APPEND, "cannot write")) {}

GrowingFile::GrowingFile(fs::path path, std::uintmax_t keep) : GrowingFile(std::move(path)) {
  struct stat status {};
  if (::fstat(file_.number(), &status) != 0) throw file_error("cannot read", path_);
  if (static_cast<std::uintmax_t>(status.st_size) < keep)
    throw FileError(
        fmt::format("{} holds {} bytes, but should hold at least {}", path_.string(), status.st_size, keep));
  if (static_cast<std::uintmax_t>(status.st_size) > keep && ::ftruncate(file_.number(), static_cast<off_t>(keep)) != 0)
    throw file_error("cannot shorten", path_);
}

void GrowingFile::append(std::string_view bytes) {
  write_all(file_.number(), bytes, path_);
}

void GrowingFile::sync() {
  sync_descriptor(file_.number(), path_);
}

}  // namespace talus::io
