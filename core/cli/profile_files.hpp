#pragma once
/// The files of the stations' profiles: rows in time, a block of them an output time, as series.csv grows.

#include <cstdint>
#include <vector>

#include "core/experiment.hpp"
#include "core/io/run_folder.hpp"
#include "core/io/series.hpp"

namespace talus::cli {

/// A CSV file a station, not frames: numbers over time and height that a spreadsheet and gnuplot read at once, in a file
/// that a killed run leaves whole.
class ProfileFiles {
 public:
  /// New files in place of whatever was there. Throws FileError.
  void begin(io::RunFolder const& folder, Experiment const& experiment);
  /// Goes on behind the first rows of each file. Throws CheckpointError where these are not the files that the
  /// checkpoint was written with, FileError.
  void resume(io::RunFolder const& folder, Experiment const& experiment, std::vector<std::int64_t> const& rows);
  /// Adds the profiles of now. Throws FileError.
  void append(Experiment const& experiment);
  /// Waits until all rows are on the disk.
  void sync();
  /// Rows in each file.
  [[nodiscard]] std::vector<std::int64_t> rows() const;

 private:
  std::vector<io::SeriesWriter> files_;
};

}  // namespace talus::cli
