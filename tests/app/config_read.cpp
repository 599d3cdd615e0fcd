#include "core/config/read.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string>

#include "core/config/json.hpp"
#include "core/errors.hpp"
#include "tests/app/config_sample.hpp"

BOOST_AUTO_TEST_SUITE(config_read)

using namespace talus;
using sample::Scene;

namespace {

struct Outcome {
  Scene scene;
  std::vector<Mistake> mistakes, warnings;
};

Outcome outcome_of(std::string_view text, int dimension = 2) {
  Document const document = parse(text, "a.json");
  Reader reader(document, dimension);
  Scene scene = read<Scene>(document.value, reader);
  return {std::move(scene), reader.mistakes, reader.warnings};
}

/// A scene that is right, with more text at its end, which begins in line 2.
std::string scene_with(std::string const& more) {
  return R"({"law": {"type": "elastic", "young_modulus": 2e5}, "bodies": [{"material": "sand"}],)"
         "\n" +
         more + "}";
}
std::string scene_with_law(std::string const& law) {
  return "{\"bodies\": [{\"material\": \"sand\"}],\n\"law\": " + law + "}";
}

/// The one mistake of a document; an empty one, with a failed test, if there are none or more.
Mistake mistake_in(std::string_view text, int dimension = 2) {
  std::vector<Mistake> const mistakes = outcome_of(text, dimension).mistakes;
  BOOST_TEST(mistakes.size() == 1U, text);
  for (Mistake const& mistake : mistakes) BOOST_TEST_MESSAGE(mistake.text("a.json"));
  return mistakes.size() == 1 ? mistakes.front() : Mistake{};
}

bool has(std::string const& text, std::string_view part) {
  return text.find(part) != text.npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_not_given_has_the_value_of_its_initialiser) {
  auto const [scene, mistakes, warnings] = outcome_of(sample::shortest);
  BOOST_TEST((mistakes.empty() && warnings.empty()));
  BOOST_TEST(scene.title == "untitled");
  BOOST_TEST((scene.steps == 10 && scene.seed == 1U && scene.slope_deg == 0 && !scene.stop));
  BOOST_TEST(scene.times == (std::vector<double>{0.5, 1}), boost::test_tools::per_element());
  BOOST_TEST((scene.space.kernel.holds<sample::Spline>() && scene.law.holds<sample::Elastic>()));
  BOOST_TEST(scene.bodies.at(0).density == 1000);
}

BOOST_AUTO_TEST_CASE(values_of_every_kind_are_read) {
  auto const [scene, mistakes, warnings] = outcome_of(R"({
    "title": "all", "steps": 3e2, "seed": 18446744073709549568, "slope_deg": 22.5, "times": [], "stop": {"speed": 0.1}, "notes": [1e-3, "a"],
    "space": {"dimension": 3, "periodic": [true, false, true], "kernel": {"type": "linear"}},
    "law": {"type": "friction", "young_modulus": 1e5, "mu_2": 0.7, "grain": {"diameter": 2e-3}},
    "bodies": [{"material": "a", "high": [3, 2, 1]}, {"material": "b", "density": 1}], "probes": [[1, 2, 3]]})",
                                                      3);
  BOOST_TEST((mistakes.empty() && warnings.empty()));
  BOOST_TEST((scene.title == "all" && scene.steps == 300 && scene.seed == 18446744073709549568U));
  BOOST_TEST((scene.slope_deg == 22.5 && scene.times.empty() && scene.stop.value().speed == 0.1));
  BOOST_TEST((scene.space.dimension == 3 && scene.space.periodic == std::vector<bool>{true, false, true}));
  BOOST_TEST(scene.space.kernel.holds<sample::Linear>());
  bool const is_friction = visit(scene.law, []<class Q>(std::type_identity<Q>, auto const& p) {
    if constexpr (std::same_as<Q, sample::Friction>) {
      return p.E == 1e5 && p.nu == 0.3 && p.mu_2 == 0.7 && p.grain.diameter == 2e-3;
    }
    return false;
  });
  BOOST_TEST(is_friction);
  BOOST_TEST(
      (scene.bodies.size() == 2 && scene.bodies[0].high == Coordinates{3, 2, 1} && scene.bodies[1].density == 1));
  BOOST_TEST((scene.notes == std::vector<AnyValue>{{.text = "0.001"}, {.text = "\"a\""}}));
  BOOST_TEST((scene.probes.size() == 1 && scene.probes[0] == Coordinates{1, 2, 3}));
}

