/// A standing wave of small amplitude on a row that repeats: u = A sin kx sin ckt, c^2 = M/rho.
///
/// What the scheme makes of it has a closed form, errors in space and time included: the eigenvalue of a 3 x 3 matrix
/// (verification/reference/lattice_modes.hpp). To leading order in kh and without the errors in time,
///
///   1 - omega_h/omega = a (kh)^2,  a = (p + 1)/12 of FLIP,  (p + 1)/24 of APIC and AFLIP                          (1)
///
/// The amplitude s_n of cos kX in the strain oscillates with that eigenvalue z = r exp(i phi) alone, so over a lag m
///
///   s_n+m + r^2m s_n-m = 2 r^m cos(m phi) s_n                                                                     (2)
///
/// for all n: two unknowns, by least squares. omega = phi/dt; the leapfrog's error is taken out of (1) by
/// sin(phi/2) = omega_h dt/2.

#include <cmath>
#include <numbers>

#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/laws/hencky.hpp"
#include "verification/reference/lattice_modes.hpp"
#include "verification/reference/linear_algebra.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification::elastic_standing_wave {

namespace {

constexpr double length = 1, density = 1000, modulus = 1e5, courant = 0.2;
constexpr int per_cell = 4;
double const c = std::sqrt(modulus / density), k = 2 * std::numbers::pi / length;

struct Wave {
  double turn, shrink;  ///< phi and r of a step
};

/// (2).
Wave fitted(std::vector<double> const& s, int lag) {
  auto const rows = static_cast<Eigen::Index>(s.size()) - 2 * lag;
  Eigen::MatrixXd A(rows, 2);
  Eigen::VectorXd right(rows);
  for (Eigen::Index n = 0; n < rows; ++n) {
    auto const at = static_cast<std::size_t>(n);
    A(n, 0) = s[at + static_cast<std::size_t>(lag)];
    A(n, 1) = -s[at];
    right[n] = s[at + 2 * static_cast<std::size_t>(lag)];
  }
  Eigen::Vector2d const x = reference::least_squares(A, right);
  double const r = std::sqrt(x[1]);
  return {std::acos(x[0] / (2 * r)) / lag, std::pow(r, 1.0 / lag)};
}

/// Runs three periods on N cells.
Wave measured(Scheme const& scheme, int N, Cost& cost) {
  double const h = length / N, dt = courant * h / c;
  Scene<2> scene = scene_of<kinematics::PlaneStrainReduced, law::Hencky>(scheme, h, density, {modulus, 0});
  scene.periods = {N / block_edge, 1};
  set_step(scene, dt);
  std::vector<Seed<2>> seeds;
  for (auto const& x : lattice<2>({0, 0}, {N, block_edge}, {per_cell, 1}, h)) {
    Seed<2> seed;
    seed.x = x;
    seed.v[0] = 1e-7 * c * std::sin(k * x[0]);
    seed.C(0, 0) = 1e-7 * c * k * std::cos(k * x[0]);
    seed.mass = density * h * h / per_cell;
    seeds.push_back(seed);
  }
  auto const simulation = begin(std::move(scene), seeds);
  std::vector<double> amplitude;
  take_steps(*simulation, 10, cost);  // after which what the first C_p had of its own has died
  take_steps(*simulation, std::lround(3 * N / courant), cost, [&] {
    auto const strain = column(*simulation, "elastic_strain");
    double sum = 0;
    for (std::size_t p = 0; p < seeds.size(); ++p) sum += strain[p] * std::cos(k * seeds[p].x[0]);
    amplitude.push_back(sum);
  });
  return fitted(amplitude, static_cast<int>(std::lround(N / courant / 4)));
}

/// (1 - omega_h/omega)/(kh)^2.
double coefficient(Wave const& wave, int N) {
  double const kh = 2 * std::numbers::pi / N;
  return (1 - 2 * std::sin(wave.turn / 2) / (courant * kh)) / (kh * kh);
}

double loss_per_period(Wave const& wave) {
  return 1 - std::pow(wave.shrink, 2 * std::numbers::pi / wave.turn);
}

Wave predicted(Scheme const& scheme, int N) {
  auto const z = reference::wave_factor(
      {scheme.degree(), scheme.affine(), scheme.transfer == "flip" || scheme.transfer == "aflip" ? scheme.alpha : 0,
       scheme.integrator == "musl"},
      per_cell, 2 * std::numbers::pi / N, courant);
  return {std::arg(z), std::abs(z)};
}

/// On one resolution, against the closed form.
Wave against_closed_form(Findings& findings, Scheme const& scheme, int N) {
  Cost cost;
  Wave const found = measured(scheme, N, cost), exact = predicted(scheme, N);
  std::string const subject = scheme.name() + ", N = " + std::to_string(N);
  findings.check(subject, "frequency over the scheme's own - 1", std::abs(found.turn / exact.turn - 1), at_most(1e-10),
                 "closed form of the linear scheme; amplitude 1e-7", cost);
  double const loss = loss_per_period(exact);
  findings.check(subject, "loss per period", loss_per_period(found),
                 {loss - 1e-6 * std::abs(loss) - 1e-10, loss + 1e-6 * std::abs(loss) + 1e-10},
                 "closed form of the linear scheme -+ 1e-6 of it");
  return found;
}

void study(Findings& findings, Plot& plot, Scheme const& scheme) {
  Curve curve{scheme.name(), {}, {}, false};
  for (int const N : {16, 32, 64}) {
    Wave const found = against_closed_form(findings, scheme, N);
    double const kh = 2 * std::numbers::pi / N, a = coefficient(found, N);
    curve.x.push_back(kh);
    curve.y.push_back(a * kh * kh);
    if (N < 64 || scheme.degree() < 2 || scheme.transfer == "pic" || scheme.integrator != "usl") continue;
    findings.check(scheme.name(), "frequency error over (kh)^2 at N = 64", a,
                   about((scheme.degree() + 1) / (scheme.affine() ? 24.0 : 12.0), 0.05), "(1), leading term");
  }
  if (scheme.integrator == "usl" && scheme.transfer != "pic") plot.curves.push_back(curve);
}

void run(Findings& findings) {
  Plot plot{"Frequency error of a standing wave", "kh", "1 - omega_h/omega", true, true, {}};
  for (std::string const integrator : {"usl", "musl"})
    for (Scheme const& scheme : all_schemes(integrator)) study(findings, plot, scheme);
  for (double const degree : {2.0, 3.0})
    for (double const per : {12.0, 24.0}) {
      Curve guide{
          "degree " + std::to_string(int(degree)) + ", (kh)^2 (p + 1)/" + std::to_string(int(per)), {}, {}, true};
      for (int const N : {16, 64}) {
        double const kh = 2 * std::numbers::pi / N;
        guide.x.push_back(kh);
        guide.y.push_back((degree + 1) / per * kh * kh);
      }
      plot.curves.push_back(guide);
    }
  findings.plots.push_back(plot);
}

}  // namespace

Case const the_case{"elastic/standing_wave",
                    "Frequency and damping of a standing elastic wave",
                    "the wave factor of the linear scheme, in closed form",
                    "derived in verification/reference/lattice_modes.hpp",
                    1,
                    30,
                    run};

}  // namespace talus::verification::elastic_standing_wave
