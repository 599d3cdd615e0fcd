#include "core/cli/profile_files.hpp"

namespace talus::cli {

namespace {

std::vector<io::SeriesColumn> columns_of(Profile const& profile) {
  std::vector<io::SeriesColumn> columns;
  for (Quantity const& q : profile.quantities) columns.push_back({q.name, q.unit});
  return columns;
}

}  // namespace

void ProfileFiles::begin(io::RunFolder const& folder, Experiment const& experiment) {
  for (Profile const& profile : experiment.profiles())
    files_.emplace_back(folder.profile(profile.station), columns_of(profile));
}

void ProfileFiles::resume(io::RunFolder const& folder, Experiment const& experiment,
                          std::vector<std::int64_t> const& rows) {
  auto const profiles = experiment.profiles();
  if (profiles.size() != rows.size()) throw CheckpointError("the checkpoint has other stations than the case");
  for (std::size_t k = 0; k < profiles.size(); ++k)
    files_.emplace_back(folder.profile(profiles[k].station), columns_of(profiles[k]), rows[k]);
}

void ProfileFiles::append(Experiment const& experiment) {
  if (files_.empty()) return;
  auto const profiles = experiment.profiles();
  for (std::size_t k = 0; k < profiles.size(); ++k)
    for (std::vector<double> const& row : profiles[k].rows) files_[k].append(row);
}

void ProfileFiles::sync() {
  for (io::SeriesWriter& file : files_) file.sync();
}

std::vector<std::int64_t> ProfileFiles::rows() const {
  std::vector<std::int64_t> rows;
  for (io::SeriesWriter const& file : files_) rows.push_back(file.rows());
  return rows;
}

}  // namespace talus::cli
