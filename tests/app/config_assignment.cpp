#include <boost/test/unit_test.hpp>
#include <string>

#include "core/config/json.hpp"
#include "core/errors.hpp"

BOOST_AUTO_TEST_SUITE(config_assignment)

using namespace talus;
using nlohmann::json;

namespace {

json const original = json_of(R"({"time": {"end": 1.5}, "bodies": [{"name": "a"}, {"name": "b"}], "a/b": 1})");

json after(std::string_view assignment) {
  json document = original;
  set_value(document, assignment);
  return document;
}

/// The message with which an assignment is refused, after a look that nothing was changed.
std::string refusal(std::string_view assignment) {
  json document = original;
  try {
    set_value(document, assignment);
  } catch (InputError const& error) {
    BOOST_TEST(document == original);
    return error.what();
  }
  return {};
}

bool has(std::string const& message, std::string_view part) {
  return message.find(part) != message.npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_value_is_replaced_by_json_of_any_kind) {
  BOOST_TEST(after("/time/end=2.5").at("time").at("end") == 2.5);
  BOOST_TEST(after("/bodies/1/name=\"c d\"").at("bodies").at(1).at("name") == "c d");
  BOOST_TEST(after("/bodies=[]").at("bodies") == json::array());
  BOOST_TEST(after("/time={\"end\": 3}").at("time").at("end") == 3);
  BOOST_TEST(after("/a~1b=true").at("a/b") == true);
}

BOOST_AUTO_TEST_CASE(a_bare_word_is_a_text) {
  BOOST_TEST(after("/title=dam-break_2.v").at("title") == "dam-break_2.v");
  BOOST_TEST(has(refusal("/title=a=b"), "double quotes"));
}

BOOST_AUTO_TEST_CASE(members_that_are_missing_on_the_way_are_made) {
  BOOST_TEST(after("/output/frames/every=0.1").at("output").at("frames").at("every") == 0.1);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_assigned_is_refused_and_nothing_changes) {
  BOOST_TEST(has(refusal("time=2"), "write it as /pointer=value"));
  BOOST_TEST(has(refusal("/time"), "write it as /pointer=value"));
  BOOST_TEST(has(refusal(""), "write it as /pointer=value"));
  BOOST_TEST(has(refusal("/time/end="), "is empty"));
  BOOST_TEST(has(refusal("/time/end=two words"), "double quotes"));
  BOOST_TEST(has(refusal("/time/end=1e400"), "too large"));
  BOOST_TEST(has(refusal("/time={\"end\": 1, \"end\": 2}"), "given twice"));
  BOOST_TEST(has(refusal("/bodies/2=1"), "no entry \"2\" in this list of 2"));
  BOOST_TEST(has(refusal("/bodies/01/name=x"), "no entry \"01\""));
  BOOST_TEST(has(refusal("/bodies/first/name=x"), "no entry \"first\""));
  BOOST_TEST(has(refusal("/time/end/deep=1"), "--set /time/end/deep: there is nothing below 1.5"));
}

BOOST_AUTO_TEST_CASE(a_value_that_was_set_has_no_place_in_the_text) {
  Document document = parse("{\"time\": {\"end\": 1,\n \"step\": 2}}", "a.json");
  set_value(document, "/time/end=2");
  BOOST_TEST(document.value.at("time").at("end") == 2);
  BOOST_TEST(!document.places.at("/time/end").is_known());
  BOOST_TEST((document.places.at("/time/step") == Place{2, 2}));
}

BOOST_AUTO_TEST_SUITE_END()
