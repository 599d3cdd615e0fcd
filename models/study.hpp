#pragma once
/// The document of a study: a base case, varied along axes, and what each variant should give.

#include "core/config/any_value.hpp"
#include "models/case.hpp"

namespace talus {

struct AxisEntry {
  std::string path;
  std::vector<AnyValue> values;
  static constexpr auto table() {
    return std::tuple{
        parameter(&AxisEntry::path, "path", "JSON pointer, within the base case, of the value to vary").required(),
        parameter(&AxisEntry::values, "values", "the values that it takes").required().sized(1)};
  }
};

struct StudyExpectationEntry : Expectation {
  std::vector<AnyValue> at;
  static constexpr auto table() {
    return std::tuple_cat(
        std::tuple{
            parameter(&StudyExpectationEntry::at, "at", "value of each axis, in the order of the axes").required()},
        Expectation::table());
  }
};

struct Study {
  std::string schema, title;
  std::vector<std::string> cite;
  Case base;
  std::vector<AxisEntry> axes;
  std::vector<StudyExpectationEntry> expect;

  static constexpr std::string_view tag = "talus/study/1";
  static constexpr auto table() {
    return std::tuple{parameter(&Study::schema, "schema", "kind and version of the document: talus/study/1").required(),
                      parameter(&Study::title, "title", "one line on what the study asks").required(),
                      parameter(&Study::cite, "cite", "DOIs of the work that the study stands on"),
                      parameter(&Study::base, "base", "the case that is varied").required(),
                      parameter(&Study::axes, "axes", "what is varied; every combination is run").required().sized(1),
                      parameter(&Study::expect, "expect", "what the cases should give")};
  }
};

}  // namespace talus
