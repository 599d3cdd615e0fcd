#pragma once
/// Scenes of cases: a scheme, one material, particles one by one; and a look at the particles by number.

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/by_number.hpp"
#include "models/make.hpp"
#include "verification/suite/findings.hpp"
#include "verification/suite/scheme.hpp"

namespace talus::verification {

/// A particle as a scene begins with it; its number is its place in the list.
template <int D>
struct Seed {
  Point<D> x = Point<D>::Zero();                                        ///< [m]
  Point<D> v = Point<D>::Zero();                                        ///< [m/s]
  double mass = 0;                                                      ///< [kg]
  Eigen::Matrix<double, D, D> C = Eigen::Matrix<double, D, D>::Zero();  ///< dv_i/dx_j, where the transfer is affine
  std::vector<double> strain = {};  ///< elastic strain, as the kinematics' shape orders it; empty: none
};

/// A scene of a scheme with one material, without walls, gravity and body force, neither periodic. The caller adds them
/// before it fills. The limits on the step by speed and gradient are as wide as possible: cases choose their step.
template <class Kinematics, class Law>
[[nodiscard]] Scene<Kinematics::dimension> scene_of(Scheme const& scheme, double spacing, double density,
                                                    typename Law::Parameters const& law, bool rubs = false) {
  Scene<Kinematics::dimension> scene;
  scene.spacing = spacing;
  scene.strain_size = Symmetric<double, typename Kinematics::Shape>::size;
  scene.materials.push_back(make_material<Kinematics, Law>("only", density, law));
  scene.stages = stages_of<Kinematics::dimension>(scheme, rubs);
  scene.limits.crossing = 0.5;
  scene.limits.gradient = 0.5;
  return scene;
}

/// Makes every step of the scene dt long [s], as far as speed and gradient allow. Beyond the stable step if so asked.
template <int D>
void set_step(Scene<D>& scene, double dt) {
  scene.limits.safety = 1;
  scene.limits.safety = dt / elastic_step(scene);
}

/// A simulation of the scene with these particles; it has begun.
template <int D>
[[nodiscard]] std::unique_ptr<Simulation<D>> begin(Scene<D> scene, std::vector<Seed<D>> const& seeds);

/// Takes n steps, all of the length that set_step asked for, and adds what they took. Throws RunError where a step had
/// to be shorter.
template <int D>
void take_steps(Simulation<D>& simulation, long n, Cost& cost, std::function<void()> const& after_each = {});

using talus::column;
using talus::vectors;

/// Centres of cells of a box, per_axis[d] of them to a cell of the grid along axis d, first axis slowest.
/// cells[d]: grid cells along axis d from `low` on.
template <int D>
[[nodiscard]] std::vector<Point<D>> lattice(Point<D> const& low, std::array<int, D> cells, std::array<int, D> per_axis,
                                            double spacing);

/// sqrt(sum w e^2 / sum w) with equal weights: e.g. of |u_p - u(X_p)| over particles of equal volume.
template <int D>
[[nodiscard]] double root_mean_square(std::vector<Point<D>> const& errors);
[[nodiscard]] double root_mean_square(std::vector<double> const& errors);

}  // namespace talus::verification
