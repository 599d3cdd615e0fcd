#pragma once
/// Checkpoints: all that a run needs to go on with the same bits, in one HDF5 file that guards itself.
///
/// The file: 512 bytes of text (what it is, length and SHA-256 of the rest: HDF5's user block), then HDF5:
///   attributes time [s], step, dimension
///   particles/<field>   n or n x components doubles in storage order; attributes components, symbol, unit, meaning
///   values/<name>       integers, numbers and texts, single or in a list
/// h5py, h5dump and other readers of HDF5 open it as it is.

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "core/errors.hpp"
#include "core/io/snapshot.hpp"

namespace talus::io {

/// What a checkpoint may hold under a name besides the particles. Texts hold no NUL.
using CheckpointValue = std::variant<std::int64_t, double, std::string, std::vector<std::int64_t>, std::vector<double>,
                                     std::vector<std::string>>;

/// The state of a run between two steps.
struct Checkpoint {
  Snapshot particles;
  std::map<std::string, CheckpointValue> values;

  /// The value of that name and kind. Throws CheckpointError where there is none.
  template <class T>
  [[nodiscard]] T const& value(std::string const& name) const {
    auto const found = values.find(name);
    if (found == values.end()) throw CheckpointError("it does not hold '" + name + "'");
    if (auto const* value = std::get_if<T>(&found->second)) return *value;
    throw CheckpointError("it holds '" + name + "' as another kind of value than expected");
  }

  friend bool operator==(Checkpoint const&, Checkpoint const&) = default;
};

/// The bytes of a checkpoint's file: the same state gives the same bytes.
[[nodiscard]] std::string checkpoint_bytes(Checkpoint const& checkpoint);

/// The state in a checkpoint's bytes, bit for bit. Throws CheckpointError, which names `path` and what is wrong: not a
/// checkpoint, of another format, cut short, damaged.
[[nodiscard]] Checkpoint checkpoint_from(std::string_view bytes, std::filesystem::path const& path);

/// Reads a checkpoint. Throws FileError where the file cannot be read, CheckpointError where it cannot be used.
[[nodiscard]] Checkpoint read_checkpoint(std::filesystem::path const& path);

/// Writes `<folder>/ck_<step>.h5` atomically, then removes older ones until `keep` >= 1 are left up to this step.
/// Later ones (of a run resumed from further back) stay. Returns the file's path. Throws FileError.
std::filesystem::path write_checkpoint(std::filesystem::path const& folder, Checkpoint const& checkpoint, int keep);

/// The folder's checkpoints, the earliest step first. Throws FileError where there is no such folder.
[[nodiscard]] std::vector<std::filesystem::path> checkpoints_in(std::filesystem::path const& folder);

}  // namespace talus::io
