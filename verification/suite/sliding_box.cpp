#include "verification/suite/sliding_box.hpp"

#include <algorithm>
#include <cmath>

#include "models/boundaries/contacts/coulomb.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/boundaries/motions/translation.hpp"
#include "models/boundaries/shapes/half_space.hpp"
#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/laws/hencky.hpp"

namespace talus::verification {

namespace {

std::vector<Seed<2>> unstressed(SlidingBox const& box) {
  double const apart = box.spacing / box.per_axis;
  auto const columns = std::lround(box.length / apart), rows = std::lround(box.height / apart);
  std::vector<Seed<2>> seeds;
  for (long i = 0; i < columns; ++i)
    for (long j = 0; j < rows; ++j)
      seeds.push_back({apart * ((double(i) + 0.5) * box.down() + (double(j) + 0.5) * box.normal()), Point<2>::Zero(),
                       box.density * apart * apart});
  return seeds;
}

/// Largest difference of a particle's velocity from the mean [m/s].
double unrest(Simulation<2> const& simulation) {
  auto const v = vectors(simulation, "velocity");
  Point<2> mean = Point<2>::Zero();
  for (auto const& one : v) mean += one / double(v.size());
  double most = 0;
  for (auto const& one : v) most = std::max(most, (one - mean).norm());
  return most;
}

/// Runs PIC until all velocities are the same, and brings the box to rest.
std::vector<Seed<2>> settle(SlidingBox box, Point<2> const& gravity, double belt) {
  box.scheme.transfer = "pic";
  box.scheme.alpha = 1;
  box.step = 0.8;
  std::vector<Seed<2>> seeds = unstressed(box);
  auto const simulation = begin(scene_of_box(box, gravity, belt), seeds);
  Cost ignored;
  for (int turn = 0; turn < 100; ++turn) {
    take_steps(*simulation, 500, ignored);
    if (unrest(*simulation) < 1e-12) break;
  }
  auto const x = vectors(*simulation, "position");
  for (int c = 0; c < 3; ++c) {
    auto const strain = column(*simulation, "elastic_strain", c);
    for (std::size_t p = 0; p < seeds.size(); ++p) seeds[p].strain.push_back(strain[p]);
  }
  for (std::size_t p = 0; p < seeds.size(); ++p) seeds[p].x = x[p];
  return seeds;
}

}  // namespace

Point<2> SlidingBox::down() const {
  return {std::cos(lean), -std::sin(lean)};
}
Point<2> SlidingBox::normal() const {
  return {std::sin(lean), std::cos(lean)};
}
Point<2> SlidingBox::pull() const {
  return gravity * (std::sin(angle) * down() - std::cos(angle) * normal());
}
double SlidingBox::acceleration() const {
  return gravity * (std::sin(angle) - friction * std::cos(angle));
}

Scene<2> scene_of_box(SlidingBox const& box, Point<2> const& gravity, double belt) {
  Scene<2> scene = scene_of<kinematics::PlaneStrainReduced, law::Hencky>(box.scheme, box.spacing, box.density,
                                                                         {box.young, box.poisson});
  Point<2> const n = box.normal(), w = -belt * box.down();
  scene.walls.push_back(make_wall<2, wall::HalfSpace, wall::Coulomb, wall::Translation>(
      "plane", {{0, 0}, {n[0], n[1]}}, {box.friction}, {{w[0], w[1]}}));
  scene.gravity = gravity;
  scene.limits.safety = box.step;
  set_step(scene, elastic_step(scene));
  return scene;
}

std::vector<Seed<2>> settled_sliding(SlidingBox const& box, bool upslope) {
  double const pressing = box.gravity * std::cos(box.angle), way = upslope ? -1 : 1;
  return settle(box, pressing * (way * box.friction * box.down() - box.normal()), way);
}

std::vector<Seed<2>> settled_sticking(SlidingBox const& box) {
  return settle(box, box.pull(), 0);
}

double mean_velocity(Simulation<2> const& simulation, Point<2> const& direction) {
  double sum = 0;
  auto const v = vectors(simulation, "velocity");
  for (auto const& one : v) sum += one.dot(direction);
  return sum / double(v.size());
}

double mean_way(Simulation<2> const& simulation, std::vector<Seed<2>> const& from, Point<2> const& direction) {
  auto const x = vectors(simulation, "position");
  double sum = 0;
  for (std::size_t p = 0; p < x.size(); ++p) sum += (x[p] - from[p].x).dot(direction);
  return sum / double(x.size());
}

Slid slide(SlidingBox const& box, std::vector<Seed<2>> const& seeds, double end,
           std::function<void(Simulation<2> const&)> const& after_each) {
  auto const simulation = begin(scene_of_box(box, box.pull()), seeds);
  Slid slid;
  slid.step = elastic_step(simulation->scene());
  long const steps = std::lround(end / slid.step);
  slid.time = double(steps) * slid.step;
  double const weight = box.mass() * box.gravity * std::cos(box.angle) * slid.step;
  Point<2> before = Point<2>::Zero();
  take_steps(*simulation, steps, slid.cost, [&] {
    Point<2> const impulse = simulation->momentum().walls[0] - before;
    before = simulation->momentum().walls[0];
    double const N = impulse.dot(box.normal()) / weight, T = -impulse.dot(box.down()) / weight;
    slid.short_by += (N - T / box.friction) / double(steps);
    slid.excess = std::max(slid.excess, T / box.friction - N);
    slid.least_load = std::min(slid.least_load, N);
    slid.greatest_load = std::max(slid.greatest_load, N);
    if (after_each) after_each(*simulation);
  });
  slid.along = mean_way(*simulation, seeds, box.down());
  slid.away = mean_way(*simulation, seeds, box.normal());
  auto const x = vectors(*simulation, "position");
  for (std::size_t p = 0; p < seeds.size();
       p += static_cast<std::size_t>(box.per_axis * std::lround(box.height / box.spacing)))
    slid.base_slip = std::max(slid.base_slip, (x[p] - seeds[p].x).norm());
  return slid;
}

}  // namespace talus::verification
