#include "core/config/schema.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <string>

#include "core/config/json.hpp"
#include "core/config/read.hpp"
#include "tests/app/config_sample.hpp"

BOOST_AUTO_TEST_SUITE(config_schema)

using namespace talus;
using nlohmann::json;
using sample::Scene;

namespace {

/// A judge of its own: the words of draft-07 that our schemas use, after
/// https://json-schema.org/draft-07/json-schema-validation. Throws at any word that it does not know.
class Judge {
 public:
  static bool accepts(json const& schema, json const& value) {
    return std::all_of(schema.items().begin(), schema.items().end(),
                       [&](auto const& word) { return holds(word.key(), word.value(), schema, value); });
  }

 private:
  static bool holds(std::string const& word, json const& rule, json const& schema, json const& value) {
    if (word == "type") return is_of_type(rule, value);
    if (word == "enum") return std::find(rule.begin(), rule.end(), value) != rule.end();
    if (word == "const") return rule == value;
    if (word == "if") return !accepts(rule, value) || accepts(schema.at("then"), value);
    if (word == "allOf") return std::all_of(rule.begin(), rule.end(), [&](json const& s) { return accepts(s, value); });
    if (word == "anyOf") return std::any_of(rule.begin(), rule.end(), [&](json const& s) { return accepts(s, value); });
    if (is_one_of(word, {"minimum", "maximum", "exclusiveMinimum", "exclusiveMaximum"})) {
      return !value.is_number() || is_within(word, rule, value);
    }
    if (is_one_of(word, {"items", "minItems", "maxItems"})) return !value.is_array() || suits_list(word, rule, value);
    if (is_one_of(word, {"properties", "required", "additionalProperties"})) {
      return !value.is_object() || suits_object(word, rule, schema, value);
    }
    bool const only_explains =
        is_one_of(word, {"then", "title", "description", "default", "$schema", "x-unit", "x-symbol"});
    return only_explains ? true : throw std::invalid_argument("a word that is not known: " + word);
  }

  static bool is_one_of(std::string const& word, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
  }

  static bool is_of_type(std::string const& type, json const& value) {
    if (type == "integer") return value.is_number() && std::nearbyint(value.get<double>()) == value.get<double>();
    if (type == "number") return value.is_number();
    return type == value.type_name();  // object, array, string, boolean
  }

  static bool is_within(std::string const& word, double limit, double value) {
    if (word == "minimum") return value >= limit;
    if (word == "maximum") return value <= limit;
    return word == "exclusiveMinimum" ? value > limit : value < limit;
  }

  static bool suits_list(std::string const& word, json const& rule, json const& list) {
    if (word == "items") return std::all_of(list.begin(), list.end(), [&](json const& v) { return accepts(rule, v); });
    if (word == "minItems") return list.size() >= rule;
    return list.size() <= rule;
  }