BOOST_AUTO_TEST_CASE(a_default_of_a_list_with_one_entry_an_axis_fits_the_space) {
  Scene const scene = outcome_of(sample::shortest, 3).scene;
  BOOST_TEST((scene.bodies.at(0).low == Coordinates{0, 0, 0} && scene.bodies.at(0).high == Coordinates{1, 1, 0}));
  BOOST_TEST(scene.space.periodic.size() == 3U);
}

BOOST_AUTO_TEST_CASE(an_initialiser_of_a_group_goes_before_those_of_its_members) {
  Scene const scene = outcome_of(scene_with_law(R"({"type": "friction", "young_modulus": 1e5})")).scene;
  double const diameter = visit(scene.law, []<class Q>(std::type_identity<Q>, auto const& p) {
    if constexpr (std::same_as<Q, sample::Friction>) return p.grain.diameter;
    return 0.0;
  });
  BOOST_TEST(diameter == 7e-4);  // of Friction; Grain itself has 1e-3
}

BOOST_AUTO_TEST_CASE(an_unknown_name_is_refused_with_the_nearest) {
  Mistake const mistake =
      mistake_in(scene_with_law("{\"type\": \"friction\", \"young_modulus\": 1e5,\n \"posson_ratio\": 0.2}"));
  BOOST_TEST(mistake.pointer == "/law/posson_ratio");
  BOOST_TEST((mistake.place == Place{3, 2}));
  BOOST_TEST(mistake.found == "the unknown name \"posson_ratio\"");
  BOOST_TEST(has(mistake.expected, "\"poisson_ratio\", \"mu_1\""));
  BOOST_TEST(mistake.advice == "did you mean \"poisson_ratio\"?");
}

BOOST_AUTO_TEST_CASE(a_misspelt_required_name_is_both_unknown_and_missing) {
  auto const mistakes = outcome_of(scene_with_law(R"({"type": "elastic", "youngs_modulas": 1e5})")).mistakes;
  BOOST_REQUIRE(mistakes.size() == 2U);
  BOOST_TEST(mistakes[0].pointer == "/law/youngs_modulas");
  BOOST_TEST(mistakes[0].advice == "did you mean \"young_modulus\"?");
  BOOST_TEST((mistakes[1].pointer == "/law/young_modulus" && mistakes[1].found == "nothing"));
}

BOOST_AUTO_TEST_CASE(a_symbol_in_place_of_a_name_is_understood) {
  auto const mistakes = outcome_of(scene_with_law(R"({"type": "elastic", "E": 1e5})")).mistakes;
  BOOST_REQUIRE(mistakes.size() == 2U);
  BOOST_TEST(mistakes[0].advice == "did you mean \"young_modulus\"?");
}

BOOST_AUTO_TEST_CASE(a_value_of_the_wrong_kind_is_refused) {
  Mistake const quoted = mistake_in(scene_with(R"("slope_deg": "1e1")"));
  BOOST_TEST((quoted.pointer == "/slope_deg" && quoted.place == Place{2, 1} && quoted.found == "the text \"1e1\""));
  BOOST_TEST((quoted.expected == "a number, 0 <= x < 90 [deg]" && quoted.advice == "remove the quotes"));
  BOOST_TEST(mistake_in(scene_with(R"("slope_deg": null)")).advice == "leave it out to take the default");
  BOOST_TEST(mistake_in(scene_with(R"("slope_deg": true)")).found == "true");
  BOOST_TEST(mistake_in(scene_with(R"("slope_deg": [1])")).found == "a list of 1");
  BOOST_TEST(mistake_in(scene_with(R"("title": 3)")).advice == "put it in double quotes");
  BOOST_TEST(mistake_in(scene_with(R"("times": 3)")).advice == "write a list: [3]");
  BOOST_TEST(mistake_in(scene_with(R"("space": [2])")).expected == "an object {...}");
  BOOST_TEST(mistake_in(scene_with(R"("space": {"periodic": [0, true]})")).pointer == "/space/periodic/0");
  BOOST_TEST(mistake_in(scene_with(R"("notes": [1, null])")).expected == "a number, a text, true or false");
  BOOST_TEST(mistake_in("[1]").pointer.empty());
}

