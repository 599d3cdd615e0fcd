#include "core/io/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <vector>

#include "core/config/json.hpp"
#include "core/io/files.hpp"
#include "core/io/gnuplot.hpp"
#include "core/io/picture_panel.hpp"
#include "core/io/profile_page.hpp"
#include "core/io/series.hpp"
#include "core/io/series_page.hpp"
#include "core/io/vtu.hpp"

namespace talus::io {

namespace fs = std::filesystem;

namespace {

struct Instant {
  std::string number;  ///< of its frame, as in the name of the frame's file
  Snapshot snapshot;
};

/// How many instants to show of frames 0 to `last`: `most`, or up to two less if they then are equally far apart.
int count_instants(int last, int most) {
  if (most > last) return last + 1;
  for (int count = most; count >= 4 && count >= most - 2; --count)
    if (last % (count - 1) == 0) return count;
  return std::max(1, most);
}

/// The frames at about equal distances from the first to the last, those without particles left out; of each only what
/// is drawn.
std::vector<Instant> choose_instants(fs::path const& run_folder, std::string const& field, int most) {
  auto const frames = read_frame_list(run_folder / "frames.pvd");
  auto const last = static_cast<int>(frames.size()) - 1;
  int const wanted = count_instants(last, most);
  std::vector<Instant> instants;
  for (int k = 0; k < wanted; ++k) {
    auto const index = wanted > 1 ? (k * last + (wanted - 1) / 2) / (wanted - 1) : last;
    auto snapshot = read_vtu(run_folder / frames[static_cast<std::size_t>(index)].file);
    static_cast<void>(column_of(snapshot, field));  // throws where the frames lack it
    std::erase_if(snapshot.columns,
                  [&](auto const& column) { return column.name != "position" && column.name != field; });
    if (snapshot.particles() > 0) instants.push_back({fmt::format("{:06}", index), std::move(snapshot)});
  }
  return instants;
}

/// The run's own title, if it has one.
std::string title_of(fs::path const& run_folder) {
  auto const file = run_folder / "resolved.json";
  if (!fs::exists(file)) return "";
  auto const document = json_of(read_file(file));
  auto const title = document.is_object() ? document.find("title") : document.end();
  return title != document.end() && title->is_string() ? title->get<std::string>() : "";
}

std::string colour_label(Snapshot const& snapshot, std::string const& field) {
  auto const& column = column_of(snapshot, field);
  auto const name = field == "velocity" ? "speed" : column.components > 1 ? "magnitude of " + field : field;
  return column.unit == "1" ? name : name + " (" + column.unit + ")";
}

/// "a × b × c m", for the title of what has no axes to read it from.
std::string size_of(Bounds const& box) {
  return fmt::format("box {:.3g} × {:.3g} × {:.3g} m", box.high[0] - box.low[0], box.high[1] - box.low[1],
                     box.high[2] - box.low[2]);
}

/// One scale of colours for all pages.
void share_colours(std::vector<Page>& pages) {
  double low = 0, high = 0;
  for (auto const& panel : pages.front().panels) {
    low = std::min(low, panel.lowest);
    high = std::max(high, panel.highest);
  }
  for (auto& page : pages) {
    page.colour_low = low;
    page.colour_high = high > low ? high : low + 1;
  }
}

/// Sheets of all instants, and a page of the last.
std::vector<Page> particle_pages(fs::path const& run_folder, std::vector<Instant> const& instants,
                                 std::string const& field) {
  Scenery scenery{run_folder / "plots", field, {}, spacing_of(instants.front().snapshot)};
  for (auto const& instant : instants) {
    auto const bounds = bounds_of(instant.snapshot);
    scenery.bounds.include(bounds.low);
    scenery.bounds.include(bounds.high);
  }
  bool const solid = instants.front().snapshot.dimension == 3;
  Page sheet{"particles", title_of(run_folder), colour_label(instants.front().snapshot, field), 0, 1, {}};
  if (solid) sheet.title += (sheet.title.empty() ? "" : ", ") + size_of(scenery.bounds);
  auto from_the_side = sheet, last = sheet;
  from_the_side.name = "particles_side";
  last.name = "particles_last";
  for (auto const& instant : instants) {
    from_the_side.panels.push_back(make_panel(scenery, instant.snapshot, instant.number, false));
    if (solid) sheet.panels.push_back(make_panel(scenery, instant.snapshot, instant.number, true));
  }
  last.panels = {from_the_side.panels.back()};
  if (!solid) sheet.panels = from_the_side.panels;
  if (solid) {
    last.panels.push_back(sheet.panels.back());
    last.panels.back().title.clear();  // the panel beside it has the time
  }
  std::vector<Page> pages{sheet, last};
  if (solid) pages.push_back(from_the_side);
  share_colours(pages);
  return pages;
}

}  // namespace

std::string draw_pictures(fs::path const& run_folder, PictureOptions const& options) {
  auto const plots = run_folder / "plots";
  std::error_code error;
  fs::create_directories(plots, error);
  if (error) throw FileError("cannot make the folder " + plots.string() + ": " + error.message());
  auto const instants = choose_instants(run_folder, options.field, options.instants);
  auto const rows = run_folder / "series.csv";
  auto const series = fs::exists(rows) ? read_series(rows) : Series{};
  std::vector<Page> pages;
  if (!instants.empty()) pages = particle_pages(run_folder, instants, options.field);
  auto const profiles = profile_pages(run_folder, title_of(run_folder), options.instants);

  std::string script;
  std::vector<std::string> names;
  for (auto const& format : picture_formats()) {
    for (auto const& page : pages) {
      script += page_script(page, format);
      names.push_back(page.name + "." + format.extension);
    }
    if (auto const motion = motion_script(series, format); !motion.empty()) {
      script += motion;
      names.push_back("motion." + format.extension);
    }
    for (auto const& page : profiles) {
      script += curve_script(page, format);
      names.push_back(page.name + "." + format.extension);
    }
  }
  if (names.empty()) return "the run has neither particles nor a series to show";
  write_atomically(plots / "pictures.gp", script);
  return run_gnuplot(plots, "pictures.gp", names);
}

}  // namespace talus::io
