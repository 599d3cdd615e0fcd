#include "core/io/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace talus::io {

namespace fs = std::filesystem;

namespace {

std::string header_of(std::vector<SeriesColumn> const& columns) {
  std::string header;
  for (auto const& column : columns)
    header += fmt::format("{}{} [{}]", header.empty() ? "" : ",", column.name, column.unit);
  return header + "\n";
}

/// Bytes of the header and the first rows. Throws CheckpointError where the file does not hold them.
std::uintmax_t bytes_to_keep(fs::path const& path, std::vector<SeriesColumn> const& columns, std::int64_t rows) {
  auto const text = read_file(path);
  auto const header = header_of(columns);
  if (!text.starts_with(header)) throw CheckpointError(path.string() + " has other columns than the run to be resumed");
  auto keep = header.size();
  for (std::int64_t row = 0; row < rows; ++row) {
    auto const end = text.find('\n', keep);
    if (end == text.npos)
      throw CheckpointError(fmt::format("{} has {} rows, the checkpoint counts {}", path.string(), row, rows));
    keep = end + 1;
  }
  return keep;
}

/// The part of a line up to the next comma, which is taken off.
std::string_view next_field(std::string_view& line) {
  auto const field = line.substr(0, line.find(','));
  line.remove_prefix(std::min(line.size(), field.size() + 1));
  return field;
}

std::vector<SeriesColumn> read_header(std::string_view line, fs::path const& path) {
  std::vector<SeriesColumn> columns;
  while (!line.empty()) {
    auto const field = next_field(line);
    auto const bracket = field.rfind(" [");
    if (bracket == field.npos || !field.ends_with(']'))
      throw FileError(path.string() + ", line 1: a column without unit: '" + std::string(field) + "'");
    columns.push_back(
        {std::string(field.substr(0, bracket)), std::string(field.substr(bracket + 2, field.size() - bracket - 3))});
  }
  return columns;
}

bool read_row(std::string_view line, std::vector<std::vector<double>>& values) {
  for (auto& column : values) {
    auto const field = next_field(line);
    double value = 0;
    auto const [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc() || end != field.data() + field.size()) return false;
    column.push_back(value);
  }
  return line.empty();
}

}  // namespace

SeriesWriter::SeriesWriter(fs::path const& path, std::vector<SeriesColumn> const& columns)
    : columns_(columns.size()), file_(path, 0) {
  file_.append(header_of(columns));
}

SeriesWriter::SeriesWriter(fs::path const& path, std::vector<SeriesColumn> const& columns, std::int64_t rows)
    : columns_(columns.size()), rows_(rows), file_(path, bytes_to_keep(path, columns, rows)) {}

void SeriesWriter::append(std::span<double const> values) {
  if (values.size() != columns_) throw std::logic_error("a row of a series needs one number for each column");
  file_.append(fmt::format("{}\n", fmt::join(values, ",")));
  ++rows_;
}

std::vector<double> const* Series::find(std::string_view name) const {
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (columns[k].name == name) return &values[k];
  return nullptr;
}

Series read_series(fs::path const& path) {
  auto const text = read_file(path);
  std::string_view rest(text);
  Series series;
  for (int line = 1; rest.find('\n') != rest.npos; ++line) {
    auto const row = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(row.size() + 1);
    if (line == 1) {
      series.columns = read_header(row, path);
      series.values.resize(series.columns.size());
    } else if (!read_row(row, series.values)) {
      throw FileError(fmt::format("{}, line {}: not a row of {} numbers", path.string(), line, series.columns.size()));
    }
  }
  return series;
}

}  // namespace talus::io