BOOST_AUTO_TEST_CASE(a_count_is_neither_negative_nor_a_fraction) {
  BOOST_TEST(mistake_in(scene_with(R"("steps": 2.7)")).expected == "a whole number, x >= 1");
  BOOST_TEST(mistake_in(scene_with(R"("steps": -3)")).found == "the number -3");
  BOOST_TEST(mistake_in(scene_with(R"("steps": 1e19)")).expected == "a whole number, 1 <= x <= 9223372036854774784");
  BOOST_TEST(mistake_in(scene_with(R"("seed": -1)")).pointer == "/seed");
  BOOST_TEST(mistake_in(scene_with(R"("seed": 0.5)")).pointer == "/seed");
  BOOST_TEST(mistake_in(scene_with(R"("space": {"dimension": 2.5})")).pointer == "/space/dimension");
}

BOOST_AUTO_TEST_CASE(a_number_outside_its_range_is_refused_with_the_range) {
  std::string const law = R"({"type": "friction", "young_modulus": 1e5, "poisson_ratio": )";
  for (std::string const value : {"0.5", "-1", "3e5"}) {
    Mistake const mistake = mistake_in(scene_with_law(law + value + "}"));
    BOOST_TEST(mistake.pointer == "/law/poisson_ratio");
    BOOST_TEST(mistake.expected == "a number, -1 < x < 0.5");
  }
  BOOST_TEST(outcome_of(scene_with_law(law + "-0.99}")).mistakes.empty());
  BOOST_TEST(mistake_in(scene_with(R"("times": [0, -1, 2])")).pointer == "/times/1");
}

BOOST_AUTO_TEST_CASE(what_is_required_is_missed_at_the_line_of_what_should_hold_it) {
  Mistake const mistake = mistake_in(scene_with("\"stop\": {}"));
  BOOST_TEST(mistake.text("a.json") ==
             "a.json:2:1: /stop/speed: found nothing; expected: a number, x > 0 [m/s]: slower than this; "
             "it has no default, so add it");
  auto const mistakes = outcome_of("{}").mistakes;
  BOOST_REQUIRE(mistakes.size() == 2U);
  BOOST_TEST((mistakes[0].pointer == "/law" && mistakes[0].place == Place{1, 1}));
  BOOST_TEST((mistakes[1].pointer == "/bodies"));
}

BOOST_AUTO_TEST_CASE(a_parameter_of_another_policy_is_refused) {
  Mistake const mistake = mistake_in(scene_with(R"("space": {"kernel": {"type": "linear", "degree": 2}})"));
  BOOST_TEST((mistake.pointer == "/space/kernel/degree" && mistake.expected == "\"type\""));
}

BOOST_AUTO_TEST_CASE(values_that_do_not_fit_together_are_refused) {
  Mistake const mistake =
      mistake_in(scene_with_law(R"({"type": "friction", "young_modulus": 1e5, "mu_1": 0.9, "mu_2": 0.1})"));
  BOOST_TEST(mistake.text("a.json") == "a.json:2:1: /law: mu_1 must not exceed mu_2");
}

BOOST_AUTO_TEST_CASE(coordinates_have_one_entry_for_each_axis) {
  std::string const text =
      "{\"law\": {\"type\": \"elastic\", \"young_modulus\": 1},\n"
      "\"bodies\": [{\"material\": \"a\",\n\"low\": [0, 1, 2]}]}";
  Mistake const mistake = mistake_in(text, 2);
  BOOST_TEST((mistake.pointer == "/bodies/0/low" && mistake.place == Place{3, 1}));
  BOOST_TEST((mistake.found == "a list of 3" && has(mistake.expected, "2 entries, one for each axis")));
  BOOST_TEST(outcome_of(text, 3).mistakes.empty());
  BOOST_TEST(outcome_of(text, 0).mistakes.empty());
  BOOST_TEST(mistake_in(scene_with(R"("probes": [[1]])"), 0).pointer == "/probes/0");
  BOOST_TEST(mistake_in(scene_with(R"("space": {"periodic": [true]})")).pointer == "/space/periodic");
}

