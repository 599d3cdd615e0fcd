/// What a transfer takes of a wave of velocity in a step without force: particles to nodes and back is, for a wave on a
/// commensurate lattice, a factor that has a closed form (verification/reference/lattice_modes.hpp). With S, s from
/// there, a step leaves
///
///   S            of PIC,   1 - S = (p + 1)/12 (kh)^2 + ...                                                       (1)
///   S + s        of APIC,  1 - S - s = b (kh)^4 + ..., b = 1/42, 17/360                                        (2)
///   and FLIP and AFLIP lose 1 - alpha of that in their first steps, nothing where alpha = 1.                      (3)

#include <cmath>
#include <numbers>

#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/laws/hencky.hpp"
#include "verification/reference/lattice_modes.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification::transfer_spectrum {

namespace {

constexpr double h = 0.125, density = 1000;
constexpr int per_cell = 4;

/// 1 - the share that the second step leaves of sin kx, on N cells that repeat. In the first one C_p is the wave's own
/// gradient, from then on what the transfer made of it.
double loss(Scheme const& scheme, int N) {
  Scene<2> scene = scene_of<kinematics::PlaneStrainReduced, law::Hencky>(scheme, h, density, {1, 0});
  scene.periods = {N / block_edge, 1};
  set_step(scene, 1e-9);  // 1 m/s moves nothing, and strains nothing that matters
  double const k = 2 * std::numbers::pi / (N * h);
  std::vector<Seed<2>> seeds;
  for (auto const& x : lattice<2>({0, 0}, {N, block_edge}, {per_cell, 1}, h)) {
    Seed<2> seed{x, {std::sin(k * x[0]), 0}, density * h * h / per_cell};
    seed.C(0, 0) = k * std::cos(k * x[0]);
    seeds.push_back(seed);
  }
  auto const simulation = begin(std::move(scene), seeds);
  auto const wave = [&] {
    double sum = 0;
    auto const v = column(*simulation, "velocity");
    for (std::size_t p = 0; p < v.size(); ++p) sum += v[p] * seeds[p].v[0];
    return sum;
  };
  Cost cost;
  take_steps(*simulation, 1, cost);
  double const before = wave();
  take_steps(*simulation, 1, cost);
  return 1 - wave() / before;
}

double predicted(Scheme const& scheme, double kh) {
  auto const mode = reference::lattice_mode({scheme.degree(), scheme.affine(), 0}, per_cell, kh);
  return 1 - mode.S - mode.s;
}

double angle(int N) {
  return 2 * std::numbers::pi / N;
}

/// Losses against the closed form on three wavelengths, and the leading coefficient.
void replacing(Findings& findings, Plot& plot, Scheme const& scheme, double coefficient) {
  int const power = scheme.affine() ? 4 : 2;
  Curve found{scheme.name(), {}, {}, false}, guide{scheme.name() + ", closed form", {}, {}, true};
  double worst = 0;
  for (int const N : {16, 32, 64}) {
    double const share = loss(scheme, N), exact = predicted(scheme, angle(N));
    worst = std::max(worst, std::abs(share / exact - 1));
    found.x.push_back(angle(N));
    guide.x.push_back(angle(N));
    found.y.push_back(share);
    guide.y.push_back(exact);
  }
  plot.curves.push_back(found);
  plot.curves.push_back(guide);
  findings.check(scheme.name(), "loss over the closed form - 1", worst, at_most(1e-7),
                 "rounding, 1e-14 of the wave, over the smallest loss");
  findings.check(scheme.name(), power == 2 ? "loss/(kh)^2 at N = 64" : "loss/(kh)^4 at N = 64",
                 found.y.back() / std::pow(angle(64), power), about(coefficient, 0.02),
                 "leading term of the closed form; 2 %: the next ones");
}

void run(Findings& findings) {
  Plot plot{"Loss of a wave in a step", "kh", "loss", true, true, {}};
  // PIC: (p + 1)/12, of degree 1 times 1 + 1/(2 n^2), for its second moment depends on the place
  replacing(findings, plot, {"linear", "pic"}, 2.0 / 12 * (1 + 1.0 / 32));
  replacing(findings, plot, {"quadratic", "pic"}, 3.0 / 12);
  replacing(findings, plot, {"cubic", "pic"}, 4.0 / 12);
  replacing(findings, plot, {"quadratic", "apic"}, 1.0 / 42);
  replacing(findings, plot, {"cubic", "apic"}, 17.0 / 360);
  for (Scheme const& scheme : all_schemes("usl", 0.95)) {
    if (scheme.alpha == 1) continue;
    double const share = loss(scheme, 64), exact = 0.05 * predicted(scheme, angle(64));
    findings.check(scheme.name(), "loss over 0.05 of the closed form's", share / exact, {0.98, 1.02},
                   "(3); 2 %: what is left of the step before");
  }
  for (Scheme const& scheme : all_schemes()) {
    if (scheme.transfer != "flip" && scheme.transfer != "aflip") continue;
    findings.check(scheme.name(), "loss at N = 64", std::abs(loss(scheme, 64)), at_most(1e-14),
                   "exact but for rounding");
  }
  findings.plots.push_back(plot);
}

}  // namespace

Case const the_case{"transfer/spectrum",
                    "What a transfer takes of a wave of velocity in a step",
                    "the transfer's factor on a lattice, in closed form",
                    "derived in verification/reference/lattice_modes.hpp",
                    0,
                    5,
                    run};

}  // namespace talus::verification::transfer_spectrum
