#include <boost/test/unit_test.hpp>
#include <random>
#include <string>

#include "core/config/json.hpp"
#include "core/errors.hpp"

BOOST_AUTO_TEST_SUITE(config_json)

using namespace talus;

namespace {

/// The message with which a text is refused; empty if it is accepted.
std::string refusal(std::string_view text) {
  try {
    (void)parse(text, "a.json");
  } catch (InputError const& error) {
    return error.what();
  }
  return {};
}

bool has(std::string const& message, std::string_view part) {
  return message.find(part) != message.npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_empty_text_is_refused) {
  BOOST_TEST(refusal("") == "a.json: is empty; a JSON document is needed, at least {}");
  BOOST_TEST(refusal(" \n\t") == refusal(""));
  BOOST_TEST(refusal("\xEF\xBB\xBF") == refusal(""));
}

BOOST_AUTO_TEST_CASE(a_comma_too_many_is_shown_where_it_hurts) {
  BOOST_TEST(refusal("{\"a\": 1,\n}") == "a.json:2:1: the comma before this bracket is one too many; remove it");
  BOOST_TEST(has(refusal("[1,\n 2,\n  ]"), "a.json:3:3: the comma before"));
}

BOOST_AUTO_TEST_CASE(comments_are_refused) {
  for (std::string_view const text : {"// no\n{}", "/* no */ {}", "# no\n{}"}) {
    BOOST_TEST(refusal(text) == "a.json:1:1: comments are not allowed; remove it");
  }
  BOOST_TEST(has(refusal("{\n  \"a\": 1, // why\n \"b\": 2}"), "a.json:2:11: comments"));
}

BOOST_AUTO_TEST_CASE(nan_and_infinity_are_refused) {
  for (std::string const word : {"NaN", "nan", "Infinity", "-Infinity", "inf", "-inf"}) {
    BOOST_TEST(has(refusal("{\"a\": " + word + "}"), "a.json:1:7: no value of JSON (NaN and infinity"), word);
  }
}

BOOST_AUTO_TEST_CASE(a_number_beyond_double_is_refused) {
  BOOST_TEST(has(refusal("{\"a\":\n1e400}"), "a.json:2:1: the number is too large"));
  BOOST_TEST(has(refusal("[-1e400]"), "a.json:1:2: the number is too large"));
  BOOST_TEST(refusal("[1.7976931348623157e308, 4e-324]").empty());
}

BOOST_AUTO_TEST_CASE(a_name_given_twice_is_refused_with_both_lines) {
  BOOST_TEST(refusal("{\"a\": {\"b\": 1,\n \"c\": 0,\n \"b\": 2}}") ==
             "a.json:3:2: /a/b: given twice, first in line 1; remove one of them");
  BOOST_TEST(has(refusal(R"([{"x": 1, "\u0078": 2}])"), "/0/x: given twice"));  // one name, written in two ways
  BOOST_TEST(has(refusal(R"({"a/b~": 1, "a/b~": 2})"), "/a~1b~0: given twice"));
  BOOST_TEST(refusal(R"([{"x": 1}, {"x": 2}, {"y": {"x": 3}, "x": "x"}])").empty());
}

BOOST_AUTO_TEST_CASE(every_name_given_twice_is_reported_but_not_what_is_within) {
  std::string const message = refusal("{\"a\": {\"x\": 1},\n \"b\": 1,\n \"a\": {\"x\": 2},\n \"b\": 2}");
  BOOST_TEST(has(message, "a.json:3:2: /a: given twice"));
  BOOST_TEST(has(message, "a.json:4:2: /b: given twice"));
  BOOST_TEST(!has(message, "/a/x"));
}

BOOST_AUTO_TEST_CASE(other_slips_are_explained_at_their_place) {
  BOOST_TEST(has(refusal("{\"a\": 1\n \"b\": 2}"), "a.json:2:2: a comma is missing"));
  BOOST_TEST(has(refusal("{\"a\" 1}"), "a.json:1:6: a colon is missing"));
  BOOST_TEST(has(refusal("{a: 1}"), "a.json:1:2: a name in double quotes"));
  BOOST_TEST(has(refusal("{'a': 1}"), "a.json:1:2: names and texts stand in double quotes"));
  BOOST_TEST(has(refusal("{\"a\": .5}"), "a.json:1:7: no number of JSON"));
  BOOST_TEST(has(refusal("{\"a\": 05}"), "a.json:1:7: no number of JSON"));
  BOOST_TEST(has(refusal("{\"a\": 1.}"), "a.json:1:7: no number of JSON"));
  BOOST_TEST(has(refusal("{\"a\": True}"), "a.json:1:7: a text needs double quotes"));
  BOOST_TEST(has(refusal("{\"a\": [1, 2"), "a.json:1:12: the text ends too early"));
  BOOST_TEST(has(refusal("{\"a\": \"x"), "the text ends too early"));
  BOOST_TEST(has(refusal("{\"a\": \"x\ny\"}"), "a text may not hold a line break"));
  BOOST_TEST(has(refusal("{} {}"), "a.json:1:4: there is more after the end"));
  BOOST_TEST(has(refusal(std::string_view("{}\0", 3)), "a.json:1:3: a NUL character"));
  BOOST_TEST(has(refusal("{\"a\": \"\xFF\"}"), "not UTF-8"));
}

BOOST_AUTO_TEST_CASE(a_byte_order_mark_and_any_line_ends_are_accepted) {
  std::string const text = "\xEF\xBB\xBF{\r\n  \"name\": \"Z\xC3\xBCrich\",\r\n  \"x\": 1\r\n}\r\n";
  Document const document = parse(text, "a.json");
  BOOST_TEST(document.value.at("name") == "Z\xC3\xBCrich");
  BOOST_TEST((document.places.at("/x") == Place{3, 3}));
}

BOOST_AUTO_TEST_CASE(columns_count_characters_not_bytes) {
  BOOST_TEST(has(refusal("{\"\xCE\xBC\": x}"), "a.json:1:7: "));  // {"μ": x} has x as its 7th character
}

BOOST_AUTO_TEST_CASE(deep_nesting_is_refused_without_a_crash) {
  std::string const allowed = std::string(deepest_nesting, '[') + std::string(deepest_nesting, ']');
  BOOST_TEST(refusal(allowed).empty());
  BOOST_TEST(has(refusal('[' + allowed + ']'), "a.json:1:201: nested deeper than 200 levels"));
  BOOST_TEST(has(refusal(std::string(100000, '[')), "nested deeper than 200 levels"));
  std::string objects;
  for (int level = 0; level < 100000; ++level) objects += "{\"a\":";
  BOOST_TEST(has(refusal(objects), "nested deeper than 200 levels"));
  BOOST_TEST(refusal("[\"" + std::string(1000, '[') + "\\\"[\"]").empty());  // brackets within a text do not count
}

BOOST_AUTO_TEST_CASE(a_damaged_text_is_refused_or_read_as_the_json_library_reads_it) {
  std::string const text = "{\"a\": [1, -2.5e3, true, null],\n \"b\\u00e9\": {\"c\": \"\xC3\xA9\\n\", \"d\": {}}}";
  std::string_view const alphabet = "{}[]:,\"\\/ \n0123456789.eE+-truefalsn\xC3\xA9#'";
  std::mt19937 random(20240101);
  int accepted = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string damaged = text;
    for (int hit = 0; hit <= round % 3; ++hit) {
      damaged[random() % damaged.size()] = alphabet[random() % alphabet.size()];
      if (random() % 4 == 0) damaged.erase(random() % damaged.size(), 1);
    }
    std::string const message = refusal(damaged);
    bool const is_allowed = nlohmann::json::accept(damaged) && !has(message, "given twice");
    BOOST_TEST(message.empty() == is_allowed, damaged << "\n" << message);
    accepted += message.empty() ? 1 : 0;
  }
  BOOST_TEST((accepted > 1000 && accepted < 19000));  // both outcomes are met often
}

BOOST_AUTO_TEST_CASE(every_part_of_a_document_has_its_place) {
  Document const document = parse("{\"a\": [1,\n {\"b\": \"}\\\"\"}, []],\n\n \"c/d\": {}}", "a.json");
  BOOST_TEST((document.places.at("") == Place{1, 1}));
  BOOST_TEST((document.places.at("/a") == Place{1, 2}));
  BOOST_TEST((document.places.at("/a/0") == Place{1, 8}));
  BOOST_TEST((document.places.at("/a/1/b") == Place{2, 3}));
  BOOST_TEST((document.places.at("/a/2") == Place{2, 16}));
  BOOST_TEST((document.places.at("/c~1d") == Place{4, 2}));
  BOOST_TEST(!document.places.at("/a/3").is_known());
  BOOST_TEST((document.places.near("/a/1/missing/deep") == Place{2, 2}));
}

BOOST_AUTO_TEST_SUITE_END()
