/// An unstressed block without gravity stays at rest: nothing comes from nothing.

#include <cmath>

#include "models/kinematics/plane_strain.hpp"
#include "models/laws/hencky.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification::elastic_rest {

namespace {

constexpr double h = 0.1, density = 1500;

void run(Findings& findings) {
  for (Scheme const& scheme : all_schemes()) {
    Scene<2> scene = scene_of<kinematics::PlaneStrain, law::Hencky>(scheme, h, density, {1e6, 0.3});
    set_step(scene, 0.5 * elastic_step(scene) / scene.limits.safety);
    std::vector<Seed<2>> seeds;
    for (auto const& x : lattice<2>({0.013, 0.027}, {2, 3}, {2, 2}, h)) {
      Seed<2> seed;
      seed.x = x;
      seed.mass = density * h * h / 4;
      seeds.push_back(seed);
    }
    auto const simulation = begin(std::move(scene), seeds);
    Cost cost;
    take_steps(*simulation, 10000, cost);
    double most = 0;
    for (auto const& v : vectors(*simulation, "velocity")) most = std::max(most, v.norm());
    findings.check(scheme.name(), "largest speed after 10^4 steps", most, at_most(1e-12), "rest is a solution", cost)
        .unit = "m/s";
  }
}

}  // namespace

Case const the_case{"elastic/rest", "A block at rest stays at rest", "rest", "by definition", 0, 5, run};

}  // namespace talus::verification::elastic_rest