  static bool suits_object(std::string const& word, json const& rule, json const& schema, json const& object) {
    if (word == "required") {
      return std::all_of(rule.begin(), rule.end(), [&](json const& name) { return object.contains(name); });
    }
    auto const has_rule = [&](auto const& part) { return schema.at("properties").contains(part.key()); };
    if (word == "properties") {
      return std::all_of(object.items().begin(), object.items().end(), [&](auto const& part) {
        return !has_rule(part) || accepts(rule.at(part.key()), part.value());
      });
    }
    return std::all_of(object.items().begin(), object.items().end(), has_rule);
  }
};

/// Documents that are right, and such with one mistake, made from the shortest one.
std::vector<std::string> const good = {
    "/title=\"x\"",
    "/steps=1",
    "/steps=3e2",
    "/seed=0",
    "/slope_deg=0",
    "/slope_deg=89.9",
    "/times=[]",
    "/notes=[1, \"a\", true, 0.5]",
    "/times=[0, 1, 2, 3]",
    "/probes=[[0, 1]]",
    "/stop={\"speed\": 1e-9}",
    "/space={}",
    "/space/dimension=3",
    "/space/periodic=[true, false]",
    "/space/kernel={\"type\": \"linear\"}",
    "/space/kernel={\"type\": \"spline\"}",
    "/space/kernel={\"type\": \"spline\", \"degree\": 3}",
    "/bodies/0/low=[0, -1]",
    "/bodies/0/density=1",
    "/law={\"type\": \"friction\", \"young_modulus\": 1e5, \"poisson_ratio\": -0.9, \"grain\": {}}",
    "/law={\"type\": \"friction\", \"young_modulus\": 1e5, \"grain\": {\"diameter\": 0.1}}"};
std::vector<std::string> const bad = {
    "/titel=\"x\"",
    "/notes=[null]",
    "/notes=[[1]]",
    "/notes=[{}]",
    "/title=3",
    "/title=null",
    "/steps=0",
    "/steps=2.7",
    "/steps=-1",
    "/steps=\"3\"",
    "/steps=1e19",
    "/seed=-1",
    "/seed=0.5",
    "/seed=2e19",
    "/slope_deg=90",
    "/slope_deg=-1",
    "/slope_deg=\"1e1\"",
    "/slope_deg=true",
    "/times=1",
    "/times=[-1]",
    "/times=[0, 1, 2, 3, 4]",
    "/times=[\"a\"]",
    "/probes=[[0]]",
    "/probes=[[0, 1, 2, 3]]",
    "/probes=[0, 1]",
    "/stop={}",
    "/stop=null",
    "/stop={\"speed\": 0}",
    "/stop={\"sped\": 1}",
    "/space=2",
    "/space/dimension=4",
    "/space/dimension=2.5",
    "/space/dimension=1e10",
    "/space/periodic=[0, 1]",
    "/space/periodic=[true]",
    "/space/kernel=linear",
    "/space/kernel={}",
    "/space/kernel={\"type\": \"cubic\"}",
    "/space/kernel={\"type\": 3}",
    "/space/kernel={\"type\": \"linear\", \"degree\": 2}",
    "/space/kernel={\"type\": \"spline\", \"degree\": 4}",
    "/bodies=[]",
    "/bodies=[{}]",
    "/bodies=[7]",
    "/bodies={}",
    "/bodies/0/low=[0]",
    "/bodies/0/low=[0, \"1\"]",
    "/bodies/0/density=0",
    "/bodies/0/mass=1",
    "/law={}",
    "/law=\"elastic\"",
    "/law={\"type\": \"elastic\"}",
    "/law={\"type\": \"elastic\", \"young_modulus\": 0}",
    "/law={\"type\": \"elastic\", \"young_modulus\": 1, \"mu_1\": 1}",
    "/law={\"type\": \"friction\", \"young_modulus\": 1e5, \"poisson_ratio\": 0.5}",
    "/law={\"type\": \"friction\", \"young_modulus\": 1e5, \"grain\": {\"diameter\": 0}}",
    "/law={\"type\": \"friction\", \"young_modulus\": 1e5, \"grain\": {\"size\": 1}}"};

json const& scene_schema() {
  static json const made = schema(outline<Scene>(), "Scene");
  return made;
}

bool reader_accepts(Document const& document) {
  Reader reader(document);
  (void)read<Scene>(document.value, reader);
  return reader.mistakes.empty();
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_schema_accepts_what_the_reader_accepts) {
  BOOST_TEST(Judge::accepts(scene_schema(), json_of(sample::shortest)));
  for (std::string const& change : good) {
    Document document = parse(sample::shortest, "a.json");
    set_value(document, change);
    BOOST_TEST(reader_accepts(document), change);
    BOOST_TEST(Judge::accepts(scene_schema(), document.value), change);
  }
}

BOOST_AUTO_TEST_CASE(the_schema_refuses_what_the_reader_refuses) {
  for (std::string const& change : bad) {
    Document document = parse(sample::shortest, "a.json");
    set_value(document, change);
    BOOST_TEST(!reader_accepts(document), change);
    BOOST_TEST(!Judge::accepts(scene_schema(), document.value), change);
  }
  for (std::string_view const text : {"{}", "[]", "3", "null", "{\"law\": {\"type\": \"linear\"}}"}) {
    BOOST_TEST(!reader_accepts(parse(text, "a.json")), text);
    BOOST_TEST(!Judge::accepts(scene_schema(), json_of(text)), text);
  }
}

BOOST_AUTO_TEST_CASE(every_default_is_accepted_by_its_own_schema) {
  std::size_t defaults = 0;
  auto const visit_all = [&](auto const& self, json const& schema) -> void {
    if (schema.is_object() && schema.contains("default")) {
      ++defaults;
      BOOST_TEST(Judge::accepts(schema, schema.at("default")), schema.dump());
    }
    if (schema.is_structured()) {
      for (json const& part : schema) self(self, part);
    }
  };
  visit_all(visit_all, scene_schema());
  BOOST_TEST(defaults ==
             18U);  // title; space 3, spline 1; friction 4; a body 3; steps, seed, slope, times, probes, notes
}

BOOST_AUTO_TEST_CASE(a_number_carries_its_bounds_default_unit_and_meaning) {
  json const& law = scene_schema().at("properties").at("law").at("allOf").at(1).at("then");
  BOOST_TEST(law.at("properties").at("poisson_ratio") == json_of(R"({"type": "number", "exclusiveMinimum": -1.0,
    "exclusiveMaximum": 0.5, "default": 0.3, "description": "Poisson's ratio", "x-unit": "1", "x-symbol": "\\nu"})"));
  BOOST_TEST(law.at("properties").at("young_modulus") == json_of(R"({"type": "number", "exclusiveMinimum": 0.0,
    "description": "Young's modulus [Pa]", "x-unit": "Pa", "x-symbol": "E"})"));
  BOOST_TEST(law.at("required") == json_of(R"(["type", "young_modulus"])"));
  BOOST_TEST(law.at("additionalProperties") == false);
}

BOOST_AUTO_TEST_CASE(a_choice_is_told_by_its_type_not_by_trial) {
  std::string const text = scene_schema().dump();
  BOOST_TEST(text.find("oneOf") == text.npos);
  json const& law = scene_schema().at("properties").at("law");
  BOOST_TEST(law.at("properties").at("type").at("enum") == json_of(R"(["elastic", "friction"])"));
  BOOST_TEST(law.at("allOf").at(0).at("if").at("properties").at("type").at("const") == "elastic");
}

BOOST_AUTO_TEST_SUITE_END()
