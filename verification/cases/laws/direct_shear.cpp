/// Direct shear at constant normal stress, figure 25 of the source with both signs of the change of volume: the driver of
/// `talus point` against IDA, which knows neither the driver nor the law's map.
///
/// The rate equations with mu(I) have no rate on the cap, where an isotropic load beyond p_c0 ends: with it there are
/// strengths above the load alone.

#include <fmt/format.h>

#include <cmath>

#include "core/material_point.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/cam_clay_mu_i_consistent.hpp"
#include "models/laws/modified_cam_clay.hpp"
#include "models/make.hpp"
#include "verification/reference/closed_forms.hpp"
#include "verification/reference/ida_path.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/strain_paths.hpp"

namespace talus::verification::laws_direct_shear {

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
  auto state = under_pressure(rates.elastic, normal_stress);
  state.eps_V = std::min(0.0, std::log(p_c0 / normal_stress) / xi);
  return state;
}

template <class L, class Rates>
void compare(Findings& findings, double p_c0, Rates const& rates_of) {
  typename L::Parameters parameters;
  parameters.p_c0 = p_c0, parameters.xi = 100;
  auto const rates = rates_of(parameters);
  std::vector<double> times;
  for (int k = 1; k <= tenths; ++k) times.push_back(duration * k / tenths);
  auto const rows =
      reference::ida_path(rates, loaded(rates, p_c0, parameters.xi), reference::direct_shear(1, duration), times);
  auto const samples = driven<L>(parameters, 6000);
  double const coarse = distance(driven<L>(parameters, 3000), rows), fine = distance(samples, rows);
  std::string const subject = fmt::format("{}, p_c0/sigma_n = {}", L::name, p_c0 / normal_stress);
  findings.check(subject, "distance from IDA's path, 6000 steps", fine, at_most(1e-3),
                 "of the normal stress; first order");
  findings.check(subject, "that over the one with 3000 steps", fine / coarse, at_most(0.6), "first order: 0.5");
  double const plateau = std::log(p_c0 / (2 * normal_stress)) / parameters.xi;
  findings.check(subject, "plateau of the plastic volumetric strain, less the exact one",
                 std::abs(samples.back().eps_V - plateau), at_most(0.01 * 0.0139), "1 % of the largest plateau");
}

void run(Findings& findings) {
  for (double const p_c0 : {50.0, 100.0, 200.0, 400.0, 800.0})
    compare<law::CamClay>(findings, p_c0, [](law::CamClay::Parameters const& p) {
      return reference::cam_clay({p.E, p.nu, 3}, {p.M, p.beta}, reference::ExponentialStrength{p.p_c0, p.xi});
    });
  for (double const p_c0 : {120.0, 150.0, 200.0, 400.0, 800.0})
    compare<law::CamClayMuIConsistent>(findings, p_c0, [](law::CamClayMuIConsistent::Parameters const& p) {
      return reference::cam_clay_mu_i({p.E, p.nu, 3}, p.beta, reference::ExponentialStrength{p.p_c0, p.xi},
                                      {p.mu_1, p.mu_2, p.I_0, p.d, p.rho_s});
    });
}

}  // namespace

Case const the_case{"laws/direct_shear",
                    "Direct shear of a material point",
                    "IDA, relative tolerance 1e-13, and the plateau in closed form",
                    "figure 25 of Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643",
                    1,
                    30,
                    run};

}  // namespace talus::verification::laws_direct_shear
