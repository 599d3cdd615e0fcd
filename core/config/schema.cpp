#include "core/config/schema.hpp"

namespace talus {

namespace {

using nlohmann::json;

json schema_of(Outline const& outline);

json schema_of_members(std::vector<Outline> const& parts, json properties, json required) {
  for (Outline const& part : parts) {
    properties[std::string(part.row.name)] = schema_of(part);
    if (must_be_given(part)) required.push_back(part.row.name);
  }
  json schema = {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
  if (!required.empty()) schema["required"] = std::move(required);
  return schema;
}

json schema_of_choice(std::vector<Alternative> const& alternatives) {
  json names = json::array(), cases = json::array();
  for (Alternative const& alternative : alternatives) {
    names.push_back(alternative.name);
    json const type = {{"type", "string"}, {"const", alternative.name}};
    json then = schema_of_members(alternative.parameters, json::object({{"type", type}}), json::array({"type"}));
    then["title"] = alternative.title;
    json const condition = {
        {"type", "object"}, {"properties", json::object({{"type", type}})}, {"required", json::array({"type"})}};
    cases.push_back({{"if", condition}, {"then", std::move(then)}});
  }
  return {{"type", "object"},
          {"properties", json::object({{"type", {{"type", "string"}, {"enum", std::move(names)}}}})},
          {"required", json::array({"type"})},
          {"allOf", std::move(cases)}};
}

void add_bounds(json& schema, Range const& range) {
  if (range.bounded_below()) schema[range.low_is_open ? "exclusiveMinimum" : "minimum"] = range.low;
  if (range.bounded_above()) schema[range.high_is_open ? "exclusiveMaximum" : "maximum"] = range.high;
}

json schema_of_list(Outline const& outline) {
  json schema = {{"type", "array"}, {"items", schema_of(outline.parts.front())}};
  if (outline.row.size.least > 0) schema["minItems"] = outline.row.size.least;
  if (outline.row.size.most < Size{}.most) schema["maxItems"] = outline.row.size.most;
  return schema;
}

json schema_of_kind(Outline const& outline) {
  switch (outline.kind) {
    case Kind::number:
    case Kind::integer: {
      json schema = {{"type", outline.kind == Kind::number ? "number" : "integer"}};
      add_bounds(schema, outline.possible);
      return schema;
    }
    case Kind::boolean:
      return {{"type", "boolean"}};
    case Kind::text:
      return {{"type", "string"}};
    case Kind::any:
      return {{"anyOf", json::array({{{"type", "number"}}, {{"type", "string"}}, {{"type", "boolean"}}})}};
    case Kind::list:
      return schema_of_list(outline);
    case Kind::group:
      return schema_of_members(outline.parts, json::object(), json::array());
    case Kind::choice:
      break;
  }
  return schema_of_choice(outline.alternatives);
}

json schema_of(Outline const& outline) {
  json schema = schema_of_kind(outline);
  Description const& row = outline.row;
  bool const has_unit = !row.unit.empty() && row.unit != "1";
  if (!row.meaning.empty()) {
    schema["description"] = std::string(row.meaning) + (has_unit ? " [" + std::string(row.unit) + ']' : "");
  }
  if (!row.unit.empty()) schema["x-unit"] = row.unit;
  if (!row.symbol.empty()) schema["x-symbol"] = row.symbol;
  if (outline.initial) schema["default"] = *outline.initial;
  return schema;
}

}  // namespace

json schema(Outline const& document, std::string_view title) {
  json whole = schema_of(document);
  whole["$schema"] = "http://json-schema.org/draft-07/schema#";
  whole["title"] = title;
  return whole;
}

}  // namespace talus
