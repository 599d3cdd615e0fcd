/// Pictures of a run, and what they are made of.

#include <stdlib.h>

#include <boost/test/unit_test.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/io/gnuplot.hpp"
#include "core/io/pictures.hpp"
#include "core/io/run_folder.hpp"
#include "core/io/scatter.hpp"
#include "core/io/series.hpp"
#include "tests/support/says.hpp"
#include "tests/support/snapshots.hpp"
#include "tests/support/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(io_pictures)

using namespace talus;
namespace fs = std::filesystem;
using support::collapsing_heap;
using support::says;
using support::TemporaryFolder;

namespace {

/// A run's folder with eight frames of a collapsing heap.
fs::path run_of(fs::path const& path, int dimension, int across) {
  auto const run = io::RunFolder::create(path, false);
  run.write("resolved.json", nlohmann::json{{"title", "it's a `heap` \\ \"of\" grains\n@ {22}°"}});
  io::SeriesWriter series(run.series(), {{"time", "s"}, {"front", "m"}, {"centre_of_mass_x", "m"}});
  std::vector<io::Frame> frames;
  for (int k = 0; k < 8; ++k) {
    run.add_frame(collapsing_heap(dimension, across, 0.1 * k), frames);
    series.append(std::vector<double>{0.1 * k, 0.01 * k * k, 0.1});
  }
  return path;
}

/// Without gnuplot a case is reported as skipped.
boost::test_tools::assertion_result gnuplot_is_there(boost::unit_test::test_unit_id) {
  TemporaryFolder const folder;
  io::write_atomically(folder / "nothing.gp", "");
  return io::run_gnuplot(folder.path(), "nothing.gp").empty();
}

/// The program's search path is empty as long as it lives.
class EmptyPath {
 public:
  EmptyPath() : before_(getenv("PATH")) { setenv("PATH", "/nowhere", 1); }
  EmptyPath(EmptyPath const&) = delete;
  EmptyPath& operator=(EmptyPath const&) = delete;
  ~EmptyPath() { setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

}  // namespace

BOOST_AUTO_TEST_CASE(views_are_right_handed_and_orthonormal) {
  for (auto const& view : {io::side_view(), io::oblique_view()}) {
    auto const& [r, u, t] = view;
    io::Direction const cross{r[1] * u[2] - r[2] * u[1], r[2] * u[0] - r[0] * u[2], r[0] * u[1] - r[1] * u[0]};
    double const length = std::hypot(r[0], r[1], r[2]);
    for (std::size_t k = 0; k < 3; ++k) BOOST_TEST(std::abs(cross[k] - t[k]) < 4e-16);  // two products of size <= 1
    BOOST_TEST(std::abs(length - 1) < 4e-16);
    BOOST_TEST(u[1] > 0);  // y points upwards
  }
}

BOOST_AUTO_TEST_CASE(dots_are_particles_seen_from_the_side_with_their_speed) {
  Snapshot const two{
      0, 0, 3, {{"position", "", "m", "", 3, {1, 2, 5, 3, 4, -5}}, {"velocity", "", "", "", 3, {3, 4, 0, 0, 0, 2}}}};
  auto const dots = io::dots_of(two, io::side_view(), "velocity");
  BOOST_REQUIRE(dots.size() == 2u);
  BOOST_TEST(dots[0].x == 3);  // the farther one first
  BOOST_TEST(dots[0].value == 2);
  BOOST_TEST(dots[1].x == 1);
  BOOST_TEST(dots[1].y == 2);
  BOOST_TEST(dots[1].value == 5);
}

BOOST_AUTO_TEST_CASE(every_nth_dot_of_a_plane_is_an_even_sample) {
  auto const heap = collapsing_heap(2, 64, 0);  // 64 x 32 on the points of a grid
  auto const dots = io::dots_of(heap, io::side_view(), "velocity");
  constexpr std::size_t every = 16;
  std::vector<int> in_cell(8 * 16, 0);  // cells of 4 x 4 particles: one of each is drawn
  double const cell = 4 * 0.2 / 64;
  for (std::size_t k = 0; k < dots.size(); k += every)
    ++in_cell[static_cast<std::size_t>(dots[k].y / cell) * 16 + static_cast<std::size_t>(dots[k].x / cell)];
  // The curve runs through cells of its own, shifted by half a particle: a few cells get two or none.
  BOOST_TEST(std::accumulate(in_cell.begin(), in_cell.end(), 0) == 128);
  BOOST_TEST(std::ranges::count(in_cell, 1) >= 100);
  BOOST_TEST(*std::ranges::max_element(in_cell) <= 2);
}

BOOST_AUTO_TEST_CASE(particles_that_are_nowhere_are_left_out) {
  auto snapshot = support::awkward_snapshot();
  BOOST_TEST(io::dots_of(snapshot, io::side_view(), "pressure").empty());  // NaN and infinity
  BOOST_TEST(io::dots_of(snapshot, io::side_view(), "id").size() == 2u);
  snapshot.columns[0].values[0] = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(io::dots_of(snapshot, io::side_view(), "id").size() == 1u);
  BOOST_TEST(io::bounds_of(snapshot).low[0] == std::numeric_limits<double>::max());
}

/// The cells hold the particles and, at the edge, some empty space: the distance is over-estimated, by less than a
/// third for a body of 20 particles or more across.
BOOST_AUTO_TEST_CASE(the_spacing_of_a_lattice_is_found) {
  for (int dimension : {2, 3})
    for (int across : {20, 64}) {
      BOOST_TEST_CONTEXT(dimension << " dimensions, " << across << " across") {
        double const ratio = io::spacing_of(collapsing_heap(dimension, across, 0)) / (0.2 / across);
        BOOST_TEST(ratio > 0.9);
        BOOST_TEST(ratio < 1.34);
      }
    }
}

BOOST_AUTO_TEST_CASE(text_of_the_user_cannot_leave_its_string) {
  BOOST_TEST(io::gnuplot_string("plain ü") == "'plain ü'");
  BOOST_TEST(io::gnuplot_string("it's") == "'it''s'");
  BOOST_TEST(io::gnuplot_string("a`touch x`\nsystem(\"b\")\t") == "'a''touch x'' system(\"b\") '");
}

BOOST_AUTO_TEST_CASE(every_picture_comes_as_png_and_svg, *boost::unit_test::precondition(gnuplot_is_there)) {
  TemporaryFolder const folder;
  for (int dimension : {2, 3}) {
    BOOST_TEST_CONTEXT(dimension << " dimensions") {
      auto const run = run_of(folder / std::to_string(dimension), dimension, 16);
      BOOST_TEST(io::draw_pictures(run) == "");
      std::vector<std::string> names{"particles", "particles_last", "motion"};
      if (dimension == 3) names.push_back("particles_side");
      for (auto const& name : names) {
        BOOST_TEST(io::read_file(run / "plots" / (name + ".png")).starts_with("\x89PNG"), name);
        BOOST_TEST(io::read_file(run / "plots" / (name + ".svg")).find("</svg>") != std::string::npos, name);
      }
      BOOST_TEST(io::read_file(run / "plots/pictures.log") == "");  // not even a warning
      for (auto const& entry : fs::directory_iterator(run / "plots")) BOOST_TEST(entry.path().extension() != ".tmp");
    }
  }
}

BOOST_AUTO_TEST_CASE(svg_pictures_of_many_particles_stay_small, *boost::unit_test::precondition(gnuplot_is_there)) {
  TemporaryFolder const folder;
  auto const run = run_of(folder / "run", 2, 250);  // 31 250 particles
  BOOST_TEST(io::draw_pictures(run) == "");
  for (std::string const name : {"particles.svg", "particles_last.svg"})
    BOOST_TEST(fs::file_size(run / "plots" / name) < 3'000'000u, name);
}

BOOST_AUTO_TEST_CASE(the_sheet_shows_the_first_and_the_last_frame, *boost::unit_test::precondition(gnuplot_is_there)) {
  TemporaryFolder const folder;
  auto const run = run_of(folder / "run", 2, 16);
  BOOST_TEST(io::draw_pictures(run, {.field = "id", .instants = 4}) == "");
  auto const sheet = io::read_file(run / "plots/particles.svg");
  for (std::string const text : {"t = 0 s", "t = 0.2 s", "t = 0.5 s", "t = 0.7 s"})
    BOOST_TEST(sheet.find(text) != sheet.npos, text);
  BOOST_TEST(sheet.find("t = 0.1 s") == sheet.npos);
  BOOST_TEST(sheet.find("it's a 'heap' \\ ") != sheet.npos);
}

BOOST_AUTO_TEST_CASE(instants_are_equally_far_apart_where_the_frames_allow_it,
                     *boost::unit_test::precondition(gnuplot_is_there)) {
  TemporaryFolder const folder;
  auto const run = io::RunFolder::create(folder / "run", false);
  std::vector<io::Frame> frames;
  for (int k = 0; k < 9; ++k) run.add_frame(collapsing_heap(2, 8, 0.1 * k), frames);
  BOOST_TEST(io::draw_pictures(run.path()) == "");  // frames 0 to 8: not six, but five
  std::string shown;
  for (int k = 0; k < 9; ++k)
    if (fs::exists(run.path() / ("plots/side_00000" + std::to_string(k) + ".dat"))) shown += std::to_string(k);
  BOOST_TEST(shown == "02468");
}

BOOST_AUTO_TEST_CASE(a_run_without_particles_or_with_one_still_has_its_pictures,
                     *boost::unit_test::precondition(gnuplot_is_there)) {
  TemporaryFolder const folder;
  auto const run = io::RunFolder::create(folder / "run", false);
  std::vector<io::Frame> frames;
  auto one = collapsing_heap(2, 2, 0);
  for (auto& column : one.columns) column.values.resize(static_cast<std::size_t>(column.components));
  BOOST_REQUIRE(one.particles() == 1u);
  auto none = one;
  for (auto& column : none.columns) column.values.clear();
  run.add_frame(none, frames);
  BOOST_TEST(io::draw_pictures(run.path()) == "the run has neither particles nor a series to show");
  run.add_frame(one, frames);
  BOOST_TEST(io::draw_pictures(run.path()) == "");
  BOOST_TEST(fs::exists(run.path() / "plots/particles.png"));
}

BOOST_AUTO_TEST_CASE(profiles_are_drawn_at_times_at_which_the_station_sees_something,
                     *boost::unit_test::precondition(gnuplot_is_there)) {
  TemporaryFolder const folder;
  auto const run = io::RunFolder::create(folder / "run", false);
  std::vector<io::Frame> frames;
  run.add_frame(collapsing_heap(2, 8, 0), frames);
  double const none = std::numeric_limits<double>::quiet_NaN();
  io::SeriesWriter toe(run.profile("toe"), {{"time", "s"}, {"height", "m"}, {"flow_velocity", "m/s"}});
  io::SeriesWriter empty(run.profile("sky"), {{"time", "s"}, {"height", "m"}, {"flow_velocity", "m/s"}});
  for (int k = 0; k < 5; ++k)
    for (double const y : {0.1, 0.2, 0.3}) {
      bool const there = k > 1 && y < 0.3;
      toe.append(std::vector<double>{0.25 * k, there ? y : none, there ? y * k : none});
      empty.append(std::vector<double>{0.25 * k, none, none});
    }
  BOOST_TEST(io::draw_pictures(run.path()) == "");
  BOOST_TEST(io::read_file(run.path() / "plots/pictures.log") == "");
  auto const picture = io::read_file(run.path() / "plots/profile_toe.svg");
  for (std::string const text : {"0.5 s", "0.75 s", "1 s"}) BOOST_TEST(picture.find(text) != picture.npos, text);
  BOOST_TEST(picture.find("0.25 s") == picture.npos);
  BOOST_TEST(!fs::exists(run.path() / "plots/profile_sky.svg"));
}

BOOST_AUTO_TEST_CASE(without_gnuplot_there_is_a_word_and_no_error) {
  TemporaryFolder const folder;
  auto const run = run_of(folder / "run", 2, 8);
  EmptyPath const path;
  BOOST_TEST(io::draw_pictures(run) == "gnuplot is not installed (Debian: gnuplot-nox)");
}

BOOST_AUTO_TEST_CASE(a_field_that_the_frames_lack_is_named_with_those_they_have) {
  TemporaryFolder const folder;
  auto const run = run_of(folder / "run", 2, 8);
  BOOST_CHECK_EXCEPTION(static_cast<void>(io::draw_pictures(run, {.field = "presure"})), InputError,
                        says("'presure'; they have position, velocity, id"));
}

BOOST_AUTO_TEST_SUITE_END()
