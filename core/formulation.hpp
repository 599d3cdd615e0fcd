#pragma once
/// A solver composed at compile time: a struct of choices, checked when it is named.
///
///     struct Sand {
///       using Kinematics = kinematics::PlaneStrain;
///       using Kernel = kernel::Quadratic;
///       using Transfer = transfer::Apic;
///       using Integrator = integrator::Usl;
///       using Law = law::DruckerPrager;
///     };
///     struct Clay : Sand { using Law = law::CamClay; };   // a variant overrides a line

#include <memory>
#include <utility>
#include <vector>

#include "core/filling.hpp"

namespace talus {

/// The choices that make a solver. Each must fulfil its own concept, and an affine transfer needs a kernel with a
/// constant inertia.
template <class F>
concept Formulation = Kinematics<typename F::Kinematics> && Kernel<typename F::Kernel> &&
    Transfer<typename F::Transfer> && Integrator<typename F::Integrator> && Law<typename F::Law> &&
    (!F::Transfer::affine || F::Kernel::inertia > 0);

/// The fields that a particle of a formulation has, at compile time.
template <Formulation F>
using ParticlesOf = Unite<Fields<field::Position, field::Velocity, field::Mass, field::ElasticStrain>,
                          typename F::Transfer::State, typename F::Law::State, Fields<field::Identity>>;

/// The values that go with a formulation.
template <Formulation F>
struct Setup {
  static constexpr int D = F::Kinematics::dimension;
  double spacing = 0;                   ///< h [m]
  double density = 0;                   ///< [kg/m^3]
  Point<D> gravity = Point<D>::Zero();  ///< [m/s^2]
  typename F::Law::Parameters law = {};
  typename F::Transfer::Parameters transfer = {};
  StepLimits limits = {};
  BlockIndex<D> periods = {};  ///< blocks after which an axis repeats, 0 where it does not
};

/// What a setup says of a scene: all but its material and its stages.
template <Formulation F>
[[nodiscard]] Scene<Setup<F>::D> scene_of(Setup<F> const& setup,
                                          std::vector<std::unique_ptr<Wall<Setup<F>::D>>> walls) {
  Scene<Setup<F>::D> scene;
  scene.spacing = setup.spacing;
  scene.gravity = setup.gravity;
  scene.limits = setup.limits;
  scene.periods = setup.periods;
  scene.strain_size = Symmetric<double, typename F::Kinematics::Shape>::size;
  scene.walls = std::move(walls);
  return scene;
}

/// A simulation of one material that fills bodies; it has begun.
template <Formulation F>
[[nodiscard]] auto compose(Setup<F> const& setup, std::vector<Filling<Setup<F>::D>> const& bodies,
                           std::vector<std::unique_ptr<Wall<Setup<F>::D>>> walls = {}) {
  constexpr int D = Setup<F>::D;
  Scene<D> scene = scene_of(setup, std::move(walls));
  scene.materials.push_back(std::make_unique<MaterialOf<typename F::Kinematics, typename F::Law>>(
      std::string(F::Law::name), setup.density, setup.law));
  scene.stages = std::make_unique<StagesOf<D, typename F::Kernel, typename F::Transfer, typename F::Integrator>>(
      setup.transfer, scene.rubs());
  auto simulation = std::make_unique<Simulation<D>>(std::move(scene));
  fill(*simulation, bodies);
  return simulation;
}

/// A simulation of one body, at rest.
template <Formulation F>
[[nodiscard]] auto compose(Setup<F> const& setup, body::Seeds<Setup<F>::D> seeds,
                           std::vector<std::unique_ptr<Wall<Setup<F>::D>>> walls = {}) {
  return compose(setup, std::vector{Filling<Setup<F>::D>{std::move(seeds), {}, {}, 0, setup.density}},
                 std::move(walls));
}

}  // namespace talus
