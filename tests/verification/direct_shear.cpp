/// Direct shear at constant normal stress: the driver of `talus point` against IDA, which knows neither the driver nor the
/// law's map.

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/material_point.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/cam_clay_mu_i_consistent.hpp"
#include "models/laws/modified_cam_clay.hpp"
#include "models/make.hpp"
#include "tests/support/strain_paths.hpp"
#include "verification/reference/closed_forms.hpp"
#include "verification/reference/ida_path.hpp"

using namespace talus;

namespace {

constexpr double normal_stress = 100, duration = 0.3;  // at a shear rate of 1/s
constexpr int tenths = 10;

struct Sample {
  double tau_xy, p, q, eps_V;
};

/// The driver, loaded isotropically and then sheared in n steps; the state after each tenth.
template <class L>
std::vector<Sample> driven(typename L::Parameters const& parameters, int n) {
  MaterialPoint<3> point(make_material<kinematics::Solid, L>("point", 1, parameters), 6);
  Control const load{.of_stress = true, .target = -normal_stress}, held{.of_stress = true};
  follow(point, {"load", 1, 400, {load, load, load}}, [] {});
  auto const quantities = point.quantities();
  auto const value = [&](std::string const& name) {
    for (std::size_t k = 0; k < quantities.size(); ++k)
      if (quantities[k].name == name) return point.measure()[k];
    return std::nan("");
  };
  std::vector<Sample> samples;
  for (int k = 0; k < tenths; ++k) {
    follow(point, {"shear", duration / tenths, n / tenths, {Control{}, held, Control{}, Control{.rate = 1}}}, [] {});
    samples.push_back(
        {point.stress()[3], value("pressure"), value("shear_stress"), value("plastic_volumetric_strain")});
  }
  return samples;
}

/// Largest distance of the driver's samples from IDA's, of stresses in units of the normal stress.
double distance(std::vector<Sample> const& samples, std::vector<reference::Row> const& rows) {
  double most = 0;
  for (std::size_t k = 0; k < samples.size(); ++k)
    for (double const gap :
         {(samples[k].tau_xy - rows[k].tau(0, 1)) / normal_stress, (samples[k].p - rows[k].p) / normal_stress,
          (samples[k].q - rows[k].q) / normal_stress, samples[k].eps_V - rows[k].state.eps_V})
      most = std::max(most, std::abs(gap));
  return most;
}

/// After isotropic loading by the normal stress: on the cap where that is above p_c0.
reference::State loaded(reference::RateLaw const& rates, double p_c0, double xi) {
  auto state = support::under_pressure(rates.elastic, normal_stress);
  state.eps_V = std::min(0.0, std::log(p_c0 / normal_stress) / xi);
  return state;
}

template <class L, class Rates>
void compare(double p_c0, Rates const& rates_of) {
  typename L::Parameters parameters;
  parameters.p_c0 = p_c0, parameters.xi = 100;
  auto const rates = rates_of(parameters);
  std::vector<double> times;
  for (int k = 1; k <= tenths; ++k) times.push_back(duration * k / tenths);
  auto const rows =
      reference::ida_path(rates, loaded(rates, p_c0, parameters.xi), reference::direct_shear(1, duration), times);
  double const coarse = distance(driven<L>(parameters, 3000), rows), fine = distance(driven<L>(parameters, 6000), rows);
  BOOST_TEST_MESSAGE(L::name << ", p_c0/sigma_n " << p_c0 / normal_stress << ": from IDA by " << coarse
                             << ", with half "
                             << "the step " << fine);
  BOOST_TEST(fine < 1e-3);
  BOOST_TEST(fine < 0.6 * coarse);
  double const plateau = std::log(p_c0 / (2 * normal_stress)) / parameters.xi;
  BOOST_TEST(std::abs(rows.back().state.eps_V - plateau) < 0.01 * 0.0139);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(direct_shear)

// Figure 25 of the source: both signs of the change of volume.
BOOST_AUTO_TEST_CASE(without_viscosity_the_driver_follows_ida_along_the_path) {
  for (double const p_c0 : {50.0, 100.0, 200.0, 400.0, 800.0})
    compare<law::CamClay>(p_c0, [](law::CamClay::Parameters const& p) {
      return reference::cam_clay({p.E, p.nu, 3}, {p.M, p.beta}, reference::ExponentialStrength{p.p_c0, p.xi});
    });
}

// The rate equations have no rate on the cap, where an isotropic load beyond p_c0 ends: strengths above the load alone.
BOOST_AUTO_TEST_CASE(with_mu_of_I_the_driver_follows_ida_along_the_path) {
  for (double const p_c0 : {120.0, 150.0, 200.0, 400.0, 800.0})
    compare<law::CamClayMuIConsistent>(p_c0, [](law::CamClayMuIConsistent::Parameters const& p) {
      return reference::cam_clay_mu_i({p.E, p.nu, 3}, p.beta, reference::ExponentialStrength{p.p_c0, p.xi},
                                      {p.mu_1, p.mu_2, p.I_0, p.d, p.rho_s});
    });
}

BOOST_AUTO_TEST_SUITE_END()
