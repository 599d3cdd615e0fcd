/// talus-bench: chooses benchmarks, runs them, and says what came out.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "benchmarks/registry.hpp"
#include "benchmarks/report/folder.hpp"
#include "benchmarks/report/text.hpp"
#include "benchmarks/timing/clock.hpp"
#include "core/cli/exit_codes.hpp"
#include "core/config/json.hpp"
#include "core/config/nearest.hpp"
#include "core/errors.hpp"
#include "core/io/files.hpp"
#include "core/io/text.hpp"

namespace talus::bench {

namespace {

using cli::ExitCode;

struct Arguments {
  std::vector<std::string> names, command_line;
  std::string folder, against;
  bool json = false, list = false;
  Options options;
};

void declare(CLI::App& app, Arguments& a) {
  app.add_option("names", a.names, "Benchmarks to run; all if none is named");
  app.add_option("-o,--output", a.folder, "New folder for results.json, report.html and pictures");
  app.add_flag("--json", a.json, "One JSON document on standard output");
  app.add_flag("--list", a.list, "The benchmarks that there are, and how long each takes");
  app.add_option("--repeats", a.options.repeats, "Measurements of each number; 0: what each benchmark thinks right")
      ->check(CLI::Range(0, 100000));
  app.add_option("--particles", a.options.particles, "Particles of ratios, threads and sparse; 0: likewise")
      ->check(CLI::Range(std::size_t{0}, std::size_t{100'000'000}));
  app.add_option("--threads", a.options.threads, "Threads that 'threads' and 'limits' compare with one")
      ->check(CLI::Range(2, 1024))
      ->capture_default_str();
  app.add_option("--against", a.against, "An earlier results.json to compare every value with");
  app.add_option("--filter", a.options.filter,
                 "Only rows of stages and instructions in whose name this regular expression is found");
  app.add_flag("--update-baseline", a.options.update_baseline,
               "instructions: what is counted becomes what later counts are compared with");
  app.footer(
      "Example:\n  talus bench ratios threads -o bench/today --against bench/before/results.json\n"
      "Ends with exit code 5 where a bar is missed. benchmarks/README.md says what each benchmark measures.");
}

void list(bool json) {
  nlohmann::json all = nlohmann::json::array();
  for (Benchmark const& b : benchmarks()) {
    all.push_back({{"name", b.name}, {"what", b.what}, {"seconds", b.seconds}});
    if (!json) fmt::print("{:<14} {:>4} s   {}\n", b.name, b.seconds, b.what);
  }
  if (json) fmt::print("{}", io::json_text(all));
}

/// The benchmarks of these names; throws CLI::ValidationError.
std::vector<Benchmark> chosen(std::vector<std::string> const& names) {
  auto const all = benchmarks();
  if (names.empty()) return {all.begin(), all.end()};
  std::vector<std::string_view> known;
  for (Benchmark const& b : all) known.push_back(b.name);
  std::vector<Benchmark> list;
  for (std::string const& name : names) {
    auto const found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) {
      auto const near = nearest(name, known);
      throw CLI::ValidationError(fmt::format("'{}' is no benchmark;{} 'talus bench --list' lists them", name,
                                             near ? fmt::format(" did you mean '{}'?", *near) : ""));
    }
    list.push_back(all[static_cast<std::size_t>(found - known.begin())]);
  }
  return list;
}

/// Results as they come; `missing` where a benchmark lacks a program that it needs.
std::vector<Measured> run(std::vector<Benchmark> const& list, Arguments const& a, bool& missing) {
  std::vector<Measured> all;
  for (Benchmark const& b : list) {
    say(fmt::format("{}: {}, about {} s", b.name, b.what, b.seconds));
    double const begin = seconds(Clock::wall);
    try {
      all.push_back({std::string(b.name), std::string(b.what), b.run(a.options), 0});
      all.back().seconds = seconds(Clock::wall) - begin;
      if (!a.json && a.against.empty()) fmt::print("{}", text_of(all.back()));
      std::fflush(stdout);
    } catch (Unavailable const& error) {
      missing = true;
      fmt::print(stderr, "talus-bench: {} is left out: {}\n", b.name, error.what());
    }
  }
  return all;
}

ExitCode bench(Arguments const& a) {
  auto const list = chosen(a.names);
  if (!a.folder.empty()) io::make_folder(a.folder, "results.json");
  nlohmann::json const earlier = a.against.empty() ? nlohmann::json() : json_of(io::read_file(a.against));
  bool missing = false;
  auto const start = io::utc_now();
  auto all = run(list, a, missing);
  if (!a.against.empty()) {
    compare(all, earlier);
    for (Measured const& measured : all)
      if (!a.json) fmt::print("{}", text_of(measured));
  }
  auto const document = document_of(all, provenance(a.command_line, start, a.options.threads));
  if (a.json) fmt::print("{}", io::json_text(document));
  if (!a.folder.empty()) {
    write_folder(a.folder, all, document);
    say("results in " + a.folder);
  }
  if (missing) return cli::not_in_this_build;
  return document["met"].get<bool>() ? cli::done : cli::expectation_failed;
}

int told(std::exception const& error) {
  fmt::print(stderr, "talus-bench: {}\n", error.what());
  if (dynamic_cast<InputError const*>(&error) != nullptr) return cli::input_invalid;
  if (dynamic_cast<RunError const*>(&error) != nullptr) return cli::computation_failed;
  if (dynamic_cast<FileError const*>(&error) != nullptr) return cli::file_system_error;
  return cli::internal_error;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  arguments.command_line.assign(argv, argv + argc);
  CLI::App app{"What Talus costs: machine limits, stages, ratios to a textbook solver, threads, instructions.",
               "talus bench"};
  declare(app, arguments);
  try {
    app.parse(argc, argv);
    if (!arguments.list) return bench(arguments);
    list(arguments.json);
    return cli::done;
  } catch (CLI::ParseError const& error) {
    return app.exit(error) == 0 ? cli::done : cli::usage_error;
  } catch (std::exception const& error) {
    return told(error);
  }
}

}  // namespace talus::bench

int main(int argc, char** argv) {
  return talus::bench::main(argc, argv);
}
