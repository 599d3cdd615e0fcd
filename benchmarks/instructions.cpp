/// Instructions of a particle-step, counted by callgrind: what each part of a composition adds.

#include <fmt/format.h>
#include <gnu/libc-version.h>

#include <cmath>
#include <map>
#include <regex>
#include <sstream>

#include "benchmarks/places.hpp"
#include "benchmarks/process.hpp"
#include "benchmarks/registry.hpp"
#include "core/config/json.hpp"
#include "core/errors.hpp"
#include "core/io/files.hpp"
#include "core/io/text.hpp"

namespace talus::bench {

namespace {

constexpr double tolerance = 0.02;

struct Counts {
  std::string name, base;
  double instructions = 0;  ///< a particle-step
  int bytes = 0;            ///< a particle
};

std::string compiled_by() {
  return std::string(compiler) + ", glibc " + gnu_get_libc_version();
}

/// The rungs that talus-count has, those that are asked for.
std::vector<Counts> rungs(std::string const& filter) {
  Ran const listed = run_process({beside_this_program("talus-count").string()});
  if (listed.code != 0)
    throw Unavailable("talus-count, which is built with talus-bench, cannot be run: " + listed.said);
  std::vector<Counts> all;
  std::regex const wanted(filter);
  std::istringstream lines(listed.output);
  for (std::string line; std::getline(lines, line);) {
    auto const tab = line.find('\t');
    if (std::string const name = line.substr(0, tab); std::regex_search(name, wanted))
      all.push_back({name, line.substr(tab + 1)});
  }
  return all;
}

/// Lets callgrind count one of them. Throws Unavailable where there is no valgrind.
void count(Counts& rung, std::filesystem::path const& folder) {
  auto const file = folder / "callgrind.out";
  Ran const ran =
      run_process({"valgrind", "--tool=callgrind", "--callgrind-out-file=" + file.string(),
                   "--toggle-collect=*counted_steps*", beside_this_program("talus-count").string(), rung.name});
  if (ran.code == -1) throw Unavailable("instructions are counted by valgrind (Debian: valgrind): " + ran.said);
  if (ran.code != 0) throw Unavailable("valgrind cannot run talus-count:\n" + ran.said);
  std::size_t particles = 0;
  int steps = 0;
  std::istringstream(ran.output) >> particles >> steps >> rung.bytes;
  std::smatch found;
  std::string const profile = io::read_file(file);
  if (!std::regex_search(profile, found, std::regex("\ntotals: (\\d+)")) || particles == 0)
    throw Unavailable("callgrind's profile has no totals");
  rung.instructions = std::stod(found[1]) / static_cast<double>(particles) / steps;
}

/// The counts to compare with: none where they are another compiler's; then `why` says so.
std::map<std::string, double> baseline(std::string& why) {
  std::map<std::string, double> counts;
  if (!std::filesystem::exists(baseline_file)) {
    why = fmt::format("not compared: there is no {}", baseline_file);
    return counts;
  }
  auto const document = json_of(io::read_file(baseline_file));
  if (document.is_discarded()) throw InputError(fmt::format("{} is no JSON", baseline_file));
  std::string const theirs = document.at("compiler");
  if (theirs != compiled_by()) {
    why = fmt::format("not compared: the baseline is of {}, this is {}", theirs, compiled_by());
    return counts;
  }
  for (auto const& [name, entry] : document.at("counts").items()) counts[name] = entry.at("instructions");
  why = fmt::format("Baseline of {}, {}; a count may be {:g} % above it.", document.at("date").get<std::string>(),
                    theirs, 100 * tolerance);
  return counts;
}

void write_baseline(std::vector<Counts> const& rungs) {
  nlohmann::json counts = nlohmann::json::object();
  for (Counts const& rung : rungs)
    counts[rung.name] = {{"instructions", std::round(10 * rung.instructions) / 10}, {"bytes", rung.bytes}};
  nlohmann::json const document{{"schema", "talus/instructions/1"},
                                {"compiler", compiled_by()},
                                {"instruction_set", "x86-64-v3"},
                                {"date", io::utc_now().substr(0, 10)},
                                {"counts", counts}};
  std::filesystem::create_directories(std::filesystem::path(baseline_file).parent_path());
  io::write_atomically(baseline_file, io::json_text(document));
  say(fmt::format("instructions: wrote {}", baseline_file));
}

Row row_of(Counts const& rung, std::map<std::string, Counts> const& all, std::map<std::string, double> const& before) {
  Row row{rung.name, "instructions", exactly(rung.instructions), {}, {"", fmt::to_string(rung.bytes), ""}};
  if (auto const base = all.find(rung.base); base != all.end())
    row.more[0] = fmt::format("{:+.0f} to {}", rung.instructions - base->second.instructions, rung.base);
  if (auto const old = before.find(rung.name); old != before.end()) {
    row.bar = Bar{.most = std::round(10 * (1 + tolerance) * old->second) / 10};
    row.more[2] = fmt::format("{:+.1f} %", 100 * (rung.instructions / old->second - 1));
  }
  return row;
}

/// Bars in groups: each composition of a dimension ("2-D") by itself and with what is around it.
Chart chart_of(std::vector<Counts> const& rungs, std::string const& dimension) {
  Chart chart{"instructions_" + dimension.substr(0, 1) + "d",
              "Instructions of a particle-step, " + dimension + " quadratic, x86-64-v3", "", "instructions"};
  std::map<std::string, double> counts;
  for (Counts const& rung : rungs) {
    if (!rung.name.starts_with(dimension)) continue;
    std::string const name = rung.name.substr(dimension.size() + 1);
    counts[name] = rung.instructions;
    if (name.find(',') == std::string::npos) chart.labels.push_back(name);
  }
  for (std::string const around : {"", ", walls", ", friction", ", periodic"}) {
    Curve curve{around.empty() ? "nothing around" : around.substr(2)};
    bool any = false;
    for (std::string const& label : chart.labels) {
      auto const found = counts.find(label + around);
      any = any || found != counts.end();
      curve.y.push_back(found == counts.end() ? std::nan("") : found->second);
    }
    if (any) chart.curves.push_back(curve);
  }
  return chart;
}

}  // namespace

Result instructions(Options const& options) {
  std::vector<Counts> counted = rungs(options.filter);
  ScratchFolder const scratch;
  std::map<std::string, Counts> by_name;
  for (Counts& rung : counted) {
    say("instructions: " + rung.name);
    count(rung, scratch.path());
    by_name[rung.name] = rung;
  }
  if (options.update_baseline) write_baseline(counted);
  std::string why;
  auto const before = baseline(why);
  Table table{"Instructions of a particle-step, counted by callgrind; about 3500 particles, 20 steps without a sort",
              {"own part", "bytes a particle", "against baseline"}};
  for (Counts const& rung : counted) table.rows.push_back(row_of(rung, by_name, before));
  table.notes = {
      why,
      "Compiled for x86-64-v3 whatever the machine. 'friction': walls take it from the material. 'periodic': along x; "
      "there are then no blocks beyond the ends of the body, so it may cost less."};
  Result result{{table}};
  if (options.filter.empty()) result.charts = {chart_of(counted, "2-D"), chart_of(counted, "3-D")};
  return result;
}

}  // namespace talus::bench
