#pragma once
/// From a cloud to a simulation.

#include <memory>
#include <utility>
#include <vector>

#include "benchmarks/scenes/cloud.hpp"
#include "core/formulation.hpp"
#include "models/boundaries/contacts/material_friction.hpp"
#include "models/boundaries/contacts/separating.hpp"
#include "models/boundaries/contacts/stick.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/boundaries/motions/fixed.hpp"
#include "models/boundaries/shapes/half_space.hpp"
#include "models/make.hpp"

namespace talus::bench {

template <int D>
using Walls = std::vector<std::unique_ptr<Wall<D>>>;

/// The coordinate planes through a point, which the material is above of; the floor is the one across axis 1.
template <int D, class Floor, class Sides>
[[nodiscard]] Walls<D> planes(Point<D> const& low) {
  Walls<D> walls;
  for (int d = 0; d < D; ++d) {
    wall::HalfSpace::Parameters plane;
    for (int k = 0; k < D; ++k) {
      plane.point.values[static_cast<std::size_t>(k)] = low[k];
      plane.normal.values[static_cast<std::size_t>(k)] = k == d ? 1 : 0;
    }
    if (d == 1)
      walls.push_back(make_wall<D, wall::HalfSpace, Floor, wall::Fixed>("floor", plane, {}, {}));
    else
      walls.push_back(make_wall<D, wall::HalfSpace, Sides, wall::Fixed>("side", plane, {}, {}));
  }
  return walls;
}

/// The material sticks to the floor, and the other planes only push.
template <int D>
[[nodiscard]] Walls<D> corner(Point<D> const& low) {
  return planes<D, wall::Stick, wall::Separating>(low);
}

/// All of them rub as the material does in itself.
template <int D>
[[nodiscard]] Walls<D> rubbing_corner(Point<D> const& low) {
  return planes<D, wall::MaterialFriction, wall::MaterialFriction>(low);
}

/// A simulation of clouds of one material, with these walls; it has begun.
template <Formulation F>
[[nodiscard]] std::unique_ptr<Simulation<F::Kinematics::dimension>> simulate(
    Setup<F> const& setup, std::vector<Cloud<F::Kinematics::dimension>> const& clouds,
    Walls<F::Kinematics::dimension> walls) {
  constexpr int D = F::Kinematics::dimension;
  Scene<D> scene = scene_of(setup, std::move(walls));
  scene.materials.push_back(make_material<typename F::Kinematics, typename F::Law>("beads", setup.density, setup.law));
  scene.stages =
      make_stages<D, typename F::Kernel, typename F::Transfer, typename F::Integrator>(setup.transfer, scene.rubs());
  auto simulation = std::make_unique<Simulation<D>>(std::move(scene));
  std::vector<talus::Filling<D>> fillings;
  for (Cloud<D> const& cloud : clouds)
    fillings.push_back({{cloud.places, cloud.volume}, cloud.velocities, {}, 0, setup.density});
  fill(*simulation, fillings);
  return simulation;
}

}  // namespace talus::bench
