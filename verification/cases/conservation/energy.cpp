/// The ledger of energy and angular momentum closes in a scene in which everything happens: two plastic blocks collide
/// in a box, and meet walls that stick, slip, let go, rub with a friction of their own or the material's, mirror, and
/// move, under gravity and a body force that turns with time.
///
///   (K + E_e)' - (K + E_e) = gravity + body force + walls - plastic - transfer - stepping                         (1)
///
/// Each term is summed on its own over particles or nodes (core/ledger.hpp); what is left over is rounding if the
/// nodes' work is the particles'. Gravity's work, the body force's and the walls' impulses are summed here once more,
/// from outside. The plastic work of laws that dissipate is never negative, in any step.

#include <cmath>

#include "models/boundaries/contacts/coulomb.hpp"
#include "models/boundaries/contacts/material_friction.hpp"
#include "models/boundaries/contacts/mirrored_slip.hpp"
#include "models/boundaries/contacts/mirrored_stick.hpp"
#include "models/boundaries/contacts/separating.hpp"
#include "models/boundaries/contacts/slip.hpp"
#include "models/boundaries/contacts/stick.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/boundaries/motions/fixed.hpp"
#include "models/boundaries/motions/translation.hpp"
#include "models/boundaries/shapes/box.hpp"
#include "models/boundaries/shapes/half_space.hpp"
#include "models/kinematics/plane_strain.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/cam_clay_mu_i.hpp"
#include "models/laws/drucker_prager.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification::conservation_energy {