BOOST_AUTO_TEST_CASE(lists_have_as_many_entries_as_their_table_says) {
  BOOST_TEST(mistake_in(R"({"law": {"type": "elastic", "young_modulus": 1}, "bodies": []})").expected ==
             "a list of at least 1 entry, each an object {...}");
  BOOST_TEST(mistake_in(scene_with(R"("times": [1, 2, 3, 4, 5])")).pointer == "/times");
}

BOOST_AUTO_TEST_CASE(an_unknown_policy_is_refused_with_all_names_and_the_nearest) {
  Mistake const mistake = mistake_in(scene_with_law(R"({"type": "elastik", "anything": 1})"));
  BOOST_TEST((mistake.pointer == "/law/type" && mistake.place == Place{2, 9}));
  BOOST_TEST(mistake.expected == "one of \"elastic\", \"friction\"");
  BOOST_TEST(mistake.advice == "did you mean \"elastic\"?");
  BOOST_TEST(mistake_in(scene_with_law("{\"young_modulus\": 1}")).pointer == "/law/type");
  BOOST_TEST(mistake_in(scene_with_law(R"({"type": 3})")).found == "the number 3");
  BOOST_TEST(mistake_in(scene_with_law("\"elastic\"")).advice == "write {\"type\": \"elastic\"}");
}

BOOST_AUTO_TEST_CASE(no_mistake_hides_another) {
  auto const mistakes = outcome_of(R"({"titel": 1, "law": {"type": "friction", "young_modulus": -1, "mu_1": "a"},
    "bodies": [{"material": "a", "density": 0}, {"low": [0]}, 7], "space": {"kernel": {"type": "cubic"}}, "steps": 0})")
                            .mistakes;
  std::vector<std::string> pointers;
  for (Mistake const& mistake : mistakes) pointers.push_back(mistake.pointer);
  std::sort(pointers.begin(), pointers.end());
  std::vector<std::string> const expected = {"/bodies/0/density",  "/bodies/1/low", "/bodies/1/material",
                                             "/bodies/2",          "/law/mu_1",     "/law/young_modulus",
                                             "/space/kernel/type", "/steps",        "/titel"};
  BOOST_TEST(pointers == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_value_outside_the_validated_range_is_a_warning_that_names_the_source) {
  auto const [scene, mistakes, warnings] = outcome_of(scene_with_law(R"({"type": "friction", "young_modulus": 1e-3})"));
  BOOST_TEST(mistakes.empty());
  BOOST_REQUIRE(warnings.size() == 1U);
  BOOST_TEST(warnings[0].text("a.json") ==
             "a.json:2:29: /law/young_modulus: found the number 0.001; expected: a number, 10000 <= x <= 1e+09 [Pa], "
             "the range validated by a made-up source; is the unit right?");
}

BOOST_AUTO_TEST_CASE(all_mistakes_are_thrown_together) {
  Document const document = parse("{\n\"steps\": 0, \"seed\": -1}", "a.json");
  auto const names_all = [](InputError const& error) {
    std::string const message = error.what();
    return has(message, "a.json:2:1: /steps") && has(message, "a.json:2:13: /seed") && has(message, ": /law: ");
  };
  BOOST_CHECK_EXCEPTION((void)read_or_throw<Scene>(document), InputError, names_all);
  BOOST_TEST(read_or_throw<Scene>(parse(sample::shortest, "a.json"), 2).bodies.size() == 1U);
}

BOOST_AUTO_TEST_CASE(a_mistake_that_was_set_names_no_line) {
  Document document = parse(sample::shortest, "a.json");
  set_value(document, "/law/young_modulus=-1");
  Reader reader(document, 2);
  (void)read<Scene>(document.value, reader);
  BOOST_REQUIRE(reader.mistakes.size() == 1U);
  BOOST_TEST(!reader.mistakes[0].place.is_known());
}

BOOST_AUTO_TEST_CASE(the_dimension_is_found_before_anything_else_is_read) {
  Document const document = parse(R"({"space": {"dimension": 3, "other": 4, "word": "2"}})", "a.json");
  BOOST_TEST(find_dimension(document.value, "/space/dimension") == 3);
  BOOST_TEST(find_dimension(document.value, "/space/other") == 0);
  BOOST_TEST(find_dimension(document.value, "/space/word") == 0);
  BOOST_TEST(find_dimension(document.value, "/space/word/deeper") == 0);
  BOOST_TEST(find_dimension(document.value, "/nothing") == 0);
}

BOOST_AUTO_TEST_SUITE_END()
