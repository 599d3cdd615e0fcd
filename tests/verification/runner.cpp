/// Whatever a case does, the run goes on and says what happened.

#include "verification/suite/runner.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "core/parallel.hpp"

BOOST_AUTO_TEST_SUITE(runner)

using namespace talus::verification;
using namespace std::chrono_literals;

namespace {

void note_threads(Findings& findings) {
  findings.note("this case", "threads", talus::thread_count());
}
void pass_late(Findings& findings) {
  std::this_thread::sleep_for(200ms);
  findings.check("late", "a", 1, at_least(0), "");
}
void throw_after_a_row(Findings& findings) {
  findings.check("first", "a", 0.1 + 0.2, at_least(0), "");
  throw std::runtime_error("the third wall is missing");
}
void throw_a_number(Findings&) {
  throw 3;
}
/// Without the file that would tell of it.
void crash(Findings&) {
  rlimit const none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  std::abort();
}
void hang(Findings&) {
  for (;;) std::this_thread::sleep_for(10ms);
}
void compute_for_ever(Findings&) {
  for (volatile unsigned k = 0;;) k = k + 1;
}
void leave(Findings&) {
  _exit(3);
}
void find_nothing(Findings&) {}
void find_much(Findings& findings) {
  for (int k = 0; k < 20000; ++k) findings.note("row " + std::to_string(k), "a", k);
}
void hold_memory(Findings& findings) {
  std::vector<char> const held(80'000'000, 'x');
  findings.note("memory", "a", held[12345]);
}

Case one(std::string_view id, void (*run)(Findings&), double budget = 100) {
  return {id, "title", "truth", "source", 0, budget, run};
}

std::vector<Result> results_of(std::vector<Case> const& cases, RunOptions const& options = {}) {
  std::vector<Case const*> pointers;
  for (Case const& c : cases) pointers.push_back(&c);
  return run_cases(pointers, options);
}

/// The one row of a case that did not end, which the test goes on to judge.
Row error_of(Case const& failing, RunOptions const& options = {}) {
  auto const rows = results_of({failing}, options).front().findings.rows;
  BOOST_TEST_REQUIRE(!rows.empty());
  BOOST_TEST((rows.back().verdict == Verdict::error));
  BOOST_TEST(rows.back().measure == "ends");
  return rows.back();
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_a_case_found_before_it_threw_is_kept) {
  auto const rows = results_of({one("a", throw_after_a_row)}).front().findings.rows;
  BOOST_TEST_REQUIRE(rows.size() == 2u);
  BOOST_TEST(rows[0].found == 0.1 + 0.2);  // every bit
  BOOST_TEST((rows[0].verdict == Verdict::pass));
  BOOST_TEST((rows[1].verdict == Verdict::error));
  BOOST_TEST(rows[1].because == "the third wall is missing");
  BOOST_TEST(!is_green(totals(results_of({one("a", throw_a_number)}))));
}

BOOST_AUTO_TEST_CASE(a_case_that_crashes_or_leaves_is_an_error) {
  BOOST_TEST(error_of(one("a", crash)).because.find("killed by signal 6") == 0u);
  BOOST_TEST(error_of(one("a", leave)).because.find("ended with code 3") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_case_that_finds_nothing_is_not_green) {
  BOOST_TEST(error_of(one("a", find_nothing)).because == "it found nothing");
}

BOOST_AUTO_TEST_CASE(a_case_is_stopped_at_its_budget_times_the_patience) {
  auto const begin = std::chrono::steady_clock::now();
  auto const row = error_of(one("a", hang, 0.05), {.patience = 4});
  BOOST_TEST(row.because == "stopped: it may compute for 0.2 s, 4 times its budget of 0.05 s");
  BOOST_TEST((std::chrono::steady_clock::now() - begin < 5s));
  BOOST_TEST(error_of(one("a", compute_for_ever, 0.05), {.patience = 4}).because == row.because);
}

BOOST_AUTO_TEST_CASE(results_stand_in_the_order_of_the_cases) {
  std::vector<std::string> finished;
  auto const told = [&](Result const& result, std::size_t left) {
    finished.push_back(result.id);
    BOOST_TEST(left == 4 - finished.size());
  };
  auto const results =
      results_of({one("slow", pass_late), one("bad", crash), one("much", find_much), one("threads", note_threads)},
                 {.jobs = 4, .finished = told});
  BOOST_TEST_REQUIRE(results.size() == 4u);
  BOOST_TEST(finished.front() != "slow");
  BOOST_TEST(results[0].id == "slow");
  BOOST_TEST((results[0].findings.rows.at(0).verdict == Verdict::pass));
  BOOST_TEST(results[0].seconds >= 0.2);
  BOOST_TEST(results[2].findings.rows.size() == 20000u);
  BOOST_TEST(results[3].findings.rows.at(0).found == 1);  // one thread, for cases run side by side
}

BOOST_AUTO_TEST_CASE(an_interruption_keeps_what_is_done_and_names_the_rest) {
  bool asked = false;
  auto const results = results_of(
      {one("quick", note_threads), one("endless", hang), one("late", note_threads)},
      {.jobs = 2, .finished = [&](auto const&, auto) { asked = true; }, .interrupted = [&] { return asked; }});
  BOOST_TEST(results[0].findings.rows.at(0).found == 1);
  BOOST_TEST(results[1].findings.rows.at(0).because == "the suite was stopped by a signal before its end");
  BOOST_TEST(results[2].findings.rows.at(0).because == "not begun: the suite was stopped by a signal");
}

BOOST_AUTO_TEST_CASE(memory_and_time_are_of_the_case_alone) {
  auto const results = results_of({one("memory", hold_memory), one("little", note_threads)});
  BOOST_TEST(results[0].peak_memory > 80'000'000);
  BOOST_TEST(results[0].peak_memory > results[1].peak_memory + 60'000'000);
  BOOST_TEST(results[1].findings.rows.at(0).found == talus::thread_count());  // all threads, for a case alone
  BOOST_TEST(results[0].processor_seconds > 0);
}

BOOST_AUTO_TEST_SUITE_END()
