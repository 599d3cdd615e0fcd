#include "core/cli/study_cases.hpp"

#include <fmt/format.h>

namespace talus::cli {

namespace {

/// All cases of a study are held in memory before the first one runs.

std::vector<nlohmann::json> values_of(StudyPlan const& plan, std::size_t k) {
  std::vector<nlohmann::json> values(plan.axes.size());
  for (std::size_t a = plan.axes.size(); a-- > 0;) {
    values[a] = plan.axes[a].values[k % plan.axes[a].values.size()];
    k /= plan.axes[a].values.size();
  }
  return values;
}

std::string label_of(StudyPlan const& plan, std::vector<nlohmann::json> const& values) {
  std::string label;
  for (std::size_t a = 0; a < values.size(); ++a) {
    std::string const& path = plan.axes[a].path;
    label += fmt::format("{}{}={}", a > 0 ? " " : "", path.substr(path.find_last_of('/') + 1),
                         values[a].is_string() ? values[a].get<std::string>() : values[a].dump());
  }
  return label;
}

/// The resolved base case tells which members there are, those that were left out included.
Document document_of(StudyPlan const& plan, std::vector<nlohmann::json> const& values, std::string const& label) {
  nlohmann::json document = plan.base;
  for (std::size_t a = 0; a < values.size(); ++a) {
    try {
      nlohmann::json::json_pointer const pointer(plan.axes[a].path);
      if (pointer.empty() || !plan.resolved_base.contains(pointer))
        throw InputError(fmt::format("/axes/{}/path: '{}' leads nowhere in the base case", a, plan.axes[a].path));
      document[pointer] = values[a];
    } catch (nlohmann::json::exception const&) {
      throw InputError(fmt::format("/axes/{}/path: '{}' is no JSON pointer, such as /law/xi", a, plan.axes[a].path));
    }
  }
  if (!label.empty()) document["title"] = fmt::format("{} ({})", document["title"].get<std::string>(), label);
  return parse(document.dump(2), label);
}

}  // namespace

std::vector<StudyCase> cases_of(StudyPlan const& plan) {
  std::size_t count = 1;
  for (StudyAxis const& axis : plan.axes) {
    count *= axis.values.size();
    if (count > most_cases)
      throw InputError(
          fmt::format("/axes: found more combinations of their values than {}; at most {} are allowed: split the study",
                      most_cases, most_cases));
  }
  std::vector<StudyCase> cases;
  for (std::size_t k = 0; k < count; ++k) {
    auto values = values_of(plan, k);
    std::string label = label_of(plan, values);
    Document document = document_of(plan, values, label);
    cases.push_back({std::move(values), std::move(label), std::move(document)});
  }
  return cases;
}

std::vector<ExpectedValue> expected_at(StudyPlan const& plan, StudyCase const& study_case) {
  std::vector<ExpectedValue> expected;
  for (StudyExpectation const& e : plan.expect)
    if (e.at == study_case.values) expected.push_back(e.expected);
  return expected;
}

std::vector<std::string> study_mistakes(StudyPlan const& plan, std::vector<StudyCase> const& cases) {
  std::vector<std::string> wrong;
  for (StudyCase const& c : cases)
    for (Mistake const& mistake : program().check(c.document).mistakes)
      wrong.push_back(fmt::format("/axes: case {}: {}", c.label, mistake.text("its document")));
  for (std::size_t k = 0; k < plan.expect.size(); ++k) {
    bool known = false;
    for (StudyCase const& c : cases) known = known || c.values == plan.expect[k].at;
    if (!known)
      wrong.push_back(fmt::format("/expect/{}/at: found {}; expected: one of the combinations of the axes' values", k,
                                  nlohmann::json(plan.expect[k].at).dump()));
  }
  return wrong;
}

}  // namespace talus::cli
