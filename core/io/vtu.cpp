#include "core/io/vtu.hpp"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <functional>
#include <numeric>
#include <stdexcept>

#include "core/io/files.hpp"
#include "core/io/xml.hpp"

namespace talus::io {

static_assert(std::endian::native == std::endian::little, "frames are written as they lie in memory");

namespace {

/// One array of the file: the attributes of its tag, and its bytes, made only when they are written.
struct Block {
  std::string attributes;
  std::uint64_t size = 0;
  std::function<std::string()> bytes;
};

template <class T>
std::string bytes_of(std::vector<T> const& values) {
  return {reinterpret_cast<char const*>(values.data()), values.size() * sizeof(T)};
}

template <class T>
Block constant_block(std::string attributes, T value) {
  return {std::move(attributes), sizeof value, [value] { return bytes_of(std::vector<T>{value}); }};
}

int components_in_file(NamedColumn const& column) {
  return column.components == 2 ? 3 : column.components;
}

std::string padded_bytes(NamedColumn const& column) {
  if (column.components != 2) return bytes_of(column.values);
  std::vector<double> padded(column.values.size() / 2 * 3, 0.0);
  for (std::size_t k = 0; k < column.values.size(); ++k) padded[k / 2 * 3 + k % 2] = column.values[k];
  return bytes_of(padded);
}

Block column_block(NamedColumn const& column, std::size_t particles) {
  int const width = components_in_file(column);
  auto attributes = fmt::format(
      R"(type="Float64" Name="{}" NumberOfComponents="{}" components="{}" symbol="{}" unit="{}" meaning="{}")",
      xml::escape(column.name), width, column.components, xml::escape(column.symbol), xml::escape(column.unit),
      xml::escape(column.meaning));
  auto const size = particles * static_cast<std::size_t>(width) * sizeof(double);
  return {std::move(attributes), size, [&column] { return padded_bytes(column); }};
}

/// The arrays between the opening and the closing tag of a section, in the order in which they are written.
struct Section {
  std::string open, close;
  std::vector<Block> blocks;
};

/// Each particle is a cell of its own: VTK_VERTEX = 1.
Section vertices(std::size_t particles) {
  auto const counted_from = [particles](std::int32_t first) {
    return [particles, first] {
      std::vector<std::int32_t> numbers(particles);
      std::iota(numbers.begin(), numbers.end(), first);
      return bytes_of(numbers);
    };
  };
  return {"<Cells>",
          "</Cells>",
          {{R"(type="Int32" Name="connectivity")", 4 * particles, counted_from(0)},
           {R"(type="Int32" Name="offsets")", 4 * particles, counted_from(1)},
           {R"(type="UInt8" Name="types")", particles, [particles] { return std::string(particles, '\1'); }}}};
}

std::vector<Section> sections_of(Snapshot const& snapshot) {
  auto const* position = snapshot.find("position");
  if (position == nullptr) throw std::logic_error("a frame needs a column 'position'");
  auto const n = snapshot.particles();
  Section data{"<PointData>", "</PointData>", {}};
  for (auto const& column : snapshot.columns)
    if (&column != position) data.blocks.push_back(column_block(column, n));
  return {{"<FieldData>",
           "</FieldData>",
           {constant_block(R"(type="Float64" Name="TimeValue" NumberOfTuples="1")", snapshot.time),
            constant_block(R"(type="Int64" Name="step" NumberOfTuples="1")", snapshot.step),
            constant_block(R"(type="Int64" Name="dimension" NumberOfTuples="1")", std::int64_t{snapshot.dimension})}},
          {fmt::format("<Piece NumberOfPoints=\"{0}\" NumberOfCells=\"{0}\">\n<Points>", n),
           "</Points>",
           {column_block(*position, n)}},
          vertices(n),
          std::move(data)};
}

std::string header_of(std::vector<Section> const& sections) {
  std::string header =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<UnstructuredGrid>\n";
  std::uint64_t offset = 0;
  for (auto const& section : sections) {
    header += section.open + "\n";
    for (auto const& block : section.blocks) {
      header += fmt::format("<DataArray {} format=\"appended\" offset=\"{}\"/>\n", block.attributes, offset);
      offset += sizeof(std::uint64_t) + block.size;
    }
    header += section.close + "\n";
  }
  return header + "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
}

}  // namespace

void write_vtu(std::filesystem::path const& path, Snapshot const& snapshot) {
  auto const sections = sections_of(snapshot);
  PendingFile file(path);
  file.write(header_of(sections));
  for (auto const& section : sections)
    for (auto const& block : section.blocks) {
      file.write(&block.size, sizeof block.size);
      file.write(block.bytes());
    }
  file.write("\n</AppendedData>\n</VTKFile>\n");
  file.commit();
}

void write_frame_list(std::filesystem::path const& path, std::vector<Frame> const& frames) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for (auto const& frame : frames)
    text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", frame.time, xml::escape(frame.file));
  write_atomically(path, text + "</Collection>\n</VTKFile>\n");
}

std::vector<Frame> read_frame_list(std::filesystem::path const& path) {
  auto const text = read_file(path);
  std::vector<Frame> frames;
  std::size_t at = 0;
  for (auto tag = xml::next_tag(text, "DataSet", at); !tag.empty(); tag = xml::next_tag(text, "DataSet", at)) {
    auto const time = xml::attribute(tag, "timestep"), file = xml::attribute(tag, "file");
    Frame frame;
    if (!time || !file || std::from_chars(time->data(), time->data() + time->size(), frame.time).ec != std::errc())
      throw FileError(path.string() + " is not a list of frames as Talus writes it");
    frame.file = *file;
    frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace talus::io
