/// What a station makes of the particles that it sees, on layers whose measures are known in closed form.

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <map>

#include "core/station.hpp"

// Sums of 1140 numbers are known to 1140 eps = 3e-13.
BOOST_AUTO_TEST_SUITE(station, *boost::unit_test::tolerance(1e-12))

using namespace talus;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double depth = 0.05, rate = 8, load = 2000, slope = 0.4, J = 1.25, phi_0 = 0.6, density = 1500;
constexpr int rows = 380, columns = 3;

Station const bed{"bed", {0, 0.1}, {0.2, 0.18}, 0, 1, 4, {phi_0}};

/// `rows` rows of particles in simple shear, u = rate y, with p = load (1 - y/depth), q = slope p.
Snapshot sheared_layer() {
  Snapshot s{0.5, 7, 2, {}};
  for (std::string_view const name :
       {sample::mass, sample::initial_volume, sample::height, sample::flow_velocity, sample::solid_volume,
        sample::pressure, sample::shear_stress, sample::volume_ratio, std::string_view("strength")})
    s.columns.push_back({std::string(name), "", "1", "", 1, {}});
  for (int k = 0; k < rows * columns; ++k) {
    double const y = (k % rows + 0.5) / rows * depth, volume = 0.2 * depth / (rows * columns),
                 p = load * (1 - y / depth);
    std::vector<double> const values{density * volume,    volume, y, rate * y, phi_0 * volume, p, slope * p, J,
                                     k < rows ? 3.0 : nan};
    for (std::size_t c = 0; c < values.size(); ++c) s.columns[c].values.push_back(values[c]);
  }
  return s;
}

Snapshot without_particles(Snapshot s) {
  for (NamedColumn& column : s.columns) column.values.clear();
  return s;
}

std::map<std::string, double> measured(Snapshot const& samples) {
  auto const quantities = station_quantities(bed);
  auto const values = measure(bed, samples);
  BOOST_TEST_REQUIRE(quantities.size() == values.size());
  std::map<std::string, double> found;
  for (std::size_t k = 0; k < values.size(); ++k) found[quantities[k].name] = values[k];
  return found;
}

std::size_t at(Profile const& made, std::string const& name) {
  for (std::size_t k = 0; k < made.quantities.size(); ++k)
    if (made.quantities[k].name == name) return k;
  BOOST_FAIL("no column " + name);
  return 0;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_layer_in_simple_shear_is_measured_exactly) {
  auto const found = measured(sheared_layer());
  double const mass = density * 0.2 * depth;
  BOOST_TEST(found.at("bed_mass") == mass);
  BOOST_TEST(found.at("bed_depth") == depth);
  BOOST_TEST(found.at("bed_thickness") == depth * std::sqrt(1 - 1.0 / (rows * rows)));  // n equal rows
  BOOST_TEST(found.at("bed_mean_speed") == rate * depth / 2);
  BOOST_TEST(found.at("bed_flux") == mass * rate * depth / 2 / 0.2);
  BOOST_TEST(found.at("bed_pressure") == load / 2);
  BOOST_TEST(found.at("bed_mobilised_friction") == slope);
  BOOST_TEST(found.at("bed_volume_ratio") == J);
  BOOST_TEST(found.at("bed_solid_fraction") == phi_0 / J);
  // the uppermost 5 %: 19 of 380 rows, whose mean height is that of their middle
  BOOST_TEST(found.at("bed_surface_speed") == rate * depth * (1 - 0.025));
  // 11.4 particles are above it: it is the row of the twelfth, the fourth from above
  BOOST_TEST(found.at("bed_top") == (rows - 3.5) / rows * depth);
}

BOOST_AUTO_TEST_CASE(of_the_particle_at_the_edge_of_the_surface_a_share_is_taken) {
  Snapshot s = without_particles(sheared_layer());
  for (auto const& [m, y] : {std::pair{1.0, 0.01}, std::pair{39.0, 0.02}, std::pair{1.0, 0.03}})
    for (std::size_t c = 0; double const value : {m, m, y, 100 * y, m, 1.0, 1.0, 1.0, 1.0})
      s.columns[c++].values.push_back(value);
  // 2.05 of 41: all of the uppermost, and 1.05 of the 39 below it
  BOOST_TEST(measured(s).at("bed_surface_speed") == (1 * 3.0 + 1.05 * 2.0) / 2.05);
}

BOOST_AUTO_TEST_CASE(bins_hold_the_means_of_their_particles) {
  Profile const made = profile(bed, sheared_layer());
  BOOST_TEST(made.station == "bed");
  BOOST_TEST_REQUIRE(made.rows.size() == 4U);  // 0.02 m each: the layer fills two and a half
  for (std::size_t b = 0; b < 3; ++b) {
    double const low = 0.02 * static_cast<double>(b), high = std::min(low + 0.02, depth), middle = (low + high) / 2;
    auto const& row = made.rows[b];
    BOOST_TEST(row[at(made, "time")] == 0.5);
    BOOST_TEST(row[at(made, "middle")] == low + 0.01);
    BOOST_TEST(row[at(made, "height")] == middle);
    BOOST_TEST(row[at(made, "mass")] == density * 0.2 * (high - low));
    BOOST_TEST(row[at(made, "pressure")] == load * (1 - middle / depth));
    BOOST_TEST(row[at(made, "mobilised_friction")] == slope);
    BOOST_TEST(row[at(made, "solid_fraction")] == phi_0 / J);
    BOOST_TEST(row[at(made, "strength")] == 3.0);  // of the particles that have one
  }
  BOOST_TEST(made.rows[3][at(made, "mass")] == 0);
  BOOST_TEST(made.rows[3][at(made, "middle")] == 0.07);
  BOOST_TEST(std::isnan(made.rows[3][at(made, "pressure")]));
}

BOOST_AUTO_TEST_CASE(nothing_has_mass_and_flux_0_and_no_means) {
  for (auto const& [name, value] : measured(without_particles(sheared_layer())))
    BOOST_TEST((name == "bed_mass" || name == "bed_flux" ? value == 0 : std::isnan(value)), name);
}

BOOST_AUTO_TEST_CASE(the_solid_fraction_needs_laws_that_tell_of_grains) {
  Station silent = bed;
  silent.initial_fraction.clear();
  Snapshot s = sheared_layer();
  std::erase_if(s.columns, [](NamedColumn const& c) { return c.name == sample::solid_volume; });
  BOOST_TEST(station_quantities(silent).size() + 1 == station_quantities(bed).size());
  BOOST_TEST(measure(silent, s).size() + 1 == measure(bed, sheared_layer()).size());
  Profile const made = profile(silent, s);
  for (Quantity const& q : made.quantities) BOOST_TEST(q.name != "solid_fraction");
}

BOOST_AUTO_TEST_SUITE_END()
