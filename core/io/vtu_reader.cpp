#include <charconv>
#include <cstring>

#include "core/io/files.hpp"
#include "core/io/vtu.hpp"
#include "core/io/xml.hpp"

namespace talus::io {

namespace {

/// A frame as it was read: the description up to the mark `_`, and the blocks behind it.
struct Parts {
  std::string_view description, blocks;
};

FileError foreign(std::filesystem::path const& path, std::string const& what) {
  return FileError(path.string() + " is not a frame that Talus wrote, or is damaged: " + what);
}

Parts split(std::string_view file, std::filesystem::path const& path) {
  constexpr std::string_view mark = "<AppendedData encoding=\"raw\">\n_";
  auto const at = file.find(mark);
  if (!file.starts_with("<?xml") || at == file.npos) throw foreign(path, "it has no appended data");
  return {file.substr(0, at), file.substr(at + mark.size())};
}

std::uint64_t number(std::string_view tag, std::string_view name, std::filesystem::path const& path) {
  auto const text = xml::attribute(tag, name).value_or("");
  std::uint64_t value = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw foreign(path, "the attribute '" + std::string(name) + "' is missing or is no number");
  return value;
}

/// The bytes of the block that a tag points to; they must be `size` bytes.
std::string_view block(Parts const& parts, std::string_view tag, std::uint64_t size,
                       std::filesystem::path const& path) {
  auto const offset = number(tag, "offset", path);
  std::uint64_t stored = 0;
  auto const left = parts.blocks.size();
  if (offset > left || left - offset < sizeof stored) throw foreign(path, "it is cut short");
  std::memcpy(&stored, parts.blocks.data() + offset, sizeof stored);
  if (stored != size) throw foreign(path, "an array has another length than the number of particles asks for");
  if (left - offset - sizeof stored < size) throw foreign(path, "it is cut short");
  return parts.blocks.substr(offset + sizeof stored, size);
}

template <class T>
T single(Parts const& parts, std::string_view tag, std::filesystem::path const& path) {
  T value{};
  std::memcpy(&value, block(parts, tag, sizeof value, path).data(), sizeof value);
  return value;
}

NamedColumn column(Parts const& parts, std::string_view tag, std::uint64_t particles,
                   std::filesystem::path const& path) {
  NamedColumn result;
  result.name = xml::attribute(tag, "Name").value_or("");
  result.symbol = xml::attribute(tag, "symbol").value_or("");
  result.unit = xml::attribute(tag, "unit").value_or("");
  result.meaning = xml::attribute(tag, "meaning").value_or("");
  auto const width = number(tag, "NumberOfComponents", path), kept = number(tag, "components", path);
  if (kept < 1 || kept > width || width > 81) throw foreign(path, "an array has an impossible number of components");
  if (particles > parts.blocks.size()) throw foreign(path, "it is cut short");
  auto const bytes = block(parts, tag, particles * width * sizeof(double), path);
  result.components = static_cast<int>(kept);
  result.values.resize(particles * kept);
  for (std::uint64_t p = 0; p < particles; ++p)
    std::memcpy(&result.values[p * kept], bytes.data() + p * width * sizeof(double), kept * sizeof(double));
  return result;
}

}  // namespace

Snapshot read_vtu(std::filesystem::path const& path) {
  auto const file = read_file(path);
  auto const parts = split(file, path);
  std::size_t piece_at = 0, at = 0;
  auto const particles = number(xml::next_tag(parts.description, "Piece", piece_at), "NumberOfPoints", path);
  Snapshot snapshot;
  for (auto tag = xml::next_tag(parts.description, "DataArray", at); !tag.empty();
       tag = xml::next_tag(parts.description, "DataArray", at)) {
    auto const name = xml::attribute(tag, "Name").value_or("");
    if (xml::attribute(tag, "components")) {
      snapshot.columns.push_back(column(parts, tag, particles, path));
    } else if (name == "TimeValue") {
      snapshot.time = single<double>(parts, tag, path);
    } else if (name == "step") {
      snapshot.step = single<std::int64_t>(parts, tag, path);
    } else if (name == "dimension") {
      snapshot.dimension = static_cast<int>(single<std::int64_t>(parts, tag, path));
    }
  }
  if (snapshot.find("position") == nullptr) throw foreign(path, "it has no positions");
  return snapshot;
}

}  // namespace talus::io
