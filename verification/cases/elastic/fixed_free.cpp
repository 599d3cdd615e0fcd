/// A bar that is held at X = 0 and free at X = L is thrown into its first mode:
///
///   u = v_0/omega sin(beta X) sin(omega t),  beta = pi/(2 L),  omega = beta sqrt(M/rho)                           (1)
///   x_cm = L/2 + v_0/(beta L omega) sin(omega t)                                                                   (2)
///
/// for small v_0. Velocities of symplectic Euler belong to half steps: they start at t = -dt/2, where (1) has them
/// cos(omega dt/2) as large. Compared after a quarter of a period and half a step's worth of time, where u is largest
/// and an error of the frequency hardly seen, and after five eighths.

#include <cmath>
#include <numbers>

#include "models/boundaries/contacts/slip.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/boundaries/motions/fixed.hpp"
#include "models/boundaries/shapes/half_space.hpp"
#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/laws/hencky.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/refinement.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification::elastic_fixed_free {

namespace {

constexpr double L = 25, modulus = 100, density = 1, v0 = 1e-4, courant = 0.2;
constexpr int per_cell = 2;
double const beta = std::numbers::pi / (2 * L), omega = beta * std::sqrt(modulus / density);

/// Errors of u (root mean square) and of x_cm over v_0/omega after a and b eighths of a period, the larger each.
Measured solved(Scheme const& scheme, int N) {
  double const h = L / N, dt = courant * h / std::sqrt(modulus / density);
  Scene<2> scene = scene_of<kinematics::PlaneStrainReduced, law::Hencky>(scheme, h, density, {modulus, 0});
  scene.periods = {0, 1};
  wall::HalfSpace::Parameters clamp;
  clamp.normal = {1, 0};
  clamp.point = {1e-4 * h, 0};  // a node on the face itself would be free to leave
  scene.walls.push_back(make_wall<2, wall::HalfSpace, wall::Slip, wall::Fixed>("clamp", clamp, {}, {}));
  set_step(scene, dt);
  std::vector<Seed<2>> seeds;
  double const start = v0 * std::cos(omega * dt / 2);
  for (auto const& x : lattice<2>({0, 0}, {N, block_edge}, {per_cell, 1}, h)) {
    Seed<2> seed;
    seed.x = x;
    seed.v[0] = start * std::sin(beta * x[0]);
    seed.C(0, 0) = start * beta * std::cos(beta * x[0]);
    seed.mass = density * h * h / per_cell;
    seeds.push_back(seed);
  }
  auto const simulation = begin(std::move(scene), seeds);
  Measured measured;
  measured.errors = {0, 0};
  long const quarter = std::lround(N / courant);  // steps
  for (long const steps : {quarter, quarter + quarter / 2}) {
    take_steps(*simulation, steps, measured.cost);
    double const t = simulation->time(), unit = v0 / omega;
    std::vector<double> off;
    double centre = 0;
    auto const x = column(*simulation, "position");
    for (std::size_t p = 0; p < x.size(); ++p) {
      double const u = x[p] - seeds[p].x[0];
      off.push_back((u - unit * std::sin(beta * seeds[p].x[0]) * std::sin(omega * t)) / unit);
      centre += u / double(x.size());
    }
    measured.errors[0] = std::max(measured.errors[0], root_mean_square(off));
    measured.errors[1] = std::max(measured.errors[1], std::abs(centre / unit - std::sin(omega * t) / (beta * L)));
  }
  return measured;
}

void run(Findings& findings) {
  constexpr int cells[] = {16, 32, 64, 128};
  for (Scheme const& scheme : all_schemes()) {
    if (scheme.transfer == "pic") continue;
    Refinement study;
    study.subject = scheme.name();
    for (int const N : cells) study.spacings.push_back(L / N);
    for (std::string const name : {"u", "centre of mass"}) {
      Norm norm;
      norm.name = name;
      norm.order = 0.85;
      norm.because = "2 inside; 1 of the wall, below which kernels reach where there are no particles";
      study.norms.push_back(norm);
    }
    study.solve = [&](std::size_t level) { return solved(scheme, cells[level]); };
    refine(findings, study, "Fixed-free bar");
  }
}

}  // namespace

Case const the_case{"elastic/fixed_free",
                    "First mode of a bar that is held at one end",
                    "the mode of the linear bar, in closed form",
                    "textbook; parameters as commonly used for this test (from memory)",
                    1,
                    20,
                    run};

}  // namespace talus::verification::elastic_fixed_free
