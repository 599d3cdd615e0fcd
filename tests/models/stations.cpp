/// Stations of documents: which particles they see, and that they measure what the frames show of these.

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/cli/program.hpp"

// What sums of a hundred numbers are rounded by.
BOOST_AUTO_TEST_SUITE(stations, *boost::unit_test::tolerance(1e-12))

using namespace talus;

namespace {

constexpr double young = 1e5, nu = 0.25, G = young / (2 * (1 + nu)), rate = 3;

/// A layer that repeats after 0.08 m, in simple shear above a base; its station sees 0.06 m of it, across the seam.
nlohmann::json sheared_layer(nlohmann::json station) {
  return {{"schema", "talus/case/1"},
          {"title", "a layer in simple shear"},
          {"kinematics", {{"type", "plane_strain_reduced"}}},
          {"grid", {{"spacing", 0.01}, {"periods", {0.08, 0.0}}}},
          {"transfer", {{"type", "apic"}}},
          {"materials",
           {{{"name", "clay"},
             {"density", 1000},
             {"law", {{"type", "hencky"}, {"young_modulus", young}, {"poisson_ratio", nu}}}}}},
          {"bodies",
           {{{"name", "layer"},
             {"material", "clay"},
             {"shape", {{"type", "box"}, {"min", {0.0, 0.0}}, {"max", {0.08, 0.04}}}},
             {"seeding", {{"type", "lattice"}, {"per_axis", 2}}},
             {"velocity",
              {{"type", "linear"},
               {"velocity", {0.0, 0.0}},
               {"origin", {0.0, 0.0}},
               {"gradient", {{0.0, rate}, {0.0, 0.0}}}}}}}},
          {"walls",
           {{{"name", "base"},
             {"shape", {{"type", "half_space"}, {"point", {0.0, 0.0}}, {"normal", {0.0, 1.0}}}},
             {"contact", {{"type", "stick"}}}}}},
          {"time", {{"end", 1.0}}},
          {"output", {{"stations", {std::move(station)}}}}};
}

nlohmann::json const across_the_seam{{"name", "seam"}, {"min", {-0.02, 0.0}}, {"max", {0.04, 0.05}}, {"bins", 5}};

std::unique_ptr<Experiment> composed(nlohmann::json const& document) {
  return program().compose(parse(document.dump(), "case.json")).experiment;
}

double value_of(Experiment const& experiment, std::string const& name) {
  auto const quantities = experiment.quantities();
  for (std::size_t k = 0; k < quantities.size(); ++k)
    if (quantities[k].name == name) return experiment.measure()[k];
  BOOST_FAIL("no column " + name);
  return 0;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_station_sees_its_part_of_the_period) {
  auto const experiment = composed(sheared_layer(across_the_seam));
  BOOST_TEST(value_of(*experiment, "seam_mass") == 1000 * 0.06 * 0.04);
  BOOST_TEST(value_of(*experiment, "seam_depth") == 0.04);
  BOOST_TEST(value_of(*experiment, "seam_mean_speed") == rate * 0.02);
  BOOST_TEST(value_of(*experiment, "seam_flux") == 1000 * 0.04 * rate * 0.02);
  auto const profiles = experiment->profiles();
  BOOST_TEST_REQUIRE(profiles.size() == 1U);
  BOOST_TEST_REQUIRE(profiles[0].rows.size() == 5U);
}

BOOST_AUTO_TEST_CASE(the_whole_period_is_seen_wherever_the_box_begins) {
  for (double const low : {0.0, 0.013, -5.0}) {
    auto station = across_the_seam;
    station["min"][0] = low;
    station["max"][0] = low + 0.08;
    auto const experiment = composed(sheared_layer(station));
    for (int k = 0; k < 40; ++k) experiment->advance(1.0);
    BOOST_TEST(value_of(*experiment, "seam_mass") == 1000 * 0.08 * 0.04);
  }
}

BOOST_AUTO_TEST_CASE(it_measures_what_the_frames_show) {
  auto const experiment = composed(sheared_layer(across_the_seam));
  for (int k = 0; k < 40; ++k) experiment->advance(1.0);
  Snapshot const frame = experiment->frame();
  auto const& x = frame.find("position")->values;
  auto const& eps = frame.find("elastic_strain")->values;  // xx, yy, xy
  auto const& p = frame.find("pressure")->values;
  double count = 0, pressure = 0, tangential = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    double const along = x[2 * k] - std::floor((x[2 * k] + 0.02) / 0.08) * 0.08;
    if (along >= 0.04 || x[2 * k + 1] >= 0.02 || x[2 * k + 1] < 0.01) continue;
    ++count;
    pressure += p[k];
    tangential += 2 * G * eps[3 * k + 2];
  }
  Profile const made = experiment->profiles().front();
  auto const in_second_bin = [&](std::string const& name) {
    for (std::size_t k = 0; k < made.quantities.size(); ++k)
      if (made.quantities[k].name == name) return made.rows[1][k];
    BOOST_FAIL("no column " + name);
    return 0.0;
  };
  BOOST_TEST(tangential != 0);
  BOOST_TEST(in_second_bin("mass") == count * 1000 * 0.08 * 0.04 / static_cast<double>(p.size()));
  BOOST_TEST(in_second_bin("pressure") == pressure / count);
  BOOST_TEST(in_second_bin("tangential_stress") == tangential / count);
}

BOOST_AUTO_TEST_SUITE_END()
