#pragma once
/// All that a simulation is composed of, besides its particles.

#include <algorithm>
#include <memory>
#include <vector>

#include "core/block_grid.hpp"
#include "core/body_force.hpp"
#include "core/material.hpp"
#include "core/stages.hpp"
#include "core/wall.hpp"

namespace talus {

/// Limits of the time step; see core/time_step.hpp.
struct StepLimits {
  double safety = 0.8;    ///< share of the isolated-particle bound
  double crossing = 0.5;  ///< cells that a particle may cross in a step
  double gradient = 0.2;  ///< dt |L|
};

template <int D>
struct Scene {
  double spacing = 0;                   ///< h [m]
  BlockIndex<D> periods{};              ///< blocks after which an axis repeats, 0 where it does not
  Point<D> gravity = Point<D>::Zero();  ///< [m/s^2]
  StepLimits limits;
  int strain_size = 0;  ///< numbers of the kinematics' strain
  std::vector<std::unique_ptr<Material<D>>> materials;
  std::vector<std::unique_ptr<Wall<D>>> walls;
  std::unique_ptr<Stages<D>> stages;
  std::unique_ptr<BodyForce<D>> body_force;  ///< besides gravity; usually there is none
  bool keeps_ledger = false;                 ///< energy and angular momentum are accounted for in every step

  /// Whether a wall takes its friction from the material.
  [[nodiscard]] bool rubs() const {
    return std::ranges::any_of(walls, [](auto const& wall) { return wall->contact.material_friction; });
  }

  /// The fields that the parts ask for, each once.
  [[nodiscard]] Layout layout() const {
    Layout all(D, strain_size);
    all.unite(Fields<field::Position, field::Velocity, field::Mass, field::ElasticStrain>{});
    stages->declare(all);
    for (auto const& material : materials) material->declare(all);
    all.unite(Fields<field::Identity>{});
    return all;
  }
};

}  // namespace talus
