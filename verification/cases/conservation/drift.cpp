/// A standing wave over a hundred periods: the energy of symplectic Euler wavers within a period and does not drift.
///
/// Kinetic and elastic energy at the ends of steps belong to times half a step apart; their sum wavers by a share of
/// order omega dt. What is measured is the slope of its logarithm over all steps, per period. The
/// transfer takes what it takes of a wave, in closed form in verification/reference/lattice_modes.hpp.

#include <cmath>
#include <numbers>

#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/laws/hencky.hpp"
#include "verification/reference/lattice_modes.hpp"
#include "verification/reference/linear_algebra.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification::conservation_drift {

namespace {

constexpr double length = 1, density = 1000, modulus = 1e5, courant = 0.2;
constexpr double amplitude = 1e-6;  // with more the wave steepens in a hundred periods
constexpr int N = 32, periods = 100;
double const c = std::sqrt(modulus / density), k = 2 * std::numbers::pi / length;

/// Energy after each step [J].
std::vector<double> energies(Scheme const& scheme, Cost& cost) {
  double const h = length / N;
  Scene<2> scene = scene_of<kinematics::PlaneStrainReduced, law::Hencky>(scheme, h, density, {modulus, 0});
  scene.periods = {N / block_edge, 1};
  scene.keeps_ledger = true;
  set_step(scene, courant * h / c);
  std::vector<Seed<2>> seeds;
  for (auto const& x : lattice<2>({0, 0}, {N, block_edge}, {2, 1}, h)) {
    Seed<2> seed;
    seed.x = x;
    seed.v[0] = amplitude * c * std::sin(k * x[0]);
    seed.C(0, 0) = amplitude * c * k * std::cos(k * x[0]);
    seed.mass = density * h * h / 2;
    seeds.push_back(seed);
  }
  auto const simulation = begin(std::move(scene), seeds);
  std::vector<double> energy;
  take_steps(*simulation, std::lround(periods * N / courant), cost, [&] {
    auto const& now = simulation->ledger().now;
    energy.push_back(now.kinetic + now.elastic);
  });
  return energy;
}

/// Slope, per step, of what the logarithms of the values follow besides waves of `turn` and twice that a step: the fit
/// has them as well, for a line alone would take a piece of a wave at the ends for a slope.
double slope(std::vector<double> const& values, double turn) {
  auto const n = static_cast<Eigen::Index>(values.size());
  Eigen::MatrixXd A(n, 6);
  Eigen::VectorXd right(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    double const phase = turn * double(j);
    A.row(j) << 1, double(j) / double(n), std::cos(phase), std::sin(phase), std::cos(2 * phase), std::sin(2 * phase);
    right[j] = std::log(values[static_cast<std::size_t>(j)]);
  }
  return reference::least_squares(A, right)[1] / double(n);
}

void run(Findings& findings) {
  Plot plot{"Energy of a standing wave", "period", "energy over that at the start", false, false, {}};
  double const steps_a_period = N / courant;
  for (Scheme const& scheme : all_schemes()) {
    if (scheme.transfer == "pic") continue;
    Cost cost;
    auto const energy = energies(scheme, cost);
    auto const factor =
        reference::wave_factor({scheme.degree(), scheme.affine(), scheme.transfer == "apic" ? 0.0 : 1.0}, 2,
                               2 * std::numbers::pi / N, courant);
    double const drift = slope(energy, std::arg(factor)) * steps_a_period;
    double const exact = 2 * std::log(std::abs(factor)) * steps_a_period;
    if (scheme.transfer == "aflip")
      findings.check(scheme.name(), "drift of the energy per period", std::abs(drift), at_most(1e-4),
                     "symplectic but for what the transfer takes", cost);
    findings.check(scheme.name(), "drift over what the transfer takes", drift / exact, {0.95, 1.05},
                   "closed form of the linear scheme; 5 %: the fit");
    Curve curve{scheme.name(), {}, {}, false};
    for (std::size_t j = 0; j < energy.size(); j += 80) {
      curve.x.push_back(double(j) / steps_a_period);
      curve.y.push_back(energy[j] / energy.front());
    }
    plot.curves.push_back(curve);
  }
  findings.omit("pic", "drift of the energy", "it loses half of the amplitude in a period");
  findings.plots.push_back(plot);
}

}  // namespace

Case const the_case{"conservation/drift",
                    "The energy of a standing wave over a hundred periods",
                    "no drift",
                    "property of symplectic integration",
                    1,
                    30,
                    run};

}  // namespace talus::verification::conservation_drift
