#include "core/cli/show.hpp"

#include <fmt/format.h>

#include <set>

#include "core/cli/study_cases.hpp"
#include "core/config/manual.hpp"
#include "core/config/nearest.hpp"
#include "core/config/schema.hpp"
#include "core/io/files.hpp"

namespace talus::cli {

Document load(std::string const& path, std::vector<std::string> const& assignments) {
  Document document = parse(io::read_file(path), path);
  for (std::string const& assignment : assignments) set_value(document, assignment);
  return document;
}

ExitCode check(std::vector<std::string> const& files, bool json) {
  nlohmann::json report = nlohmann::json::array();
  bool good = true;
  auto const say = [&](std::string const& file, std::string const& kind, std::string const& text) {
    if (json)
      report.push_back({{"file", file}, {"kind", kind}, {"text", text}});
    else
      fmt::print("{}: {}\n", kind, text);
  };
  for (std::string const& file : files) {
    try {
      Document const document = load(file, {});
      CheckedCase const checked = program().check(document);
      for (Mistake const& mistake : checked.mistakes) say(file, "mistake", mistake.text(file));
      for (Mistake const& warning : checked.warnings) say(file, "warning", warning.text(file));
      std::vector<std::string> further;
      if (checked.mistakes.empty() && (is_study(document.value) || is_point(document.value))) {
        StudyPlan const plan = program().study(document);
        further = study_mistakes(plan, cases_of(plan));
      }
      for (std::string const& mistake : further) say(file, "mistake", fmt::format("{}: {}", file, mistake));
      bool const valid = checked.mistakes.empty() && further.empty();
      good = good && valid;
      if (valid) say(file, "valid", file);
    } catch (InputError const& error) {
      good = false;
      say(file, "mistake", error.what());
    }
  }
  if (json) fmt::print("{}\n", report.dump(2));
  return good ? done : input_invalid;
}

namespace {

nlohmann::json lines_document(std::vector<Explanation::Line> const& lines) {
  nlohmann::json document = nlohmann::json::array();
  for (auto const& line : lines) document.push_back({{"name", line.name}, {"text", line.text}});
  return document;
}

void print_lines(std::string_view heading, std::vector<Explanation::Line> const& lines) {
  std::size_t width = 0;
  for (auto const& line : lines) width = std::max(width, line.name.size());
  fmt::print("\n{}\n", heading);
  for (auto const& line : lines) fmt::print("  {:{}}  {}\n", line.name, width, line.text);
}

}  // namespace

namespace {

void refuse_study(Document const& document) {
  if (is_point(document.value))
    throw InputError(document.name +
                     ": this is a material point, which is composed of its law alone; 'talus point' runs it");
  if (is_study(document.value))
    throw InputError(document.name +
                     ": this is a study; give one of its cases, as in runs/NAME/cases/case_000/case.json");
}

}  // namespace

void explain(Document const& document, bool json) {
  refuse_study(document);
  Composed const composed = program().compose(document);
  Explanation const told = composed.experiment->explain();
  double const steps = composed.plan.end / told.first_step.dt;
  if (json) {
    nlohmann::json out{{"title", composed.plan.title},
                       {"dimension", told.dimension},
                       {"policies", lines_document(told.policies)},
                       {"fields", lines_document(told.fields)},
                       {"stages", lines_document(told.stages)},
                       {"left_out", lines_document(told.left_out)},
                       {"bytes_per_particle", told.bytes_per_particle},
                       {"padded_bytes_per_particle", told.padded_bytes_per_particle},
                       {"particles", told.particles},
                       {"blocks", told.blocks},
                       {"memory_bytes", told.bytes},
                       {"dt", told.first_step.dt},
                       {"limiter", told.first_step.limiter},
                       {"limited_by", told.limited_by},
                       {"wave_speed", told.wave_speed},
                       {"courant", told.courant},
                       {"expected_steps", steps}};
    fmt::print("{}\n", out.dump(2));
    return;
  }
  fmt::print("{}\n{} dimensions, {} particles in {} blocks\n", composed.plan.title, told.dimension, told.particles,
             told.blocks);
  print_lines("Composed of", told.policies);
  print_lines("Stored of a particle", told.fields);
  fmt::print("  {} B a particle in the step; {:.1f} B with the empty lanes; {:.1f} MB in all with the grid\n",
             told.bytes_per_particle, told.padded_bytes_per_particle, 1e-6 * static_cast<double>(told.bytes));
  print_lines("A step runs", told.stages);
  print_lines("Left out", told.left_out);
  fmt::print("\nTime step\n  dt = {:.4g} s, limited by: {}: {}\n  fastest wave {:.4g} m/s, c dt/h = {:.3f}\n",
             told.first_step.dt, told.first_step.limiter, told.limited_by, told.wave_speed, told.courant);
  fmt::print("  about {:.3g} steps to t = {} s, {:.3g} particle-steps\n", steps, composed.plan.end,
             steps * static_cast<double>(told.particles));
}

void list(std::string const& kind, bool json) {
  auto const kinds = program().catalogue();
  nlohmann::json out = nlohmann::json::object();
  bool found = kind.empty();
  std::string names;
  for (PolicyKind const& k : kinds) {
    names += (names.empty() ? "" : ", ") + std::string(k.name);
    if (!kind.empty() && kind != k.name) continue;
    found = true;
    if (!json) fmt::print("{}: {}\n", k.name, k.meaning);
    for (Alternative const& policy : k.policies) {
      if (json)
        out[std::string(k.name)].push_back({{"name", policy.name}, {"title", policy.title}});
      else
        fmt::print("  {:40} {}\n", policy.name, policy.title);
    }
  }
  if (!found) throw InputError("'" + kind + "' is no kind of policy; there are: " + names);
  if (json) fmt::print("{}\n", out.dump(2));
}

void describe(std::string const& name, bool json) {
  std::vector<std::string_view> known;
  auto const documents = program().documents();  // kept: `known` looks into it
  for (auto const& [title, outline] : documents) {
    known.push_back(title);
    if (title != name) continue;
    if (json)
      fmt::print("{}\n", schema(outline, title).dump(2));
    else
      fmt::print("# The document of a {}\n\n{}", title, parameter_table(outline.parts));
    return;
  }
  bool found = false;
  nlohmann::json pages = nlohmann::json::array();
  for (PolicyKind const& kind : program().catalogue())
    for (Alternative const& policy : kind.policies) {
      known.push_back(policy.name);
      if (policy.name != name) continue;
      found = true;
      if (json)
        pages.push_back({{"kind", kind.name},
                         {"name", policy.name},
                         {"title", policy.title},
                         {"source", policy.source},
                         {"page", policy_page(policy)}});
      else
        fmt::print("({})\n{}", kind.name, policy_page(policy));
    }
  if (json && found) fmt::print("{}\n", pages.dump(2));
  if (!found) {
    auto const near = nearest(name, known);
    throw InputError("nothing is called '" + name + "';" + (near ? " did you mean '" + std::string(*near) + "'?" : "") +
                     " 'talus list' shows what there is");
  }
}

namespace {

/// The citations of a document and the names of the policies that it composes.
std::pair<std::set<std::string>, std::set<std::string>> cited_by(Document const& document) {
  if (is_point(document.value)) {
    StudyPlan const plan = program().study(document);
    return {{plan.cite.begin(), plan.cite.end()},
            {plan.resolved_base["law"]["type"], plan.resolved_base["kinematics"]["type"]}};
  }
  refuse_study(document);
  Composed const composed = program().compose(document);
  std::set<std::string> names;
  for (auto const& line : composed.experiment->explain().policies)
    names.insert(line.text.substr(0, line.text.find(':')));
  return {{composed.plan.cite.begin(), composed.plan.cite.end()}, names};
}

}  // namespace

void cite(Document const& document, bool json) {
  auto [sources, names] = cited_by(document);
  for (PolicyKind const& kind : program().catalogue())
    for (Alternative const& policy : kind.policies)
      if (names.contains(std::string(policy.name)) && !policy.source.empty())
        sources.insert(std::string(policy.source) + "  [" + std::string(policy.name) + "]");
  if (json)
    fmt::print("{}\n", nlohmann::json(sources).dump(2));
  else
    for (std::string const& source : sources) fmt::print("{}\n", source);
}

std::string manual() {
  std::string text = "# Manual\n\nMade by `talus describe --all` from the tables in the code; do not edit.\n";
  for (auto const& [title, outline] : program().documents())
    text += fmt::format("\n## The document of a {}\n\n{}", title, parameter_table(outline.parts));
  for (PolicyKind const& kind : program().catalogue()) {
    text += fmt::format("\n## {}\n\n{}.\n", kind.name, kind.meaning);
    for (Alternative const& policy : kind.policies) text += fmt::format("\n{}", policy_page(policy));
  }
  return text;
}

}  // namespace talus::cli
