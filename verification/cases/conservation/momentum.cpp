/// Momentum changes by what gravity and walls give, step by step, whatever the scheme:
///
///   sum_p m_p v_p = sum_p m_p v_p^0 + M g t + sum_walls sum_n m_n (v_n' - v_n*)                                   (1)
///
/// over fifty steps in which two blocks meet each other, a wall that sticks and a moving one that rubs; without walls
/// and gravity, momentum stays as it is. The linear kernel drops what lies on nodes of next to no mass (its time step
/// would else have no bound): it is asked of a space that is filled and repeats.

#include <cmath>
#include <numbers>

#include "models/boundaries/contacts/coulomb.hpp"
#include "models/boundaries/contacts/stick.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/boundaries/motions/fixed.hpp"
#include "models/boundaries/motions/translation.hpp"
#include "models/boundaries/shapes/half_space.hpp"
#include "models/kinematics/plane_strain.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/hencky.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification::conservation_momentum {

namespace {

constexpr double h = 0.1, density = 1000, E = 1e5;
constexpr int steps = 50;

template <int D>
std::vector<Seed<D>> block(Point<D> const& low, int edge, int per_axis, Point<D> const& v) {
  std::array<int, D> cells, per;
  cells.fill(edge);
  per.fill(per_axis);
  std::vector<Seed<D>> seeds;
  for (auto const& x : lattice<D>(low, cells, per, h)) {
    Seed<D> seed;
    seed.x = x;
    seed.v = v;
    seed.mass = density * std::pow(h / per_axis, D);
    seeds.push_back(seed);
  }
  return seeds;
}

template <int D>
std::vector<Seed<D>> two_blocks() {
  Point<D> shift = Point<D>::Constant(0.7 * h), v = Point<D>::Constant(-0.4);
  shift[0] = 3.3 * h;
  v[0] = 1;
  auto seeds = block<D>(Point<D>::Constant(0.2 * h), 3, 2, v);
  v[0] = -1.5;
  auto const other = block<D>(shift, 3, 2, v);
  seeds.insert(seeds.end(), other.begin(), other.end());
  return seeds;
}

/// A space of 8 cells that repeats, and waves in it.
template <int D>
std::vector<Seed<D>> filled() {
  auto seeds = block<D>(Point<D>::Zero(), 8, 2, Point<D>::Constant(0.3));
  for (auto& seed : seeds) seed.v[0] += 0.2 * std::sin(2 * std::numbers::pi * (seed.x[0] + seed.x[1]) / (8 * h));
  return seeds;
}

template <int D>
void add_walls(Scene<D>& scene) {
  wall::HalfSpace::Parameters floor, side;
  floor.normal = {0, 1, 0};
  side.normal = {1, 0.5, 0};
  scene.walls.push_back(make_wall<D, wall::HalfSpace, wall::Stick, wall::Fixed>("floor", floor, {}, {}));
  scene.walls.push_back(
      make_wall<D, wall::HalfSpace, wall::Coulomb, wall::Translation>("side", side, {0.4}, {{0.5, 0, 0}, 0, 1}));
  scene.gravity[1] = -10;
}

/// Largest distance from (1) after any step, over the largest sum of m |v|; and the least impulse of a wall over it.
struct Balance {
  double off = 0, scale = 0, least_wall = 0;
};

template <int D>
Balance balance(Simulation<D>& simulation, Cost& cost) {
  auto const mass = column(simulation, "mass");
  Balance balance;
  auto const momentum = [&] {
    Point<D> sum = Point<D>::Zero();
    double size = 0;
    auto const v = vectors(simulation, "velocity");
    for (std::size_t p = 0; p < v.size(); ++p) {
      sum += mass[p] * v[p];
      size += mass[p] * v[p].norm();
    }
    balance.scale = std::max(balance.scale, size);
    return sum;
  };
  double total = 0;
  for (double const m : mass) total += m;
  Point<D> const start = momentum();
  take_steps(simulation, steps, cost, [&] {
    Point<D> in = start + total * simulation.time() * simulation.scene().gravity;
    for (auto const& impulse : simulation.momentum().walls) in += impulse;
    balance.off = std::max(balance.off, (momentum() - in).norm());
  });
  balance.off /= balance.scale;
  balance.least_wall = balance.scale;
  for (auto const& impulse : simulation.momentum().walls)
    balance.least_wall = std::min(balance.least_wall, impulse.norm() / balance.scale);
  return balance;
}

template <class Kinematics>
void of(Findings& findings, Scheme const& scheme, bool walls, std::string const& where) {
  constexpr int D = Kinematics::dimension;
  bool const linear = scheme.degree() == 1;
  Scene<D> scene = scene_of<Kinematics, law::Hencky>(scheme, h, density, {E, 0.3});
  if (walls) add_walls(scene);
  if (linear) scene.periods.fill(2);
  set_step(scene, 0.3 * elastic_step(scene) / scene.limits.safety);
  auto const simulation = begin(std::move(scene), linear ? filled<D>() : two_blocks<D>());
  Cost cost;
  Balance const found = balance(*simulation, cost);
  std::string const subject = scheme.name() + ", " + where;
  findings.check(subject, walls ? "momentum, gravity and walls" : "momentum", found.off, at_most(1e-13),
                 "exact in every scheme; rounding of sums", cost);
  if (walls)
    findings.check(subject, "least impulse of a wall", found.least_wall, at_least(1e-4), "else it would prove nothing");
}

void run(Findings& findings) {
  for (std::string const integrator : {"usl", "musl"})
    for (Scheme const& scheme : all_schemes(integrator))
      for (bool const walls : {false, true}) {
        if (walls && scheme.degree() == 1) continue;
        of<kinematics::PlaneStrain>(findings, scheme, walls, "2-D");
        of<kinematics::Solid>(findings, scheme, walls, "3-D");
      }
  findings.omit("linear", "momentum at free surfaces", "internal forces on nodes of next to no mass are weakened");
}

}  // namespace

Case const the_case{"conservation/momentum",
                    "Momentum changes by what gravity and walls give",
                    "the balance of momentum",
                    "Newton's second law",
                    0,
                    10,
                    run};

}  // namespace talus::verification::conservation_momentum
