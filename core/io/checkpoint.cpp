#include "core/io/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

#include "core/io/files.hpp"
#include "core/io/hash.hpp"
#include "core/io/hdf5.hpp"

namespace talus::io {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view magic = "talus checkpoint, format ";
/// 1: blocks by the node below, a cell of drift; 2: no ledger; 3: neither mass nor last step.
constexpr int format_version = 4;
constexpr std::size_t header_size = 512;

void write_columns(hid_t file, Snapshot const& snapshot) {
  auto const group = hdf5::new_group(file, "particles");
  auto const n = snapshot.particles();
  for (auto const& column : snapshot.columns) {
    hdf5::Extent extent{n};
    if (column.components > 1) extent.push_back(static_cast<hsize_t>(column.components));
    auto const data = n > 0 ? hdf5::write_packed(group, column.name, extent, column.values.data())
                            : hdf5::write_data(group, column.name, extent, column.values.data());
    hdf5::write_attribute(data, "components", std::int64_t{column.components});
    hdf5::write_attribute(data, "symbol", column.symbol);
    hdf5::write_attribute(data, "unit", column.unit);
    hdf5::write_attribute(data, "meaning", column.meaning);
  }
}

template <class T>
void write_value(hid_t group, std::string const& name, T const& value) {
  hdf5::Handle const data = hdf5::write_data(group, name, {}, &value);
}

template <class T>
void write_value(hid_t group, std::string const& name, std::vector<T> const& values) {
  hdf5::Handle const data = hdf5::write_data(group, name, {values.size()}, values.data());
}

template <class T>
CheckpointValue read_value(hid_t data) {
  std::vector<T> values;
  hdf5::read_data(data, values);
  if (hdf5::extent_of(data).empty()) return values.front();
  return values;
}

CheckpointValue read_value(hid_t data) {
  auto const kind = hdf5::kind_of(data);
  if (kind == hdf5::Kind::text) return read_value<std::string>(data);
  return kind == hdf5::Kind::integer ? read_value<std::int64_t>(data) : read_value<double>(data);
}

NamedColumn read_column(hid_t group, std::string const& name) {
  auto const data = hdf5::open_data(group, name);
  NamedColumn column;
  column.name = name;
  std::int64_t components = 0;
  hdf5::read_attribute(data, "components", components);
  column.components = static_cast<int>(components);
  hdf5::read_attribute(data, "symbol", column.symbol);
  hdf5::read_attribute(data, "unit", column.unit);
  hdf5::read_attribute(data, "meaning", column.meaning);
  hdf5::read_data(data, column.values);
  return column;
}

Checkpoint read_image(std::string_view image) {
  hdf5::Silence const silence;
  auto const file = hdf5::open_image(image);
  Checkpoint checkpoint;
  auto& particles = checkpoint.particles;
  std::int64_t dimension = 0;
  hdf5::read_attribute(file, "time", particles.time);
  hdf5::read_attribute(file, "step", particles.step);
  hdf5::read_attribute(file, "dimension", dimension);
  particles.dimension = static_cast<int>(dimension);
  auto const columns = hdf5::open_group(file, "particles");
  for (auto const& name : hdf5::members(columns)) particles.columns.push_back(read_column(columns, name));
  auto const values = hdf5::open_group(file, "values");
  for (auto const& name : hdf5::members(values))
    checkpoint.values.emplace(name, read_value(hdf5::open_data(values, name)));
  return checkpoint;
}

std::string header_of(std::string_view image) {
  auto header = fmt::format("{}{}\nHDF5 from byte {} on\nbytes {}\nsha256 {}\n", magic, format_version, header_size,
                            image.size(), sha256(image));
  header.resize(header_size, '\n');
  return header;
}

/// The number behind a word of the header, or -1.
std::int64_t number_after(std::string_view header, std::string_view word) {
  auto const at = header.find(word);
  std::int64_t value = -1;
  if (at != header.npos) std::from_chars(header.data() + at + word.size(), header.data() + header.size(), value);
  return value;
}

/// Why the bytes are not a checkpoint that can be read; empty if they are.
std::string fault_of(std::string_view bytes) {
  if (bytes.empty()) return "it is empty";
  if (!bytes.starts_with(magic.substr(0, bytes.size())))
    return bytes.starts_with("\x89HDF") ? "it is an HDF5 file, but not a checkpoint of Talus"
                                        : "it is not a checkpoint of Talus";
  if (bytes.size() < header_size) return fmt::format("it is cut short after {} bytes", bytes.size());
  auto const header = bytes.substr(0, header_size), image = bytes.substr(header_size);
  auto const found = number_after(header, magic), size = number_after(header, "\nbytes ");
  if (found != format_version)
    return fmt::format("it has format {}, this program reads format {}", found, format_version);
  if (static_cast<std::int64_t>(image.size()) < size)
    return fmt::format("it is cut short: {} of {} bytes are left", bytes.size(),
                       size + static_cast<std::int64_t>(header_size));
  if (header != header_of(image)) return "it is damaged: its contents do not agree with its checksum";
  return "";
}

/// The step in a checkpoint's name, or -1 for other files.
std::int64_t step_of(fs::path const& path) {
  auto const name = path.filename().string();
  auto const step = number_after(name, "ck_");
  return step >= 0 && name == fmt::format("ck_{:012}.h5", step) ? step : -1;
}

}  // namespace

