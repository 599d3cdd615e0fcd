#include <fmt/format.h>

#include "core/cli/runner.hpp"
#include "core/cli/study_cases.hpp"
#include "core/io/files.hpp"

namespace talus::cli {

namespace {

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
  if (!options.force && std::filesystem::exists(options.folder) && !std::filesystem::is_empty(options.folder))
    throw FileError(fmt::format("{} is not empty; give another folder or --force", options.folder.string()));
  std::filesystem::create_directories(options.folder / "cases");
  io::write_atomically(options.folder / "study.json", given);
  return cases;
}

RunResult run_study(Document const& document, std::string_view given, RunOptions const& options) {
  StudyPlan const plan = program().study(document);
  std::vector<StudyCase> const cases = begin_study(plan, document, given, options);
  RunResult total;
  nlohmann::json results = nlohmann::json::array();
  for (std::size_t k = 0; k < cases.size(); ++k) {
    RunOptions own = options;
    std::string const folder = fmt::format("case_{:03}", k);
    own.folder = options.folder / "cases" / folder;
    if (!options.quiet) fmt::print(stderr, "case {} of {}: {}\n", k + 1, cases.size(), cases[k].label);
    RunResult result = run_case(cases[k].document, cases[k].document.value.dump(2) + "\n", own);
    if (result.code == stopped) return result;
    for (Verdict& v : result.verdicts) {
      v.where = cases[k].label;
      total.verdicts.push_back(v);
    }
    if (result.code == done || result.code == expectation_failed)
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

}  // namespace talus::cli
