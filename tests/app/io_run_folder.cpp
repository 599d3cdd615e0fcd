/// The folder of a run: what is in it, whom it belongs to, what may be removed.

#include <boost/test/unit_test.hpp>
#include <fstream>
#include <limits>
#include <regex>

#include "core/config/json.hpp"
#include "core/io/checkpoint.hpp"
#include "core/io/run_folder.hpp"
#include "core/io/series.hpp"
#include "tests/support/says.hpp"
#include "tests/support/snapshots.hpp"
#include "tests/support/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(io_run_folder)

using namespace talus;
namespace fs = std::filesystem;
using nlohmann::json;
using support::says;
using support::TemporaryFolder;

namespace {

/// A folder with all that a run leaves, and a rest of each kind that a kill may leave.
void leave_a_run(fs::path const& path) {
  auto folder = io::RunFolder::create(path, false);
  for (auto const* name : {"case.json", "resolved.json", "provenance.json", "summary.json", "report.html"})
    folder.write(name, std::string_view("{}"));
  for (auto const& file : {folder.series(), folder.profile("toe")})
    io::SeriesWriter(file, {{"time", "s"}}).append(std::vector<double>{0});
  std::vector<io::Frame> frames;
  folder.add_frame(support::collapsing_heap(2, 8, 0), frames);
  folder.add_frame(support::collapsing_heap(2, 8, 0.5), frames);
  io::write_checkpoint(folder.checkpoints(), {support::collapsing_heap(2, 8, 0.5), {}}, 2);
  for (auto const* name :
       {"frames/f_000002.vtu.tmp", "checkpoints/ck_000000000900.h5.tmp", "summary.json.tmp", "plots/particles.png",
        "plots/motion.svg", "plots/profile_toe.png", "plots/pictures.gp", "plots/side_000000.dat"})
    folder.write(name, std::string_view("rest"));
  folder.write_status({io::Outcome::failed, 4, 0.5, 500});
}

std::vector<std::string> files_in(fs::path const& path) {
  std::vector<std::string> names;
  for (auto const& entry : fs::recursive_directory_iterator(path))
    if (!entry.is_directory()) names.push_back(fs::relative(entry.path(), path).string());
  std::ranges::sort(names);
  return names;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_new_folder_says_at_once_that_the_run_is_under_way) {
  TemporaryFolder const folder;
  auto const run = io::RunFolder::create(folder / "a/b", false);
  for (auto const* name : {"frames", "checkpoints", "plots"}) BOOST_TEST(fs::is_directory(run.path() / name));
  auto const status = io::read_status(run.path());
  BOOST_TEST((status.outcome == io::Outcome::running));
  BOOST_TEST(!status.exit_code.has_value());
  BOOST_TEST((files_in(run.path()) == std::vector<std::string>{"log.txt", "status.json"}));
}

BOOST_AUTO_TEST_CASE(an_empty_folder_is_taken_and_a_full_one_is_not) {
  TemporaryFolder const folder;
  fs::create_directory(folder / "empty");
  auto const run = io::RunFolder::create(folder / "empty", false);
  leave_a_run(folder / "run");
  auto const before = files_in(folder / "run");
  BOOST_CHECK_EXCEPTION(static_cast<void>(io::RunFolder::create(folder / "run", false)), FileError, says("--force"));
  BOOST_TEST((files_in(folder / "run") == before));
}

BOOST_AUTO_TEST_CASE(force_removes_what_is_ours_and_nothing_else) {
  TemporaryFolder const folder;
  auto const path = folder / "run";
  leave_a_run(path);
  std::vector<std::string> const foreign{"checkpoints/ck_best.h5",
                                         "checkpoints/notes.txt",
                                         "frames/f_1.vtu",
                                         "frames/sub/f_000000.vtu",
                                         "notes.txt",
                                         "plots/mine.png",
                                         "plots/particles_blue.png",
                                         "profiles/of mine.csv",
                                         "summary.json.bak",
                                         "sub/case.json"};
  for (auto const& name : foreign) {
    fs::create_directories((path / name).parent_path());
    io::write_atomically(path / name, "mine");
  }
  auto const run = io::RunFolder::create(path, true);
  auto expected = foreign;
  expected.insert(expected.end(), {"log.txt", "status.json"});
  std::ranges::sort(expected);
  BOOST_TEST(files_in(path) == expected, boost::test_tools::per_element());
  BOOST_TEST((io::read_status(path).outcome == io::Outcome::running));
}

BOOST_AUTO_TEST_CASE(force_does_not_clear_a_folder_that_is_no_run) {
  TemporaryFolder const folder;
  fs::create_directory(folder / "mine");
  io::write_atomically(folder / "mine/case.json", "my only copy");
  for (std::string const status :
       {"", "no JSON", "[]", R"({"schema": "other/1", "status": "done"})", R"({"schema": 5})"}) {
    BOOST_TEST_CONTEXT(status) {
      if (!status.empty()) io::write_atomically(folder / "mine/status.json", status);
      BOOST_CHECK_EXCEPTION(static_cast<void>(io::RunFolder::create(folder / "mine", true)), FileError,
                            says("is not the folder of a run"));
    }
  }
  BOOST_TEST(io::read_file(folder / "mine/case.json") == "my only copy");
}

BOOST_AUTO_TEST_CASE(force_does_not_follow_a_link) {
  TemporaryFolder const folder;
  leave_a_run(folder / "other");
  leave_a_run(folder / "run");
  fs::remove_all(folder / "run/frames");
  fs::create_directory_symlink(folder / "other/frames", folder / "run/frames");
  auto const before = files_in(folder / "other");
  BOOST_CHECK_EXCEPTION(static_cast<void>(io::RunFolder::create(folder / "run", true)), FileError, says("is a link"));
  BOOST_TEST((files_in(folder / "other") == before));
}

BOOST_AUTO_TEST_CASE(two_processes_do_not_share_a_folder) {
  TemporaryFolder const folder;
  {
    auto const run = io::RunFolder::create(folder / "run", false);
    BOOST_CHECK_EXCEPTION(static_cast<void>(io::RunFolder::open(folder / "run")), FileError, says("another process"));
    BOOST_CHECK_EXCEPTION(static_cast<void>(io::RunFolder::create(folder / "run", true)), FileError,
                          says("another process"));
  }
  BOOST_CHECK_NO_THROW(static_cast<void>(io::RunFolder::open(folder / "run")));
}

BOOST_AUTO_TEST_CASE(a_run_is_opened_again_without_what_a_kill_left_half_written) {
  TemporaryFolder const folder;
  leave_a_run(folder / "run");
  io::write_atomically(folder / "run/mine.tmp", "mine");
  auto expected = files_in(folder / "run");
  auto const rests =
      std::erase_if(expected, [](auto const& name) { return name.ends_with(".tmp") && name != "mine.tmp"; });
  BOOST_TEST(rests == 3u);
  auto run = io::RunFolder::open(folder / "run");
  run.log("again");
  BOOST_TEST(files_in(folder / "run") == expected, boost::test_tools::per_element());
  BOOST_CHECK_THROW(static_cast<void>(io::RunFolder::open(folder / "missing")), FileError);
  BOOST_CHECK_THROW(static_cast<void>(io::RunFolder::open(folder.path())), FileError);
}

BOOST_AUTO_TEST_CASE(a_run_may_lie_behind_a_link) {
  TemporaryFolder const folder;
  leave_a_run(folder / "run");
  fs::rename(folder / "run/frames", folder / "frames");
  fs::create_directory_symlink(folder / "frames", folder / "run/frames");
  auto const before = files_in(folder / "frames");
  BOOST_CHECK_NO_THROW(static_cast<void>(io::RunFolder::open(folder / "run")));
  BOOST_TEST((files_in(folder / "frames") == before));
}

BOOST_AUTO_TEST_CASE(a_folder_of_a_run_killed_at_once_is_as_good_as_empty) {
  TemporaryFolder const folder;
  fs::create_directory(folder / "run");
  std::ofstream(folder / "run/status.json.tmp") << "{";
  BOOST_CHECK_NO_THROW(static_cast<void>(io::RunFolder::create(folder / "run", false)));
  BOOST_TEST((files_in(folder / "run") == std::vector<std::string>{"log.txt", "status.json"}));
}

BOOST_AUTO_TEST_CASE(a_file_in_the_place_of_the_folder_is_an_error) {
  TemporaryFolder const folder;
  io::write_atomically(folder / "run", "a file");
  BOOST_CHECK_THROW(static_cast<void>(io::RunFolder::create(folder / "run", true)), FileError);
  BOOST_CHECK_THROW(static_cast<void>(io::RunFolder::create(folder / "run/below", false)), FileError);
  BOOST_TEST(io::read_file(folder / "run") == "a file");
}

BOOST_AUTO_TEST_CASE(the_case_is_kept_byte_for_byte) {
  TemporaryFolder const folder;
  auto const run = io::RunFolder::create(folder / "run", false);
  std::string const given("{ \"b\" : 1,\r\n\t\"a\":\xc3\xa4 }\n\n\0", 25);
  run.write("case.json", given);
  BOOST_TEST(io::read_file(run.path() / "case.json") == given);
}

BOOST_AUTO_TEST_CASE(documents_have_sorted_keys_and_survive_foreign_bytes) {
  TemporaryFolder const folder;
  auto const run = io::RunFolder::create(folder / "run", false);
  run.write("summary.json", json{{"b", 1}, {"a", "x\xff"}});
  BOOST_TEST(io::read_file(run.path() / "summary.json") == "{\n  \"a\": \"x\xef\xbf\xbd\",\n  \"b\": 1\n}\n");
}

BOOST_AUTO_TEST_CASE(the_status_comes_back) {
  TemporaryFolder const folder;
  auto const run = io::RunFolder::create(folder / "run", false);
  run.write_status({io::Outcome::stopped, 75, 0.1 + 0.2, 123456789012});
  auto status = io::read_status(run.path());
  BOOST_TEST((status.outcome == io::Outcome::stopped));
  BOOST_TEST(status.exit_code.value() == 75);
  BOOST_TEST(status.time == 0.1 + 0.2);
  BOOST_TEST(status.step == 123456789012);
  run.write_status({io::Outcome::failed, 4, std::numeric_limits<double>::quiet_NaN(), 1});
  BOOST_TEST(std::isnan(io::read_status(run.path()).time));
  auto const document = json_of(io::read_file(run.path() / "status.json"));
  BOOST_TEST(document.at("status") == "failed");
  BOOST_TEST(document.at("time").is_null());
  BOOST_TEST(document.at("time_status") == "nan");
}

BOOST_AUTO_TEST_CASE(frames_are_numbered_and_listed) {
  TemporaryFolder const folder;
  auto const run = io::RunFolder::create(folder / "run", false);
  std::vector<io::Frame> frames;
  for (double time : {0.0, 0.25, 0.5}) run.add_frame(support::collapsing_heap(2, 8, time), frames);
  BOOST_TEST((io::read_frame_list(run.frame_list()) == frames));
  BOOST_TEST(frames.back().file == "frames/f_000002.vtu");
  BOOST_TEST(frames.back().time == 0.5);
  BOOST_TEST(io::read_vtu(run.path() / frames[1].file).time == 0.25);
  frames.resize(1);  // resumed from a checkpoint after the first frame
  run.add_frame(support::collapsing_heap(2, 8, 0.75), frames);
  BOOST_TEST(io::read_frame_list(run.frame_list()).size() == 2u);
  BOOST_TEST(io::read_vtu(run.frames() / "f_000001.vtu").time == 0.75);
}

BOOST_AUTO_TEST_CASE(the_log_grows_line_by_line_with_the_time) {
  TemporaryFolder const folder;
  { io::RunFolder::create(folder / "run", false).log("begun"); }
  io::RunFolder::open(folder / "run").log("resumed");
  std::regex const lines(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ begun\n\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ resumed\n)");
  BOOST_TEST(std::regex_match(io::read_file(folder / "run/log.txt"), lines));
}

BOOST_AUTO_TEST_SUITE_END()
