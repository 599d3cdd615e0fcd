#include <fmt/format.h>

#include <optional>

#include "core/cli/runner.hpp"
#include "core/cli/show.hpp"
#include "core/cli/stopping.hpp"
#include "core/cli/study_cases.hpp"
#include "core/io/files.hpp"
#include "core/io/run_folder.hpp"

namespace talus::cli {

namespace {

namespace fs = std::filesystem;

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

/// How a case ended earlier; none where it has not, or where what it left is not whole.
std::optional<RunResult> ended_earlier(fs::path const& folder, bool quiet) try {
  io::Outcome const outcome = io::read_status(folder).outcome;
  if (outcome != io::Outcome::done && outcome != io::Outcome::failed) return {};
  fs::path const file = folder / "summary.json";
  nlohmann::json summary = parse(io::read_file(file), file.string()).value;
  for (char const* name : {"finished", "steps", "wall_seconds"}) static_cast<void>(summary.at(name));
  RunResult result{static_cast<ExitCode>(summary.at("exit_code").get<int>()), {}, std::move(summary)};
  if (outcome == io::Outcome::failed) {
    if (!quiet) fmt::print(stderr, "it failed earlier: {}\n", result.summary.at("failure").get<std::string>());
    return result;
  }
  result.verdicts = verdicts_of(result.summary.at("expectations"));
  io::Series const series = io::read_series(folder / "series.csv");
  auto const* const times = series.find("time");
  bool const whole = times != nullptr && !times->empty() && times->back() == result.summary.at("time").get<double>() &&
                     result.summary.at("measures").is_object() && result.summary.at("finished").get<bool>();
  return whole ? std::optional(std::move(result)) : std::nullopt;
} catch (nlohmann::json::exception const&) {  // a file that is not whole: what it said is computed again
  return {};
} catch (InputError const&) {
  return {};
} catch (FileError const&) {
  return {};
}

/// Whether a folder holds this very case, begun.
bool holds(fs::path const& folder, std::string const& given) try {
  static_cast<void>(io::read_status(folder));
  return fs::exists(folder / "resolved.json") && io::read_file(folder / "case.json") == given;
} catch (FileError const&) {
  return false;
}

/// Runs a case, or goes on with what its folder holds of it, which may be all of it.
RunResult run_or_resume(StudyCase const& study_case, RunOptions own) {
  std::string const given = study_case.document.value.dump(2) + "\n";
  if (!holds(own.folder, given)) {
    if (fs::exists(own.folder)) io::remove_run(own.folder);
    own.force = true;
    return run_case(study_case.document, given, own);
  }
  auto ended = ended_earlier(own.folder, own.quiet);
  return ended ? std::move(*ended) : resume_case(own);
}

/// What the study and its cases expect, of a case that came to its end.
std::vector<Verdict> verdicts_on(StudyPlan const& plan, StudyCase const& study_case, RunResult const& result,
                                 fs::path const& folder) {
  std::vector<Verdict> verdicts = result.verdicts;
  for (Verdict& v : verdicts) v.where = study_case.label;
  if (result.code == computation_failed || !result.summary.at("finished").get<bool>()) return verdicts;
  for (Verdict& v : judge(expected_at(plan, study_case), io::read_series(folder / "series.csv"), study_case.label))
    verdicts.push_back(std::move(v));
  return verdicts;
}

RunResult run_cases(StudyPlan const& plan, std::vector<StudyCase> const& cases, StudyFolder const& folder,
                    RunOptions const& options) {
  RunResult total;
  nlohmann::json results = nlohmann::json::array();
  for (std::size_t k = 0; k < cases.size(); ++k) {
    RunOptions own = options;
    own.folder = folder.path() / StudyFolder::case_folder(k);
    if (!options.quiet) fmt::print(stderr, "case {} of {}: {}\n", k + 1, cases.size(), cases[k].label);
    RunResult result = run_or_resume(cases[k], own);
    if (result.code == stopped) {
      folder.remove_results();
      return result;
    }
    for (Verdict& v : verdicts_on(plan, cases[k], result, own.folder)) total.verdicts.push_back(std::move(v));
    if (result.code == computation_failed) total.code = computation_failed;
    nlohmann::json row = std::move(result.summary);
    row["at"] = cases[k].values;
    row["folder"] = StudyFolder::case_folder(k);
    results.push_back(std::move(row));
  }
  for (Verdict const& v : total.verdicts)
    if (!v.passed && total.code == done) total.code = expectation_failed;
  total.summary = {{"title", plan.title}, {"cases", results}, {"expectations", verdict_document(total.verdicts)}};
  folder.write("results.json", total.summary.dump(2) + "\n");
  folder.write("results.csv", results_table(plan, results));
  return total;
}

RunResult run_cases_with_advice(StudyPlan const& plan, std::vector<StudyCase> const& cases, StudyFolder const& folder,
                                RunOptions const& options) {
  try {
    return run_cases(plan, cases, folder, options);
  } catch (FileError const& error) {
    throw FileError(
        fmt::format("{}\n'talus resume {}' goes on with the whole study", error.what(), folder.path().string()));
  }
}

}  // namespace

BegunStudy begin_study(StudyPlan const& plan, Document const& document, std::string_view given,
                       RunOptions const& options) {
  std::vector<StudyCase> cases = cases_of(plan);
  std::string wrong;
  for (std::string const& mistake : study_mistakes(plan, cases))
    wrong += fmt::format("\n{}: {}", document.name, mistake);
  if (!wrong.empty()) throw InputError(wrong.substr(1));
  note_stop_signals();
  return {StudyFolder::create(options.folder, options.force, document, given), std::move(cases)};
}

RunResult run_study(Document const& document, std::string_view given, RunOptions const& options) {
  StudyPlan const plan = program().study(document);
  BegunStudy const study = begin_study(plan, document, given, options);
  return run_cases_with_advice(plan, study.cases, study.folder, options);
}

RunResult resume_study(RunOptions const& options) {
  note_stop_signals();
  StudyFolder const folder = StudyFolder::open(options.folder);
  Document const document = folder.document();
  if (is_point(document.value))
    throw CheckpointError(
        fmt::format("there is nothing to resume in {}: it is the folder of a material point; run its document again "
                    "with --force",
                    options.folder.string()));
  StudyPlan const plan = program().study(document);
  return run_cases_with_advice(plan, cases_of(plan), folder, options);
}

}  // namespace talus::cli
