#include <fmt/format.h>

#include <optional>

#include "core/cli/runner.hpp"
#include "core/cli/show.hpp"
#include "core/cli/study_cases.hpp"
#include "core/io/files.hpp"

namespace talus::cli {

namespace {

namespace fs = std::filesystem;

/// The document as it ran, changes of the command line included: what `talus resume` reads.
constexpr char const* study_as_run = "resolved_study.json";

std::string results_table(StudyPlan const& plan, nlohmann::json const& results) {
  std::string text;
  for (StudyAxis const& axis : plan.axes) text += fmt::format("{},", axis.path);
  text += "folder,exit_code,steps,wall_seconds";
  for (nlohmann::json const& row : results)
    if (row.contains("measures")) {
      for (auto const& [name, value] : row["measures"].items()) text += fmt::format(",{}", name);
      break;
    }
  text += '\n';
  for (nlohmann::json const& row : results) {
    for (nlohmann::json const& value : row["at"]) text += fmt::format("{},", value.dump());
    text += fmt::format("{},{},{},{}", row["folder"].get<std::string>(), row["exit_code"].dump(), row["steps"].dump(),
                        row["wall_seconds"].dump());
    if (row.contains("measures"))
      for (auto const& [name, value] : row["measures"].items()) text += fmt::format(",{}", value.dump());
    text += '\n';
  }
  return text;
}

}  // namespace

std::vector<StudyCase> begin_study(StudyPlan const& plan, Document const& document, std::string_view given,
                                   RunOptions const& options) {
  std::vector<StudyCase> cases = cases_of(plan);
  std::string wrong;
  for (std::string const& mistake : study_mistakes(plan, cases))
    wrong += fmt::format("\n{}: {}", document.name, mistake);
  if (!wrong.empty()) throw InputError(wrong.substr(1));
  if (!options.force && fs::exists(options.folder) && !fs::is_empty(options.folder))
    throw FileError(fmt::format("{} is not empty; give another folder or --force", options.folder.string()));
  fs::create_directories(options.folder / "cases");
  for (char const* of_earlier : {"results.json", "results.csv", study_as_run}) fs::remove(options.folder / of_earlier);
  io::write_atomically(options.folder / "study.json", given);
  return cases;
}

namespace {

/// How a case ended earlier; none where it has not, or where its folder is of another case.
std::optional<RunResult> ended_earlier(fs::path const& folder) {
  fs::path const file = folder / "summary.json";
  if (!fs::exists(file)) return {};
  nlohmann::json summary = parse(io::read_file(file), file.string()).value;
  auto const code = static_cast<ExitCode>(summary.at("exit_code").get<int>());
  if (code != computation_failed && !summary.at("finished").get<bool>()) return {};
  RunResult result{code, {}, std::move(summary)};
  if (result.summary.contains("expectations")) result.verdicts = verdicts_of(result.summary.at("expectations"));
  return result;
}

/// Runs a case. `resumed`: goes on with what its folder holds of this very case, which may be all of it.
RunResult run_or_resume(StudyCase const& study_case, RunOptions own, bool resumed) {
  std::string const given = study_case.document.value.dump(2) + "\n";
  bool const begun = resumed && fs::exists(own.folder / "resolved.json") && fs::exists(own.folder / "case.json") &&
                     io::read_file(own.folder / "case.json") == given;
  if (!begun) {
    own.force = own.force || resumed;
    return run_case(study_case.document, given, own);
  }
  auto ended = ended_earlier(own.folder);
  return ended ? std::move(*ended) : resume_case(own);
}

RunResult run_cases(StudyPlan const& plan, std::vector<StudyCase> const& cases, RunOptions const& options,
                    bool resumed) {
  RunResult total;
  nlohmann::json results = nlohmann::json::array();
  for (std::size_t k = 0; k < cases.size(); ++k) {
    RunOptions own = options;
    std::string const folder = fmt::format("case_{:03}", k);
    own.folder = options.folder / "cases" / folder;
    if (!options.quiet) fmt::print(stderr, "case {} of {}: {}\n", k + 1, cases.size(), cases[k].label);
    RunResult result = run_or_resume(cases[k], own, resumed);
    if (result.code == stopped) return result;
    for (Verdict& v : result.verdicts) {
      v.where = cases[k].label;
      total.verdicts.push_back(v);
    }
    if (result.code != computation_failed && result.summary.at("finished").get<bool>())
      for (Verdict const& v :
           judge(expected_at(plan, cases[k]), io::read_series(own.folder / "series.csv"), cases[k].label))
        total.verdicts.push_back(v);
    if (result.code == computation_failed) total.code = computation_failed;
    nlohmann::json row = std::move(result.summary);
    row["at"] = cases[k].values;
    row["folder"] = "cases/" + folder;
    results.push_back(std::move(row));
  }
  for (Verdict const& v : total.verdicts)
    if (!v.passed && total.code == done) total.code = expectation_failed;
  total.summary = {{"title", plan.title}, {"cases", results}, {"expectations", verdict_document(total.verdicts)}};
  io::write_atomically(options.folder / "results.json", total.summary.dump(2) + "\n");
  io::write_atomically(options.folder / "results.csv", results_table(plan, results));
  return total;
}

}  // namespace

RunResult run_study(Document const& document, std::string_view given, RunOptions const& options) {
  StudyPlan const plan = program().study(document);
  std::vector<StudyCase> const cases = begin_study(plan, document, given, options);
  io::write_atomically(options.folder / study_as_run, document.value.dump(2) + "\n");
  return run_cases(plan, cases, options, false);
}

bool holds_study(fs::path const& folder) {
  return fs::exists(folder / study_as_run);
}

RunResult resume_study(RunOptions const& options) {
  StudyPlan const plan = program().study(load((options.folder / study_as_run).string(), {}));
  return run_cases(plan, cases_of(plan), options, true);
}

}  // namespace talus::cli
