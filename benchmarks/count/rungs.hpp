#pragma once
/// The compositions whose instructions are counted: each adds one thing to another.

#include <string>
#include <vector>

#include "benchmarks/count/steps.hpp"
#include "benchmarks/scenes/compose.hpp"
#include "benchmarks/scenes/formulations.hpp"
#include "models/make_here.hpp"

namespace talus::bench {

/// What one run of a composition tells besides its instructions.
struct Counted {
  std::size_t particles = 0;
  int steps = 0, bytes = 0;  ///< that were counted; of a particle, as stored
};

/// `base`: the rung to which this one adds its own part; empty for the first.
struct Rung {
  std::string name, base;
  Counted (*run)();
};

/// What is around the block.
enum class Around { nothing, walls, rubbing_walls, itself };

/// A block of about 3500 particles that is sheared and compressed, so that every law yields, for a number of steps
/// without a sort.
template <Formulation F, Around around>
Counted run() {
  constexpr int D = F::Kinematics::dimension, warm = 5, steps = 20;
  Filling filling;
  filling.particles = D == 2 ? 24 * 24 * 6 : 8 * 8 * 8 * 8;
  filling.a_cell = D == 2 ? 6 : 8;
  auto cloud = block<D>(filling);
  for (std::size_t k = 0; k < cloud.count(); ++k) {
    double const height = cloud.places[k][1] - cloud.low[1];
    cloud.velocities[k].setZero();
    cloud.velocities[k][0] = 4 * height;
    cloud.velocities[k][1] = -2 * height;
  }
  auto setting = setup<F>(cloud.spacing);
  if (around == Around::itself) setting.periods[0] = 24 / block_edge;
  Walls<D> walls;
  if (around == Around::walls) walls = corner<D>(cloud.low);
  if (around == Around::rubbing_walls) walls = rubbing_corner<D>(cloud.low);
  auto simulation = simulate<F>(setting, {cloud}, std::move(walls));
  take_steps(*simulation, warm);
  simulation->begin();
  counted_steps(*simulation, steps);
  return {cloud.count(), steps, simulation->particles().layout().bytes_per_particle()};
}

/// A formulation alone, then with what can be around it; `name` begins with the dimension.
template <Formulation F>
void add(std::vector<Rung>& rungs, std::string const& name, std::string const& base) {
  constexpr bool plane = F::Kinematics::dimension == 2;
  rungs.push_back({name, base, &run<F, Around::nothing>});
  rungs.push_back({name + ", walls", name, &run<F, Around::walls>});
  if constexpr (plane && HasFriction<typename F::Law>)
    rungs.push_back({name + ", friction", name + ", walls", &run<F, Around::rubbing_walls>});
  if constexpr (plane) rungs.push_back({name + ", periodic", name, &run<F, Around::itself>});
}

/// The ladder in one dimension, quadratic kernel.
template <int D>
void add_ladder(std::vector<Rung>& rungs) {
  using K = kernel::Quadratic;
  using transfer::Aflip, transfer::Apic, transfer::Flip, transfer::Pic;
  std::string const d = D == 2 ? "2-D " : "3-D ";
  add<Of<D, K, Pic>>(rungs, d + "elastic PIC", "");
  add<Of<D, K, Flip>>(rungs, d + "elastic FLIP", d + "elastic PIC");
  add<Of<D, K, Apic>>(rungs, d + "elastic APIC", d + "elastic PIC");
  add<Of<D, K, Aflip>>(rungs, d + "elastic AFLIP", d + "elastic APIC");
  add<Of<D, K, Apic, law::DruckerPrager>>(rungs, d + "Drucker-Prager APIC", d + "elastic APIC");
  add<Of<D, K, Apic, law::CamClay>>(rungs, d + "Cam-Clay APIC", d + "elastic APIC");
  add<Of<D, K, Apic, law::CamClayMuI>>(rungs, d + "Cam-Clay mu(I) APIC", d + "Cam-Clay APIC");
  if constexpr (D == 2)
    add<Of<D, K, Aflip, law::CamClayMuI>>(rungs, d + "Cam-Clay mu(I) AFLIP", d + "Cam-Clay mu(I) APIC");
}

void add_plane(std::vector<Rung>& rungs);
void add_solid(std::vector<Rung>& rungs);

}  // namespace talus::bench
