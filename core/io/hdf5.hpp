#pragma once
/// What a checkpoint needs of the HDF5 C library: handles that close themselves, calls that throw.

#include <hdf5.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace talus::io::hdf5 {

/// A call of the library failed; the message is the library's own.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Keeps the library from printing its errors as long as it lives.
class Silence {
 public:
  Silence();
  Silence(Silence const&) = delete;
  Silence& operator=(Silence const&) = delete;
  ~Silence();

 private:
  H5E_auto2_t print_ = nullptr;
  void* argument_ = nullptr;
};

/// Throws Error with the library's description where `result` is negative.
void check(std::int64_t result, std::string_view what);

/// Owns an object of the library.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  /// Takes over what a call returned. Throws Error where the call failed.
  Handle(hid_t id, Close close, std::string_view what);
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle();
  operator hid_t() const { return id_; }  // NOLINT: it stands for the id in every call

 private:
  hid_t id_;
  Close close_;
};

/// An empty file in memory.
[[nodiscard]] Handle new_file();
/// A file in memory that holds the bytes of an HDF5 file.
[[nodiscard]] Handle open_image(std::string_view bytes);
/// The bytes of a file in memory as they would lie on the disk, behind `room` bytes left free.
[[nodiscard]] std::string image_of(Handle const& file, std::size_t room);

/// A group whose members keep the order in which they were made.
[[nodiscard]] Handle new_group(hid_t parent, std::string const& name);
[[nodiscard]] Handle open_group(hid_t parent, std::string const& name);
/// Names of a group's members, in the order in which they were made.
[[nodiscard]] std::vector<std::string> members(hid_t group);
[[nodiscard]] Handle open_data(hid_t group, std::string const& name);

/// Attributes hold one value each.
void write_attribute(hid_t object, std::string const& name, std::int64_t value);
void write_attribute(hid_t object, std::string const& name, double value);
void write_attribute(hid_t object, std::string const& name, std::string const& value);
void read_attribute(hid_t object, std::string const& name, std::int64_t& value);
void read_attribute(hid_t object, std::string const& name, double& value);
void read_attribute(hid_t object, std::string const& name, std::string& value);

/// What one entry of a data set is.
enum class Kind { number, integer, text };
[[nodiscard]] Kind kind_of(hid_t data);

/// Lengths of a data set along its axes: none for a single value.
using Extent = std::vector<hsize_t>;
[[nodiscard]] Extent extent_of(hid_t data);
/// How many entries that makes.
[[nodiscard]] std::size_t count_of(Extent const& extent);

/// Makes a data set in one block.
[[nodiscard]] Handle write_data(hid_t group, std::string const& name, Extent const& extent, double const* values);
[[nodiscard]] Handle write_data(hid_t group, std::string const& name, Extent const& extent, std::int64_t const* values);
/// Texts without NUL, each stored as long as the longest.
[[nodiscard]] Handle write_data(hid_t group, std::string const& name, Extent const& extent, std::string const* values);
/// Makes a data set in chunks along its first axis; each is shuffled, packed (deflate 1) and guarded by a Fletcher-32
/// sum.
[[nodiscard]] Handle write_packed(hid_t group, std::string const& name, Extent const& extent, double const* values);

/// All entries of a data set of that kind.
void read_data(hid_t data, std::vector<double>& values);
void read_data(hid_t data, std::vector<std::int64_t>& values);
void read_data(hid_t data, std::vector<std::string>& values);

}  // namespace talus::io::hdf5
