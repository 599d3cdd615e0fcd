/// Elastic blocks that are nearly incompressible or nearly rigid, with the default step.
///
/// Nearly incompressible: a free block in plane strain is stretched along one axis and shortened along the other, at a
/// rate at which its volume stays. Whatever nu, no energy may appear, the ledger closes, and the steps follow
///
///   steps ~ sqrt(2 lambda + 2 G)                                                                                   (1)
///
/// Nearly rigid: the box of friction/sliding_box, up to E = 1e12 Pa, slides down its plane as Coulomb's law says,
/// x_n = a t_n (t_n + dt)/2, a = g (sin theta - mu cos theta).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/laws/hencky.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/sliding_box.hpp"

namespace talus::verification::stability_stiff_blocks {

namespace {

constexpr double density = 1000, shear_modulus = 1e6, h = 0.1, length = 0.8;  // of the block

struct Stretched {
  double energy = 0;    ///< largest over that of the start; the kinetic one as the mean of half a step before and after
  double residual = 0;  ///< largest of the ledger
  double volume = 0;    ///< largest |tr eps|
  double foretold = 0;  ///< steps by the bound
  Cost cost;
};

/// Two times that a wave of shear takes through the block.
Stretched stretch(Scheme const& scheme, double poisson) {
  double const young = 2 * shear_modulus * (1 + poisson), rate = 0.1 * std::sqrt(shear_modulus / density) / length;
  Scene<2> scene = scene_of<kinematics::PlaneStrainReduced, law::Hencky>(scheme, h, density, {young, poisson});
  scene.keeps_ledger = true;
  scene.limits.safety = StepLimits{}.safety;
  double const end = 2 * length / std::sqrt(shear_modulus / density), dt = elastic_step(scene);
  set_step(scene, dt);
  std::vector<Seed<2>> seeds;
  for (auto const& x : lattice<2>({-length / 2, -length / 2}, {8, 8}, {2, 2}, h)) {
    Seed<2> seed{x, rate * Point<2>(x[0], -x[1]), density * h * h / 4};
    seed.C.diagonal() << rate, -rate;
    seeds.push_back(seed);
  }
  auto const simulation = begin(std::move(scene), seeds);
  Stretched found;
  found.foretold = end / (StepLimits{}.safety * h * std::sqrt(2 / simulation->scene().stages->sharpness)) *
                   std::sqrt(2 * shear_modulus / (1 - 2 * poisson) / density);  // 2 lambda + 2 G = 2 G/(1 - 2 nu)
  auto const& ledger = simulation->ledger();
  double kinetic = ledger.start.kinetic, elastic = 0;
  take_steps(*simulation, std::lround(end / dt), found.cost, [&] {
    found.energy = std::max(found.energy, (elastic + 0.5 * (kinetic + ledger.now.kinetic)) / ledger.start.kinetic);
    kinetic = ledger.now.kinetic;
    elastic = ledger.now.elastic;
    found.residual = std::max(found.residual, std::abs(ledger.relative_energy_residual()));
  });
  auto const xx = column(*simulation, "elastic_strain", 0), yy = column(*simulation, "elastic_strain", 1);
  for (std::size_t p = 0; p < xx.size(); ++p) found.volume = std::max(found.volume, std::abs(xx[p] + yy[p]));
  return found;
}

void nearly_incompressible(Findings& findings, Scheme const& scheme) {
  for (double const poisson : {0.3, 0.45, 0.49, 0.499, 0.4999}) {
    Stretched const found = stretch(scheme, poisson);
    std::string const subject = fmt::format("{}, nu = {}", scheme.name(), poisson);
    findings.check(subject, "largest energy over that of the start", found.energy, at_most(1.02),
                   "no energy appears; 2 %: what the leapfrog's energy sways by, (omega dt)^2/4 of the slow waves",
                   found.cost);
    findings.check(subject, "residual of the energy", found.residual, at_most(1e-10), "every term is a sum of its own");
    findings.check(subject, "steps less those of (1)", double(found.cost.steps) - found.foretold, {-1, 1},
                   "(1), to the nearest step");
    findings.note(subject, "largest |tr eps| at the end", found.volume);
  }
}

void nearly_rigid(Findings& findings, Scheme const& scheme) {
  for (double const young : {1e6, 1e8, 1e10, 1e12}) {
    SlidingBox const box{.scheme = scheme, .angle = 16 * degree, .young = young};
    Slid const slid = slide(box, settled_sliding(box), 0.1);
    findings.check(fmt::format("{}, E = {:.0e} Pa", scheme.name(), young), "|x/x_exact - 1| at 0.1 s",
                   std::abs(slid.along / (box.acceleration() * slid.half_square()) - 1), at_most(1e-4),
                   "1e-4, as in friction/sliding_box", slid.cost);
  }
}

void run(Findings& findings) {
  for (Scheme const& scheme : all_schemes())
    if (scheme.degree() > 1) nearly_incompressible(findings, scheme);
  nearly_rigid(findings, {"quadratic", "apic"});
  nearly_rigid(findings, {"quadratic", "flip", "usl", 0.95});
}

}  // namespace

Case const the_case{"stability/stiff_blocks",
                    "Blocks that are nearly incompressible, or nearly rigid",
                    "energy, the bound of the step, Coulomb's law",
                    "derived in the case's file and verification/suite/sliding_box.hpp",
                    2,
                    60,
                    run};

}  // namespace talus::verification::stability_stiff_blocks