std::string checkpoint_bytes(Checkpoint const& checkpoint) {
  hdf5::Silence const silence;
  auto const file = hdf5::new_file();
  hdf5::write_attribute(file, "time", checkpoint.particles.time);
  hdf5::write_attribute(file, "step", checkpoint.particles.step);
  hdf5::write_attribute(file, "dimension", std::int64_t{checkpoint.particles.dimension});
  write_columns(file, checkpoint.particles);
  auto const group = hdf5::new_group(file, "values");
  for (auto const& [name, value] : checkpoint.values)
    std::visit([&, &key = name](auto const& held) { write_value(group, key, held); }, value);
  auto bytes = hdf5::image_of(file, header_size);
  bytes.replace(0, header_size, header_of(std::string_view(bytes).substr(header_size)));
  return bytes;
}

Checkpoint checkpoint_from(std::string_view bytes, fs::path const& path) {
  auto const unusable = [&](std::string const& what) {
    return CheckpointError("the checkpoint " + path.string() + " cannot be used: " + what);
  };
  if (auto const fault = fault_of(bytes); !fault.empty()) throw unusable(fault);
  try {
    return read_image(bytes.substr(header_size));
  } catch (hdf5::Error const& error) {
    throw unusable(error.what());
  }
}

Checkpoint read_checkpoint(fs::path const& path) {
  return checkpoint_from(read_file(path), path);
}

fs::path write_checkpoint(fs::path const& folder, Checkpoint const& checkpoint, int keep) {
  auto const step = checkpoint.particles.step;
  auto const path = folder / fmt::format("ck_{:012}.h5", step);
  write_atomically(path, checkpoint_bytes(checkpoint));
  auto past = checkpoints_in(folder);
  std::erase_if(past, [&](fs::path const& other) { return step_of(other) > step; });
  auto const surplus = std::max<std::ptrdiff_t>(0, std::ssize(past) - std::max(1, keep));
  std::error_code ignored;  // an old checkpoint that stays does no harm
  std::for_each_n(past.begin(), surplus, [&](fs::path const& old) { fs::remove(old, ignored); });
  return path;
}

std::vector<fs::path> checkpoints_in(fs::path const& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (auto const& entry : fs::directory_iterator(folder, error))
    if (step_of(entry.path()) >= 0) found.push_back(entry.path());
  if (error) throw FileError("cannot read the folder " + folder.string() + ": " + error.message());
  std::ranges::sort(found, {}, step_of);
  return found;
}

}  // namespace talus::io
