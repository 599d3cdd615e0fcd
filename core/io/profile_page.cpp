#include "core/io/profile_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/io/series.hpp"

namespace talus::io {

namespace fs = std::filesystem;

namespace {

/// The rows of a file that belong to one time.
struct Profile {
  double time;
  std::size_t first, rows;
};

/// The times at which a column has a number.
std::vector<Profile> profiles_of(std::vector<double> const& time, std::vector<double> const& values) {
  std::vector<Profile> profiles;
  for (std::size_t k = 0; k < time.size();) {
    Profile profile{time[k], k, 0};
    bool holds = false;
    for (; k < time.size() && time[k] == profile.time; ++k, ++profile.rows) holds = holds || std::isfinite(values[k]);
    if (holds) profiles.push_back(profile);
  }
  return profiles;
}

/// Whether a curve along the values has any length.
bool spreads(std::vector<double> const& values) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (double const value : values)
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  return low < high;
}

CurvePage page_of(fs::path const& file, std::string const& title, int most) {
  Series const series = read_series(file);
  auto const *time = series.find("time"), *u = series.find("flow_velocity"), *y = series.find("height");
  std::string const name = file.stem().string();
  CurvePage page{"profile_" + name,
                 title.empty() ? name : title + ", " + name,
                 "velocity along the flow (m/s)",
                 "height (m)",
                 true,
                 {}};
  if (time == nullptr || u == nullptr || y == nullptr || !spreads(*u) || !spreads(*y)) return page;
  auto const all = profiles_of(*time, *u);
  auto const column = [&](auto const* values) { return static_cast<std::size_t>(values - series.values.data()) + 1; };
  auto const shown = std::min(all.size(), static_cast<std::size_t>(most));
  for (std::size_t k = 0; k < shown; ++k) {
    Profile const& at = all[shown > 1 ? k * (all.size() - 1) / (shown - 1) : 0];
    page.curves.push_back({fmt::format("{:.3g} s", at.time), "../profiles/" + file.filename().string(), column(u),
                           column(y), at.first, at.rows});
  }
  return page;
}

}  // namespace

std::vector<CurvePage> profile_pages(fs::path const& run_folder, std::string const& title, int instants) {
  std::vector<CurvePage> pages;
  if (!fs::is_directory(run_folder / "profiles")) return pages;
  std::vector<fs::path> files;
  for (auto const& entry : fs::directory_iterator(run_folder / "profiles"))
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (fs::path const& file : files)
    if (CurvePage page = page_of(file, title, instants); !page.curves.empty()) pages.push_back(std::move(page));
  return pages;
}

}  // namespace talus::io
