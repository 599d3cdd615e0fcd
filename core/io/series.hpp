#pragma once
/// Quantities in time, a row an output time: `series.csv` with a header `t [s],front [m],...`.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/files.hpp"

namespace talus::io {

/// Name and unit of a quantity, neither with a comma, bracket or line break; "1" without dimension.
struct SeriesColumn {
  std::string name, unit;

  friend bool operator==(SeriesColumn const&, SeriesColumn const&) = default;
};

/// Writes rows one by one; each is handed to the system at once, so that a killed run loses none.
class SeriesWriter {
 public:
  /// A new file with its header, in place of whatever was there. Throws FileError.
  SeriesWriter(std::filesystem::path const& path, std::vector<SeriesColumn> const& columns);
  /// Goes on behind the first `rows` rows and drops later ones. Throws CheckpointError where the file has other columns
  /// or fewer rows: it is not the file that the checkpoint was written with.
  SeriesWriter(std::filesystem::path const& path, std::vector<SeriesColumn> const& columns, std::int64_t rows);
  /// Each number in the fewest digits (at most 17) that give the same bits when read. Throws FileError (disk full,
  /// ...); std::logic_error where `values` has not one number for each column.
  void append(std::span<double const> values);
  /// Waits until all rows are on the disk: call it before a checkpoint that counts them.
  void sync() { file_.sync(); }
  /// Rows in the file.
  [[nodiscard]] std::int64_t rows() const { return rows_; }

 private:
  std::size_t columns_;
  std::int64_t rows_ = 0;
  GrowingFile file_;
};

/// A series as read: values[column][row].
struct Series {
  std::vector<SeriesColumn> columns;
  std::vector<std::vector<double>> values;

  /// The values of the column of that name, or nullptr.
  [[nodiscard]] std::vector<double> const* find(std::string_view name) const;
};

/// Reads a series; a last row without line break (of a run that was killed) is left out. Throws FileError, which names
/// the line that is not a row of numbers.
[[nodiscard]] Series read_series(std::filesystem::path const& path);

}  // namespace talus::io
