/// How far a run is, on a terminal and elsewhere.

#include <stdlib.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <chrono>

#include "core/io/files.hpp"
#include "core/io/progress.hpp"
#include "tests/support/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(io_progress)

using namespace talus;
using namespace std::chrono_literals;
using support::TemporaryFolder;

namespace {

/// What a run of ten seconds with a step every 10 ms writes.
std::string output_of_a_run(bool terminal) {
  TemporaryFolder const folder;
  io::write_atomically(folder / "out", "");
  FILE* file = std::fopen((folder / "out").c_str(), "w");
  io::Progress::Clock::time_point now{1h};
  io::Progress progress(0, 1, {fileno(file), terminal, false}, now);
  for (int step = 1; step <= 1000; ++step) progress.update(0.001 * step, step, 500 * step, now += 10ms);
  progress.finish(now);
  std::fclose(file);
  return io::read_file(folder / "out");
}

std::size_t count(std::string const& text, std::string const& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_line_tells_share_time_steps_rate_and_what_remains) {
  // A quarter done in 60 s: three times as long remains.
  io::ProgressState const quarter{1, 3, 1.5, 12345, 600'000'000, 60};
  BOOST_TEST(io::progress_text(quarter) == " 25 %   t = 1.5 / 3 s   12345 steps   10 M particle-steps/s   ETA 3:00");
  io::ProgressState const slow{0, 2, 1, 7, 9'000'000, 7200};
  BOOST_TEST(io::progress_text(slow) == " 50 %   t = 1 / 2 s   7 steps   1.2 k particle-steps/s   ETA 2:00:00");
  io::ProgressState const done{0, 2, 2, 7, 999, 1};
  BOOST_TEST(io::progress_text(done) == "100 %   t = 2 / 2 s   7 steps   999 particle-steps/s   took 0:01");
}

BOOST_AUTO_TEST_CASE(nothing_is_promised_before_the_first_progress) {
  BOOST_TEST(io::progress_text({0, 2, 0, 0, 0, 0}) == "  0 %   t = 0 / 2 s   0 steps   0 particle-steps/s   ETA --:--");
  BOOST_TEST(io::progress_text({0, 2, 0, 0, 0, 5}).ends_with("ETA --:--"));
  BOOST_TEST(io::progress_text({0, 2, 1e-12, 0, 0, 5}).ends_with("ETA --:--"));
  BOOST_TEST(io::progress_text({2, 2, 2, 0, 0, 5}).starts_with("100 %"));  // nothing to do
}

BOOST_AUTO_TEST_CASE(it_is_not_done_before_it_is_done) {
  BOOST_TEST(io::progress_text({0, 1, 0.99999, 9, 9, 5}).starts_with(" 99 %"));
}

BOOST_AUTO_TEST_CASE(the_bar_takes_the_room_that_the_text_leaves) {
  io::ProgressState const half{0, 2, 1, 7, 9'000'000, 7200};
  auto const text = io::progress_text(half);
  BOOST_TEST(io::progress_line(half, 200, false) == "[" + std::string(15, '=') + std::string(15, ' ') + "] " + text);
  auto const exact = static_cast<int>(text.size()) + 13;
  BOOST_TEST(io::progress_line(half, exact, false) == "[=====     ] " + text);
  for (int width : {0, 1, 20, 80, exact - 3})
    BOOST_TEST(io::progress_line(half, width, false).size() <= static_cast<std::size_t>(width));
}

BOOST_AUTO_TEST_CASE(colour_is_there_only_where_it_is_wanted) {
  io::ProgressState const half{0, 2, 1, 7, 9'000'000, 7200};
  BOOST_TEST(io::progress_line(half, 120, false).find('\033') == std::string::npos);
  BOOST_TEST(count(io::progress_line(half, 120, true), "\033[") == 2u);
}

BOOST_AUTO_TEST_CASE(no_color_and_dumb_terminals_are_respected) {
  auto const is_plain = [] {
    auto const output = io::ProgressOutput::standard_error();
    return !output.colour && output.descriptor == 2;
  };
  setenv("NO_COLOR", "1", 1);
  BOOST_TEST(is_plain());
  unsetenv("NO_COLOR");
  auto const* before = getenv("TERM");
  std::string const terminal = before == nullptr ? "" : before;
  setenv("TERM", "dumb", 1);
  BOOST_TEST(is_plain());
  BOOST_TEST(!io::ProgressOutput::standard_error().terminal);
  setenv("TERM", terminal.c_str(), 1);
}

BOOST_AUTO_TEST_CASE(a_terminal_sees_one_line_redrawn_ten_times_a_second) {
  auto const text = output_of_a_run(true);
  BOOST_TEST(count(text, "\n") == 1u);
  BOOST_TEST(text.ends_with("took 0:10\n"));
  auto const redrawn = count(text, "\r\033[K");
  BOOST_TEST(redrawn >= 100u);  // 10 s; the last line once more
  BOOST_TEST(redrawn <= 102u);
}

BOOST_AUTO_TEST_CASE(a_file_gets_a_plain_line_every_five_seconds) {
  auto const text = output_of_a_run(false);
  BOOST_TEST(text ==
             " 50 %   t = 0.5 / 1 s   500 steps   50 k particle-steps/s   ETA 0:05\n"
             "100 %   t = 1 / 1 s   1000 steps   50 k particle-steps/s   took 0:10\n"
             "100 %   t = 1 / 1 s   1000 steps   50 k particle-steps/s   took 0:10\n");
}

BOOST_AUTO_TEST_CASE(an_output_that_is_closed_stops_nothing) {
  io::Progress progress(0, 1, {-1, true, true});
  progress.say("nobody hears this");
  BOOST_CHECK_NO_THROW(progress.update(0.5, 1, 1));
  BOOST_CHECK_NO_THROW(progress.finish());
}

BOOST_AUTO_TEST_SUITE_END()
