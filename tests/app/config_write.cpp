#include "core/config/write.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "core/config/json.hpp"
#include "core/config/manual.hpp"
#include "core/config/read.hpp"
#include "tests/app/config_sample.hpp"

BOOST_AUTO_TEST_SUITE(config_write)

using namespace talus;
using nlohmann::json;
using sample::Scene;

namespace {

template <class P>
json echo(P const& values) {
  json document;
  write(values, document);
  return document;
}

template <class P>
P read_back(P const& values, int dimension = 2) {
  return read_or_throw<P>(parse(echo(values).dump(), "echo"), dimension);
}

bool has(std::string const& text, std::string_view part) {
  return text.find(part) != text.npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_echo_has_every_default_and_no_empty_option) {
  Scene const scene = read_or_throw<Scene>(parse(sample::shortest, "a.json"), 2);
  json const expected = json_of(R"({
    "title": "untitled", "steps": 10, "seed": 1, "slope_deg": 0.0, "times": [0.5, 1.0], "probes": [], "notes": [],
    "space": {"dimension": 2, "periodic": [false, false], "kernel": {"type": "spline", "degree": 2}},
    "law": {"type": "elastic", "young_modulus": 2e5},
    "bodies": [{"material": "sand", "low": [0.0, 0.0], "high": [1.0, 1.0], "density": 1000.0}]})");
  BOOST_TEST(echo(scene) == expected);
}

BOOST_AUTO_TEST_CASE(the_echo_of_an_echo_is_the_same) {
  Scene scene = read_or_throw<Scene>(parse(sample::shortest, "a.json"), 3);
  scene.stop = sample::Stop{.speed = 0.1};
  scene.law = Choice<sample::Laws>::of<sample::Friction>({.E = 1.0 / 3, .grain = {.diameter = 1e-9}});
  scene.seed = 9007199254740993U;  // 2^53 + 1, which no double holds
  scene.probes = {{0.1, 0.2, 0.3}};
  scene.notes = {{.text = "0.1"}, {.text = "\"a\""}, {.text = "true"}};
  json const once = echo(scene);
  BOOST_TEST(echo(read_back(scene, 3)).dump() == once.dump());
  BOOST_TEST(read_back(scene, 3).seed == 9007199254740993U);
}

BOOST_AUTO_TEST_CASE(doubles_come_back_bit_by_bit) {
  using Limits = std::numeric_limits<double>;
  for (double const value : {0.1, 1.0 / 3, -0.0, 5e-324, Limits::min(), 1e100, 1e22, 123456789012345678.0}) {
    Scene scene = read_or_throw<Scene>(parse(sample::shortest, "a.json"), 2);
    scene.probes = {{value, -value}};
    double const back = read_back(scene).probes.at(0)[0];
    BOOST_TEST(std::memcmp(&back, &value, sizeof value) == 0, value << " came back as " << back);
  }
}

BOOST_AUTO_TEST_CASE(a_number_that_is_not_finite_is_not_written) {
  BOOST_CHECK_THROW(echo(sample::Grain{.diameter = std::nan("")}), InputError);
  BOOST_CHECK_THROW(echo(sample::Grain{.diameter = HUGE_VAL}), InputError);
}

BOOST_AUTO_TEST_CASE(the_manual_has_a_row_for_every_parameter_and_those_within_it) {
  std::string const page = policy_page<sample::Friction>();
  BOOST_TEST(has(page, "### Friction of a granular flow\n\n`{\"type\": \"friction\"}`\n"));
  BOOST_TEST(has(page,
                 "| `young_modulus` | $E$ | Pa | required | x > 0 | Young's modulus "
                 "(validated for 10000 <= x <= 1e+09: a made-up source) |\n"));
  BOOST_TEST(has(page, "| `poisson_ratio` | $\\nu$ | 1 | `0.3` | -1 < x < 0.5 | Poisson's ratio |\n"));
  BOOST_TEST(has(page, "friction at speed, \\| at infinity |\n"));
  BOOST_TEST(has(page, "| `grain/diameter` | $d$ | m | `0.0007` | 0 < x <= 0.1 | grain diameter |\n"));
  BOOST_TEST(has(policy_page<sample::Spline>(), "\n\nSource: Schoenberg (1946)\n\n"));
  BOOST_TEST(has(policy_page<sample::Linear>(), "No parameters.\n"));
}

BOOST_AUTO_TEST_CASE(the_manual_names_the_policies_of_a_choice) {
  std::string const table = parameter_table(outline<Scene>().parts);
  BOOST_TEST(has(table, "| `law` |  |  | required | `elastic`, `friction` | the material |\n"));
  BOOST_TEST(has(table, "| `space/kernel` |  |  | `{\"degree\":2,\"type\":\"spline\"}` | `linear`, `spline` |"));
  BOOST_TEST(has(table, "| `bodies/0/density` | $\\rho$ | kg/m^3 | `1000.0` | x > 0 | density |\n"));
  BOOST_TEST(has(table, "| `stop` |  |  | left out |  | when to stop |\n"));
}

BOOST_AUTO_TEST_SUITE_END()