namespace {

constexpr double h = 0.1, density = 1500, E = 2e5, nu = 0.3;

/// Pulls each particle its own way, which turns.
template <int D>
class Swirl final : public BodyForce<D> {
 public:
  [[nodiscard]] Point<D> acceleration(long id, double t) const override {
    Point<D> b = Point<D>::Zero();
    b[0] = 5 * std::sin(double(id) + 20 * t);
    b[1] = 5 * std::cos(double(id) + 20 * t);
    return b;
  }
};

/// floor x_1 = 0, sides x_0 = 0 and 1, an obstacle and, in space, a back.
template <int D>
void add_walls(Scene<D>& scene) {
  using namespace wall;
  HalfSpace::Parameters const floor{{0, 0, 0}, {0.1, 1, 0}}, left{{0, 0, 0}, {1, 0, 0}}, right{{1, 0, 0}, {-1, 0, 0}},
      lid{{0, 0.62, 0}, {0, -1, 0}}, back{{0, 0, 0}, {0, 0, 1}};
  scene.walls.push_back(make_wall<D, HalfSpace, MaterialFriction, Fixed>("floor", floor, {}, {}));
  scene.walls.push_back(make_wall<D, HalfSpace, Coulomb, Translation>("left", left, {0.3}, {{0.6, 0.2, 0}, 0, 0.05}));
  scene.walls.push_back(make_wall<D, HalfSpace, Separating, Fixed>("right", right, {}, {}));
  scene.walls.push_back(make_wall<D, HalfSpace, Slip, Fixed>("lid", lid, {}, {}));
  Box::Parameters obstacle;
  obstacle.min = {0.4, -1, -1};
  obstacle.max = {0.6, 0.1, 1};
  scene.walls.push_back(make_wall<D, Box, Stick, Fixed>("obstacle", obstacle, {}, {}));
  if constexpr (D == 3) scene.walls.push_back(make_wall<D, HalfSpace, Slip, Fixed>("back", back, {}, {}));
}

/// The same box of mirrors that meet at corners, the floor drawn along itself; on the right a wall that lets go.
template <int D>
void add_mirrors(Scene<D>& scene) {
  using namespace wall;
  HalfSpace::Parameters const floor{{0, 0, 0}, {0, 1, 0}}, left{{0, 0, 0}, {1, 0, 0}}, right{{1, 0, 0}, {-1, 0, 0}},
      back{{0, 0, 0}, {0, 0, 1}};
  scene.walls.push_back(
      make_wall<D, HalfSpace, MirroredStick, Translation>("floor", floor, {}, {{0.6, 0, 0}, 0, 0.05}));
  scene.walls.push_back(make_wall<D, HalfSpace, MirroredSlip, Fixed>("left", left, {}, {}));
  scene.walls.push_back(make_wall<D, HalfSpace, Separating, Fixed>("right", right, {}, {}));
  if constexpr (D == 3) scene.walls.push_back(make_wall<D, HalfSpace, MirroredSlip, Fixed>("back", back, {}, {}));
}

template <int D>
std::vector<Seed<D>> two_blocks() {
  std::vector<Seed<D>> seeds;
  std::array<int, D> cells, per_axis;
  cells.fill(D == 2 ? 4 : 3);
  per_axis.fill(2);
  for (double const side : {0.0, 1.0}) {
    Point<D> low = Point<D>::Constant(0.07), v = Point<D>::Constant(-1 + 1.2 * side);
    low[0] = 0.03 + 0.52 * side;
    low[1] = 0.12 + 0.07 * side;
    v[0] = 2 - 5 * side;
    for (auto const& x : lattice<D>(low, cells, per_axis, h)) {
      Seed<D> seed;
      seed.x = x;
      seed.v = v;
      seed.mass = density * std::pow(h / 2, D);
      seeds.push_back(seed);
    }
  }
  return seeds;
}

/// A law with its parameters: what is asked of each is the same.
struct Sand {
  using Law = law::DruckerPrager;
  static Law::Parameters parameters() {
    Law::Parameters p;
    p.E = E;
    p.nu = nu;
    p.c = 200;
    return p;
  }
};
struct Clay {
  using Law = law::CamClayMuI;
  static Law::Parameters parameters() {
    Law::Parameters p;
    p.E = E;
    p.nu = nu;
    p.beta = 0.2;
    return p;
  }
};

/// What is followed besides the ledger, step by step.
template <int D>
struct Followed {
  double worst = 0, worst_spin = 0, least_plastic = 0, largest_spin = 0;
};

template <int D>
Followed<D> follow_ledger(Simulation<D>& simulation, long steps, Cost& cost) {
  Followed<D> followed;
  double plastic = 0;
  take_steps(simulation, steps, cost, [&] {
    auto const& ledger = simulation.ledger();
    followed.worst = std::max(followed.worst, std::abs(ledger.relative_energy_residual()));
    for (Spin<D> const& spin :
         {ledger.now.spin, ledger.gravity_torque, ledger.wall_torque, ledger.transfer_spin, ledger.body_force.torque})
      followed.largest_spin = std::max(followed.largest_spin, spin.norm());
    followed.worst_spin = std::max(followed.worst_spin, ledger.spin_residual().norm());
    followed.least_plastic = std::min(followed.least_plastic, ledger.plastic - plastic);
    plastic = ledger.plastic;
  });
  return followed;
}

/// Momentum at the end less all that came in, over the largest of the terms.
template <int D>
double momentum_left_over(Simulation<D> const& simulation) {
  auto const& ledger = simulation.ledger();
  Point<D> left =
      ledger.now.momentum - ledger.start.momentum - simulation.momentum().gravity - ledger.body_force.impulse;
  double scale =
      std::max({ledger.now.momentum.norm(), ledger.start.momentum.norm(), simulation.momentum().gravity.norm()});
  for (auto const& impulse : simulation.momentum().walls) {
    left -= impulse;
    scale = std::max(scale, impulse.norm());
  }
  return left.norm() / scale;
}

template <class Kinematics, class Material>
void of(Findings& findings, Scheme const& scheme, long steps, std::string const& what,
        void (*add)(Scene<Kinematics::dimension>&) = add_walls<Kinematics::dimension>) {
  constexpr int D = Kinematics::dimension;
  Scene<D> scene = scene_of<Kinematics, typename Material::Law>(scheme, h, density, Material::parameters(), true);
  scene.gravity = -9.81 * Point<D>::Unit(1);
  scene.keeps_ledger = true;
  scene.body_force = std::make_unique<Swirl<D>>();
  add(scene);
  set_step(scene, 2e-4);
  auto const simulation = begin(std::move(scene), two_blocks<D>());
  Cost cost;
  Followed<D> const found = follow_ledger(*simulation, steps, cost);
  auto const& ledger = simulation->ledger();
  std::string const subject = scheme.name() + ", " + what;
  findings.check(subject, "residual of energy", found.worst, at_most(1e-10), "every term is a sum of its own", cost);
  if (scheme.degree() > 1)
    findings.check(subject, "residual of angular momentum", found.worst_spin / found.largest_spin, at_most(1e-10),
                   "every term is a sum of its own");
  findings.check(subject, "least plastic work of a step", found.least_plastic / ledger.start.kinetic, at_least(-1e-14),
                 "dissipation is never negative");
  findings.check(subject, "plastic work over the energy at the start", ledger.plastic / ledger.start.kinetic,
                 at_least(1e-3), "else it would prove little");
  if (scheme.degree() > 1)
    findings.check(subject, "residual of momentum", momentum_left_over(*simulation), at_most(1e-12), "exact");
}

void run(Findings& findings) {
  for (std::string const integrator : {"usl", "musl"})
    for (Scheme const& scheme : all_schemes(integrator)) {
      of<kinematics::PlaneStrain, Sand>(findings, scheme, 800, "sand, 2-D");
      if (scheme.degree() == 2) of<kinematics::PlaneStrain, Clay>(findings, scheme, 400, "clay, 2-D");
      if (scheme.degree() == 2) of<kinematics::Solid, Sand>(findings, scheme, 300, "sand, 3-D");
    }
  for (std::string const integrator : {"usl", "musl"})
    for (Scheme const& scheme : all_schemes(integrator, 0.9)) {
      if (scheme.degree() == 1) continue;
      of<kinematics::PlaneStrain, Sand>(findings, scheme, 400, "sand between mirrors, 2-D", add_mirrors<2>);
      if (scheme.degree() == 2)
        of<kinematics::Solid, Sand>(findings, scheme, 200, "sand between mirrors, 3-D", add_mirrors<3>);
    }
  findings.omit(
      "linear", "momentum and angular momentum",
      "internal forces on nodes of next to no mass are weakened, for the time step's sake; neither is kept there");
}

}  // namespace

Case const the_case{"conservation/energy",
                    "Plastic blocks collide between walls of every kind: the ledger closes",
                    "the balance of energy and angular momentum",
                    "derived in core/ledger.hpp",
                    0,
                    15,
                    run};

}  // namespace talus::verification::conservation_energy
