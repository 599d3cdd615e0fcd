#include "core/cli/program.hpp"

#include "core/config/manual.hpp"
#include "core/config/schema.hpp"
#include "core/config/write.hpp"
#include "models/compose.hpp"
#include "models/documents.hpp"

namespace talus {

namespace {

ExpectedValue expected_of(Expectation const& e) {
  return {e.measure, e.time, e.value, std::max(e.relative * std::abs(e.value), e.absolute), e.because};
}

nlohmann::json list_of(std::vector<AnyValue> const& list) {
  nlohmann::json out = nlohmann::json::array();
  for (AnyValue const& value : list) write(value, out.emplace_back());
  return out;
}

template <class Values>
void add_axes_and_expectations(Values const& values, StudyPlan& plan) {
  for (AxisEntry const& axis : values.axes) plan.axes.push_back({axis.path, list_of(axis.values)});
  for (auto const& e : values.expect) plan.expect.push_back({list_of(e.at), expected_of(e)});
}

StudyPlan plan_of(Study const& values, Document const& document) {
  StudyPlan plan{values.title, values.cite, document.value["base"], {}, {}, {}, {}, {}};
  write(values.base, plan.resolved_base);
  add_axes_and_expectations(values, plan);
  return plan;
}

/// The base is the document itself, without what varies and judges it.
StudyPlan plan_of(PointCase const& values, Document const& document) {
  StudyPlan plan{values.title, values.cite, document.value, {}, {}, {}, {}, {}};
  write(values, plan.resolved_base);
  for (auto* base : {&plan.base, &plan.resolved_base})
    for (auto const* part : {"axes", "expect"}) base->erase(part);
  add_axes_and_expectations(values, plan);
  for (PictureEntry const& p : values.pictures) plan.pictures.push_back({p.x, p.y});
  for (PictureEntry const& p : values.ends) plan.ends.push_back({p.x, p.y});
  return plan;
}

/// Reads by `read`, and keeps the mistakes and, where there are none, the echo.
template <class F>
CheckedCase checked_by(Document const& document, F const& read) {
  Reader reader(document);
  CheckedCase checked;
  auto const values = read(document, reader);
  if (reader.mistakes.empty()) write(values, checked.resolved);
  checked.mistakes = std::move(reader.mistakes);
  checked.warnings = std::move(reader.warnings);
  return checked;
}

/// The schema of the whole: which part holds depends on the tag.
nlohmann::json chosen_by_tag(nlohmann::json tags, nlohmann::json parts) {
  nlohmann::json whole = parts.back();
  for (std::size_t k = parts.size() - 1; k-- > 0;)
    whole = {{"if", {{"type", "object"}, {"properties", {{"schema", {{"const", tags[k]}}}}}}},
             {"then", parts[k]},
             {"else", whole}};
  return whole;
}

template <class List>
PolicyKind kind_of(std::string_view name, std::string_view meaning) {
  return {name, meaning, detail::outline_of_policies(List{})};
}

class Models final : public Program {
 public:
  [[nodiscard]] CheckedCase check(Document const& document) const override {
    if (is_study(document.value)) return checked_by(document, read_study);
    if (is_point(document.value)) return checked_by(document, read_point);
    return checked_by(document, read_case);
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
                     values.output.profiles_every.value_or(values.output.frames_every),
                     0,
                     {}};
    for (BodyEntry const& body : values.bodies)
      body.seeding.visit([&](auto, auto const& parameters) {
        if constexpr (requires { parameters.seed; }) composed.plan.seed = static_cast<std::uint64_t>(parameters.seed);
      });
    for (Expectation const& e : values.expect) composed.plan.expect.push_back(expected_of(e));
    composed.experiment = talus::compose(values, composed.warnings);
    return composed;
  }

  [[nodiscard]] ComposedPoint compose_point(Document const& document) const override {
    Reader reader(document);
    PointCase const values = read_point(document, reader);
    reader.throw_if_mistaken();
    ComposedPoint composed{talus::compose(values), path_of(values), {}, {}};
    for (Mistake const& warning : reader.warnings) composed.warnings.push_back(warning.text(document.name));
    write(values, composed.resolved);
    return composed;
  }

  [[nodiscard]] StudyPlan study(Document const& document) const override {
    Reader reader(document);
    auto const plan_by = [&](auto const& read) {
      auto const values = read(document, reader);
      reader.throw_if_mistaken();
      return plan_of(values, document);
    };
    return is_point(document.value) ? plan_by(read_point) : plan_by(read_study);
  }

  [[nodiscard]] nlohmann::json schema() const override {
    nlohmann::json parts = nlohmann::json::array();
    for (auto const& [name, outline] : documents()) {
      parts.push_back(talus::schema(outline, "Talus " + name));
      parts.back().erase("$schema");
    }
    nlohmann::json const tags{Case::tag, Study::tag, PointCase::tag};
    nlohmann::json whole{{"$schema", "http://json-schema.org/draft-07/schema#"},
                         {"title", "Talus case, study or material point"},
                         {"type", "object"},
                         {"required", {"schema"}},
                         {"properties", {{"schema", {{"enum", tags}}}}}};
    // the case last: a document without a tag that is known is judged as one
    whole.update(chosen_by_tag({tags[2], tags[1], tags[0]}, {parts[2], parts[1], parts[0]}));
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
            kind_of<catalogue::VelocityFields>("velocities", "Initial velocities"),
            kind_of<catalogue::Controls>("controls", "What leads a component of a material point")};
  }

  [[nodiscard]] std::vector<std::pair<std::string, Outline>> documents() const override {
    return {{"case", outline<Case>()}, {"study", outline<Study>()}, {"point", outline<PointCase>()}};
  }
};

}  // namespace

Program const& program() {
  static Models const models;
  return models;
}

}  // namespace talus
