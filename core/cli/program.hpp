#pragma once
/// What the command line asks of the models. `talus::program()` is defined where the models are (models/program.cpp),
/// so that core never includes them.

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/config/json.hpp"
#include "core/config/outline.hpp"
#include "core/config/read.hpp"
#include "core/experiment.hpp"
#include "core/material_point.hpp"

namespace talus {

/// What a quantity of the series should be at a time.
struct ExpectedValue {
  std::string measure;
  double time = 0, value = 0, tolerance = 0;  ///< tolerance in the unit of the measure
  std::string because;
};

/// What a case says about its run, besides the physics.
struct RunPlan {
  std::string title;
  std::vector<std::string> cite;
  double end = 0, frames_every = 0, series_every = 0, checkpoints_every = 0, profiles_every = 0;
  std::uint64_t seed = 0;  ///< of the first body that is seeded at random
  std::vector<ExpectedValue> expect;
};

/// A document that was read: its mistakes and warnings; where there are no mistakes, the document with all defaults.
struct CheckedCase {
  std::vector<Mistake> mistakes, warnings;
  nlohmann::json resolved;
};

struct Composed {
  std::unique_ptr<Experiment> experiment;
  RunPlan plan;
  nlohmann::json resolved;
  std::vector<std::string> warnings;
};

/// One axis of a study: the member to vary and the values that it takes.
struct StudyAxis {
  std::string path;
  std::vector<nlohmann::json> values;
};

/// An expectation that holds for the case at these values of the axes.
struct StudyExpectation {
  std::vector<nlohmann::json> at;
  ExpectedValue expected;
};

/// One column of a series over another.
struct PointPicture {
  std::string x, y;
};

/// A base case, varied along axes (full product).
struct StudyPlan {
  std::string title;
  std::vector<std::string> cite;
  nlohmann::json base;           ///< as given
  nlohmann::json resolved_base;  ///< with all defaults
  std::vector<StudyAxis> axes;
  std::vector<StudyExpectation> expect;
  std::vector<PointPicture> pictures, ends;  ///< of a material point: along the paths, and of their ends
};

/// A material point and its path.
struct ComposedPoint {
  std::unique_ptr<PointExperiment> point;
  std::vector<Segment> path;
  nlohmann::json resolved;
  std::vector<std::string> warnings;
};

/// A kind of policy and what there is of it.
struct PolicyKind {
  std::string_view name, meaning;
  std::vector<Alternative> policies;
};

class Program {
 public:
  Program() = default;
  Program(Program const&) = delete;
  virtual ~Program() = default;

  /// Every mistake of a case, study or material point, none of them thrown.
  [[nodiscard]] virtual CheckedCase check(Document const& document) const = 0;
  /// Throws InputError with every mistake.
  [[nodiscard]] virtual Composed compose(Document const& document) const = 0;
  /// Of a material point: one without axes. Throws InputError with every mistake.
  [[nodiscard]] virtual ComposedPoint compose_point(Document const& document) const = 0;
  /// Of a study or a material point. Throws InputError with every mistake.
  [[nodiscard]] virtual StudyPlan study(Document const& document) const = 0;
  [[nodiscard]] virtual nlohmann::json schema() const = 0;
  [[nodiscard]] virtual std::vector<PolicyKind> catalogue() const = 0;
  /// Tables of the documents themselves: case, study and point.
  [[nodiscard]] virtual std::vector<std::pair<std::string, Outline>> documents() const = 0;
};

/// The program's models.
[[nodiscard]] Program const& program();

/// Whether the tag of a document begins so.
[[nodiscard]] inline bool has_tag(nlohmann::json const& document, std::string_view start) {
  return document.is_object() && document.contains("schema") && document["schema"].is_string() &&
         document["schema"].get<std::string_view>().starts_with(start);
}
/// Whether a document is a study or a material point; else it is a case.
[[nodiscard]] inline bool is_study(nlohmann::json const& document) {
  return has_tag(document, "talus/study/");
}
[[nodiscard]] inline bool is_point(nlohmann::json const& document) {
  return has_tag(document, "talus/point/");
}

}  // namespace talus
