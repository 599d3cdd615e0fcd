#include <fmt/format.h>

#include "core/cli/runner.hpp"
#include "core/io/files.hpp"

namespace talus::cli {

namespace {

/// The values that the axes take in case number k; the last axis varies fastest.
std::vector<nlohmann::json> values_of(StudyPlan const& plan, std::size_t k) {
  std::vector<nlohmann::json> values(plan.axes.size());
  for (std::size_t a = plan.axes.size(); a-- > 0;) {
    values[a] = plan.axes[a].values[k % plan.axes[a].values.size()];
    k /= plan.axes[a].values.size();
  }
  return values;
}

/// "/gravity/slope_deg = 22, /materials/0/law/beta = 0.1" without the folders of the pointers.
std::string label_of(StudyPlan const& plan, std::vector<nlohmann::json> const& values) {
  std::string label;
  for (std::size_t a = 0; a < values.size(); ++a) {
    std::string const& path = plan.axes[a].path;
    std::string const name = path.substr(path.find_last_of('/') + 1);
    label +=
        (a > 0 ? " " : "") + name + "=" + (values[a].is_string() ? values[a].get<std::string>() : values[a].dump());
  }
  return label;
}

Document case_of(StudyPlan const& plan, std::vector<nlohmann::json> const& values, std::string const& label) {
  nlohmann::json document = plan.base;
  for (std::size_t a = 0; a < values.size(); ++a) {
    nlohmann::json::json_pointer const pointer(plan.axes[a].path);
    if (!document.contains(pointer.parent_pointer()))
      throw InputError("/axes/" + std::to_string(a) + "/path: '" + plan.axes[a].path +
                       "' leads nowhere in the base case");
    document[pointer] = values[a];
  }
  std::string const title =
      document.contains("title") && document["title"].is_string() ? document["title"].get<std::string>() : "";
  document["title"] = title + " (" + label + ")";
  return parse(document.dump(2), label);
}

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

RunResult run_study(Document const& document, std::string_view given, RunOptions const& options) {
  StudyPlan const plan = program().study(document);
  std::size_t count = 1;
  for (StudyAxis const& axis : plan.axes) count *= axis.values.size();
  std::vector<Document> cases;
  for (std::size_t k = 0; k < count; ++k) {
    auto const values = values_of(plan, k);
    cases.push_back(case_of(plan, values, label_of(plan, values)));
    CheckedCase const checked = program().check(cases.back());
    if (!checked.mistakes.empty())
      throw InputError("case " + cases.back().name + " of the study: " + checked.mistakes.front().text(document.name));
  }
  std::filesystem::create_directories(options.folder / "cases");
  io::write_atomically(options.folder / "study.json", given);

  RunResult total;
  nlohmann::json results = nlohmann::json::array();
  for (std::size_t k = 0; k < count; ++k) {
    auto const values = values_of(plan, k);
    RunOptions own = options;
    std::string const folder = fmt::format("case_{:03}", k);
    own.folder = options.folder / "cases" / folder;
    if (!options.quiet) fmt::print(stderr, "case {} of {}: {}\n", k + 1, count, cases[k].name);
    RunResult result = run_case(cases[k], cases[k].value.dump(2) + "\n", own);
    if (result.code == stopped) return result;
    for (Verdict& v : result.verdicts) {
      v.where = cases[k].name;
      total.verdicts.push_back(v);
    }
    std::vector<ExpectedValue> expected;
    for (StudyExpectation const& e : plan.expect)
      if (e.at == values) expected.push_back(e.expected);
    if (result.code == done || result.code == expectation_failed)
      for (Verdict const& v : judge(expected, io::read_series(own.folder / "series.csv"), cases[k].name))
        total.verdicts.push_back(v);
    if (result.code == computation_failed) total.code = computation_failed;
    nlohmann::json row = std::move(result.summary);
    row["at"] = values;
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
