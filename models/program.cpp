#include "core/cli/program.hpp"

#include "core/config/manual.hpp"
#include "core/config/schema.hpp"
#include "core/config/write.hpp"
#include "models/compose.hpp"
#include "models/study.hpp"

namespace talus {

namespace {

ExpectedValue expected_of(Expectation const& e) {
  return {e.measure, e.time, e.value, std::max(e.relative * std::abs(e.value), e.absolute), e.because};
}

/// Reads a P whose space is that of the kinematics at `space`, and gathers what its table cannot say.
template <class P>
P read_with_space(Document const& document, Reader& reader, std::string const& space) {
  nlohmann::json::json_pointer const pointer(space);
  if (document.value.is_object() && document.value.contains(pointer) && document.value[pointer].is_string())
    reader.dimension = dimension_of_kinematics(document.value[pointer].get<std::string>());
  return read<P>(document.value, reader);
}

/// Adds what the consistency check finds, with the pointer put behind `base`.
void add_inconsistencies(Case const& values, std::string const& base, Reader& reader) {
  for (std::string const& text : inconsistencies(values)) {
    auto const colon = text.find(": ");
    std::string const pointer = base + text.substr(0, colon);
    reader.refuse(pointer, text.substr(colon + 2), {});
  }
}

Case read_case(Document const& document, Reader& reader) {
  Case values = read_with_space<Case>(document, reader, "/kinematics/type");
  if (reader.mistakes.empty()) add_inconsistencies(values, "", reader);
  return values;
}

Study read_study(Document const& document, Reader& reader) {
  Study values = read_with_space<Study>(document, reader, "/base/kinematics/type");
  if (!reader.mistakes.empty()) return values;
  if (values.schema != Study::tag) reader.refuse("/schema", "'" + values.schema + "'", std::string(Study::tag));
  Case base = values.base;
  for (StudyExpectationEntry const& entry : values.expect) base.expect.push_back(entry);
  add_inconsistencies(base, "/base", reader);
  for (std::size_t k = 0; k < values.expect.size(); ++k)
    if (values.expect[k].at.size() != values.axes.size())
      reader.refuse("/expect/" + std::to_string(k) + "/at", std::to_string(values.expect[k].at.size()) + " values",
                    "one for each of the " + std::to_string(values.axes.size()) + " axes");
  return values;
}

template <class List>
PolicyKind kind_of(std::string_view name, std::string_view meaning) {
  return {name, meaning, detail::outline_of_policies(List{})};
}

class Models final : public Program {
 public:
  [[nodiscard]] CheckedCase check(Document const& document) const override {
    Reader reader(document);
    CheckedCase checked;
    if (is_study(document.value)) {
      Study const values = read_study(document, reader);
      if (reader.mistakes.empty()) write(values, checked.resolved);
    } else {
      Case const values = read_case(document, reader);
      if (reader.mistakes.empty()) write(values, checked.resolved);
    }
    checked.mistakes = std::move(reader.mistakes);
    checked.warnings = std::move(reader.warnings);
    return checked;
  }

  [[nodiscard]] Composed compose(Document const& document) const override {
    Reader reader(document);
    Case const values = read_case(document, reader);
    reader.throw_if_mistaken();
    Composed composed;
    for (Mistake const& warning : reader.warnings) composed.warnings.push_back(warning.text(document.name));
    write(values, composed.resolved);
    composed.plan = {values.title,
                     values.cite,
                     values.time.end,
                     values.output.frames_every,
                     values.output.series_every,
                     values.output.checkpoints_every,
                     0,
                     {}};
    for (BodyEntry const& body : values.bodies)
      body.seeding.visit([&](auto, auto const& parameters) {
        if constexpr (requires { parameters.seed; }) composed.plan.seed = static_cast<std::uint64_t>(parameters.seed);
      });
    for (Expectation const& e : values.expect) composed.plan.expect.push_back(expected_of(e));
    composed.experiment = talus::compose(values);
    return composed;
  }

  [[nodiscard]] StudyPlan study(Document const& document) const override {
    Reader reader(document);
    Study const values = read_study(document, reader);
    reader.throw_if_mistaken();
    StudyPlan plan{values.title, values.cite, document.value["base"], {}, {}, {}};
    write(values.base, plan.resolved_base);
    auto const json_of = [](std::vector<AnyValue> const& list) {
      std::vector<nlohmann::json> out;
      for (AnyValue const& value : list) write(value, out.emplace_back());
      return out;
    };
    for (AxisEntry const& axis : values.axes) plan.axes.push_back({axis.path, json_of(axis.values)});
    for (StudyExpectationEntry const& e : values.expect) plan.expect.push_back({json_of(e.at), expected_of(e)});
    return plan;
  }

  [[nodiscard]] nlohmann::json schema() const override {
    nlohmann::json const of_case = talus::schema(outline<Case>(), "Talus case");
    nlohmann::json const of_study = talus::schema(outline<Study>(), "Talus study");
    nlohmann::json whole{{"$schema", "http://json-schema.org/draft-07/schema#"},
                         {"title", "Talus case or study"},
                         {"type", "object"},
                         {"required", {"schema"}},
                         {"properties", {{"schema", {{"enum", {Case::tag, Study::tag}}}}}}};
    whole["if"] = {{"type", "object"}, {"properties", {{"schema", {{"const", Study::tag}}}}}};
    whole["then"] = of_study;
    whole["else"] = of_case;
    for (auto const* part : {"then", "else"}) whole[part].erase("$schema");
    return whole;
  }

  [[nodiscard]] std::vector<PolicyKind> catalogue() const override {
    return {PolicyKind{"laws", "Constitutive laws: stress of the strain, and the return map",
                       OpenChoice<ChosenLaw>::alternatives()},
            kind_of<catalogue::Kinematics>("kinematics", "Space, and the shape of strain and stress in it"),
            kind_of<catalogue::Kernels>("kernels", "Weights between particles and nodes"),
            kind_of<catalogue::Transfers>("transfers", "How velocities pass between particles and nodes"),
            kind_of<catalogue::Integrators>("integrators", "Order of the stages of a step"),
            kind_of<catalogue::Shapes>("walls", "Shapes of walls"),
            kind_of<catalogue::Contacts>("contacts", "What a wall does to what touches it"),
            kind_of<catalogue::Motions>("motions", "How a wall moves"),
            kind_of<catalogue::Bodies>("bodies", "Regions that are filled with particles"),
            kind_of<catalogue::Seedings>("seedings", "How a region is filled"),
            kind_of<catalogue::VelocityFields>("velocities", "Initial velocities")};
  }

  [[nodiscard]] std::vector<std::pair<std::string, Outline>> documents() const override {
    return {{"case", outline<Case>()}, {"study", outline<Study>()}};
  }
};

}  // namespace

Program const& program() {
  static Models const models;
  return models;
}

}  // namespace talus
