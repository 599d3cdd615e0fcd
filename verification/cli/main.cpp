/// talus-verify: chooses cases, runs them, and says what came out.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "core/cli/exit_codes.hpp"
#include "core/cli/outcome.hpp"
#include "core/cli/stopping.hpp"
#include "core/errors.hpp"
#include "core/io/columns.hpp"
#include "core/io/files.hpp"
#include "core/io/progress.hpp"
#include "core/io/provenance.hpp"
#include "core/io/text.hpp"
#include "core/parallel.hpp"
#include "verification/cli/selection.hpp"
#include "verification/report/report.hpp"
#include "verification/suite/runner.hpp"

namespace talus::verification {

namespace {

struct Arguments {
  std::vector<std::string> names, command_line;
  std::optional<int> tier;
  std::string folder, against, markdown;
  int jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  bool list = false, json = false, quiet = false, verbose = false, force = false;
};

void declare(CLI::App& app, Arguments& a) {
  app.add_option("cases", a.names, "Cases to run: an id, a folder of ids, or a pattern ('*/bar')");
  app.add_option("--tier", a.tier,
                 "Only cases up to this tier. 0: seconds; 1: minutes; 2: all. If not given: named cases whatever their "
                 "tier, else up to 1")
      ->check(CLI::Range(0, 2));
  app.add_flag("--list", a.list, "The cases that there are, and the time each may take; runs none");
  app.add_option("-j,--jobs", a.jobs, "Cases at the same time, each on one thread; with 1 a case has all threads")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("-o,--output", a.folder, "Folder for report.html, report.md, results.json, results.csv and junit.xml");
  app.add_flag("--force", a.force, "Replace earlier results in the folder");
  app.add_option("--against", a.against, "Folder of an earlier run, to compare every row with");
  app.add_option("--markdown", a.markdown, "Write report.md into this file as well");
  app.add_flag("--json", a.json, "results.json on standard output, in place of the table");
  app.add_flag("-v,--verbose", a.verbose, "Show every row, not only those that are not green");
  app.add_flag("-q,--quiet", a.quiet, "No progress");
  app.footer(
      "Example:\n  talus verify manufactured --tier 1 -o verify/today --against verify/before\n"
      "Ends with exit code 5 where a row failed, is floored, or a case did not come to its end.");
}

void list(std::vector<Case const*> const& cases, bool json) {
  nlohmann::json all = nlohmann::json::array();
  std::vector<std::vector<std::string>> rows{{"case", "tier", "budget", "what"}};
  for (Case const* one : cases) {
    all.push_back({{"id", one->id},
                   {"title", one->title},
                   {"truth", one->truth},
                   {"source", one->source},
                   {"tier", one->tier},
                   {"budget", one->budget}});
    rows.push_back(
        {std::string(one->id), fmt::to_string(one->tier), fmt::format("{:g} s", one->budget), std::string(one->title)});
  }
  fmt::print("{}", json ? io::json_text(all) : io::columns(rows, "lrr"));
}

/// A line a finished case; on a terminal each replaces the one before.
class Talk {
 public:
  Talk(bool quiet, std::size_t all)
      : quiet_(quiet), terminal_(io::ProgressOutput::standard_error().terminal), all_(all) {
    if (terminal_) say(fmt::format("[0/{}]", all));
  }
  void operator()(Result const& result, std::size_t left) const {
    auto const counts = totals(result.findings);
    auto const verdict = count(counts, Verdict::error) > 0 ? "ERROR" : is_green(counts) ? "PASS" : "FAIL";
    say(fmt::format("[{}/{}] {} {}, {}", all_ - left, all_, result.id, verdict, duration_text(result.seconds)));
  }
  void end() const {
    if (!quiet_ && terminal_) fmt::print(stderr, "\r\033[K");
  }

 private:
  void say(std::string const& line) const {
    if (!quiet_) fmt::print(stderr, "{}{}{}", terminal_ ? "\r\033[K" : "", line, terminal_ ? "" : "\n");
  }
  bool quiet_, terminal_;
  std::size_t all_;
};

bool in_colour() {
  char const* const no = std::getenv("NO_COLOR");
  return isatty(STDOUT_FILENO) != 0 && (no == nullptr || *no == '\0');
}

Report run(std::vector<Case const*> const& cases, Arguments const& a) {
  cli::note_stop_signals();
  auto const start = io::utc_now();
  auto const begin = std::chrono::steady_clock::now();
  Talk const talk(a.quiet, cases.size());
  Report report;
  report.results = run_cases(cases, {.jobs = a.jobs, .finished = talk, .interrupted = cli::stop_asked});
  talk.end();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  report.jobs = a.jobs;
  report.provenance = io::provenance_document({.command_line = a.command_line,
                                               .threads = a.jobs > 1 ? 1 : thread_count(),
                                               .inputs = {},
                                               .start = start,
                                               .end = io::utc_now()});
  return report;
}

int verify(Arguments const& a) {
  bool const list_all = a.list && a.names.empty() && !a.tier;
  auto const cases = chosen(verification::cases(), a.names, list_all ? 2 : a.tier);
  if (a.list) {
    list(cases, a.json);
    return cli::done;
  }
  if (!a.folder.empty()) io::make_folder(a.folder, a.force ? "" : "results.json");
  // what cannot be written or compared is told before all the work
  if (!a.markdown.empty()) {
    std::filesystem::path const folder = std::filesystem::absolute(a.markdown).parent_path();
    if (!std::filesystem::is_directory(folder))
      throw FileError(folder.string() + ": there is no such folder for " + a.markdown);
  }
  if (!a.against.empty()) (void)compare_with({}, a.against);
  Report report = run(cases, a);
  if (!a.against.empty()) report.against = compare_with(report.results, a.against);
  // first to the reader: the disk may be full
  fmt::print("{}", a.json ? io::json_text(document_of(report)) : text_of(report, a.verbose, in_colour()));
  std::fflush(stdout);
  if (!a.folder.empty()) write_folder(a.folder, report);
  if (!a.markdown.empty()) io::write_atomically(a.markdown, markdown_of(report));
  if (!a.folder.empty() && !a.quiet) fmt::print(stderr, "results in {}\n", a.folder);
  if (cli::stop_asked()) {
    fmt::print(stderr, "talus verify: stopped by a signal; the cases that were done are in the results\n");
    return cli::stopped;
  }
  return is_green(totals(report.results)) ? cli::done : cli::expectation_failed;
}

}  // namespace

int main(int argc, char** argv) {
  cli::take_failed_writes_as_errors();
  Arguments arguments;
  arguments.command_line.assign(argv, argv + argc);
  CLI::App app{"The verification suite: every row says what was expected, what came out, and how sure it is.",
               "talus verify"};
  declare(app, arguments);
  try {
    app.parse(argc, argv);
    return cli::after_output(verify(arguments));
  } catch (CLI::ParseError const& error) {
    return cli::after_output(app.exit(error) == 0 ? cli::done : cli::usage_error);
  } catch (std::exception const& error) {
    return cli::told(error, "talus verify");
  }
}

}  // namespace talus::verification

int main(int argc, char** argv) {
  return talus::verification::main(argc, argv);
}
