#pragma once
/// Scenes that are put together in code, and a look at their particles by number.

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "core/by_number.hpp"
#include "models/make.hpp"

namespace talus::support {

/// A particle as a scene begins with it.
template <int D>
struct Seed {
  Point<D> x = Point<D>::Zero(), v = Point<D>::Zero();
  double mass = 1;
  Matrix<double, D> C{};  ///< affine velocity; left out where the transfer has none
};

/// A scene of one material in this kinematics with these stages, without walls and gravity.
template <class Kinematics, class Law, class Kernel, class Transfer, class Integrator>
Scene<Kinematics::dimension> scene_of(double spacing, double density, typename Law::Parameters const& law,
                                      typename Transfer::Parameters const& transfer) {
  Scene<Kinematics::dimension> scene;
  scene.spacing = spacing;
  scene.strain_size = Symmetric<double, typename Kinematics::Shape>::size;
  scene.materials.push_back(make_material<Kinematics, Law>("only", density, law));
  scene.stages = make_stages<Kinematics::dimension, Kernel, Transfer, Integrator>(transfer, false);
  return scene;
}

/// Puts particles of the first material in and begins. Particle k gets the number k.
template <int D>
void fill(Simulation<D>& simulation, std::vector<Seed<D>> const& seeds) {
  Particles<D>& particles = simulation.particles();
  Layout const& layout = particles.layout();
  particles.allocate({Run{0, 0, 0, static_cast<int>(seeds.size())}}, 1);
  int const affine = layout.find("affine_velocity");
  std::vector<std::pair<int, double>> start;
  simulation.scene().materials.front()->start(start);
  for (std::size_t k = 0; k < seeds.size(); ++k) {
    auto const slot = static_cast<std::ptrdiff_t>(k);
    for (int i = 0; i < D; ++i) {
      particles.set(slot, layout.find(field::position) + i, seeds[k].x[i]);
      particles.set(slot, layout.find(field::velocity) + i, seeds[k].v[i]);
      for (int j = 0; affine >= 0 && j < D; ++j) particles.set(slot, affine + i * D + j, seeds[k].C(i, j));
    }
    particles.set(slot, layout.find(field::mass), seeds[k].mass);
    particles.set(slot, layout.find(field::identity), double(k));
    for (auto const& [pack, value] : start) particles.set(slot, pack, value);
  }
  simulation.begin();
}

using talus::column;
using talus::vectors;

/// Particles of equal mass in a box from `low` to `high`, `per_axis` a cell along each axis, each shifted by up to
/// `shift` times their distance at random.
template <int D>
std::vector<Seed<D>> block(Point<D> const& low, Point<D> const& high, double spacing, int per_axis, double density,
                           double shift, unsigned random_seed) {
  std::mt19937_64 engine(random_seed);
  auto const random = [&] { return 2 * double(engine() >> 11) * 0x1p-53 - 1; };
  double const distance = spacing / per_axis;
  std::vector<Seed<D>> seeds;
  Eigen::Array<int, D, 1> const count = ((high - low).array() / distance).round().template cast<int>();
  for (int place = 0; place < count.prod(); ++place) {
    Seed<D> seed;
    int rest = place;
    for (int d = D - 1; d >= 0; --d) {
      seed.x[d] = low[d] + (rest % count[d] + 0.5 + shift * random()) * distance;
      rest /= count[d];
    }
    seed.mass = density * std::pow(distance, D);
    seeds.push_back(seed);
  }
  return seeds;
}

}  // namespace talus::support
