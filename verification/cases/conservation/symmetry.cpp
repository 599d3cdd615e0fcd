/// What must not matter does not: the solution of a mirrored or turned problem is the mirrored or turned solution, the
/// order of the particles and the number of threads play no part.
///
/// Two elastic blocks collide askew under gravity, besides a wall that rubs. The grid's nodes lie on the mirror lines,
/// so the discrete problem has the symmetry exactly; what differs is the order of sums, hence rounding. The bits are the
/// same for any number of threads.

#include <algorithm>
#include <cmath>
#include <random>

#include "core/parallel.hpp"
#include "models/boundaries/contacts/coulomb.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/boundaries/motions/fixed.hpp"
#include "models/boundaries/shapes/half_space.hpp"
#include "models/kinematics/plane_strain.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/hencky.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification::conservation_symmetry {

namespace {

constexpr double h = 0.125, density = 1000;
constexpr long steps = 150;

template <int D>
using Turn = Eigen::Matrix<double, D, D>;

/// The problem, turned by `turn` and with its particles in the order of `order`.
template <class Kinematics>
std::unique_ptr<Simulation<Kinematics::dimension>> begun(Scheme const& scheme, Turn<Kinematics::dimension> const& turn,
                                                         std::vector<Seed<Kinematics::dimension>> const& seeds,
                                                         std::vector<std::size_t> const& order) {
  constexpr int D = Kinematics::dimension;
  Scene<D> scene = scene_of<Kinematics, law::Hencky>(scheme, h, density, {1e5, 0.3});
  Point<D> g = Point<D>::Zero();
  g[1] = -10;
  scene.gravity = turn * g;
  Point<D> const up = turn * Point<D>::Unit(1);
  wall::HalfSpace::Parameters floor;
  floor.normal = D == 2 ? Coordinates{up[0], up[1]} : Coordinates{up[0], up[1], up[D - 1]};
  scene.walls.push_back(make_wall<D, wall::HalfSpace, wall::Coulomb, wall::Fixed>("floor", floor, {0.4}, {}));
  set_step(scene, 1e-3);
  std::vector<Seed<D>> placed;
  for (std::size_t const p : order) {
    Seed<D> seed = seeds[p];
    seed.x = turn * seed.x;
    seed.v = turn * seed.v;
    placed.push_back(seed);
  }
  return begin(std::move(scene), placed);
}

template <int D>
std::vector<Seed<D>> two_blocks() {
  std::vector<Seed<D>> seeds;
  for (double const side : {-1.0, 1.0}) {
    Point<D> low = Point<D>::Constant(0.04 * side), v = Point<D>::Constant(0.2 * side);
    low[0] = side < 0 ? -0.51 : 0.07;
    low[1] = 0.06 + 0.02 * side;
    v[0] = -2 * side + 0.5;
    std::array<int, D> cells, per_axis;
    cells.fill(3);
    per_axis.fill(2);
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

/// Positions and velocities, in the order of the seeds and turned back.
template <int D>
struct State {
  std::vector<Point<D>> x, v;
};

template <class Kinematics>
State<Kinematics::dimension> solved(Scheme const& scheme, Turn<Kinematics::dimension> const& turn,
                                    std::vector<std::size_t> const& order, Cost& cost) {
  constexpr int D = Kinematics::dimension;
  auto const simulation = begun<Kinematics>(scheme, turn, two_blocks<D>(), order);
  take_steps(*simulation, steps, cost);
  auto const x = vectors(*simulation, "position"), v = vectors(*simulation, "velocity");
  State<D> state{x, v};
  for (std::size_t p = 0; p < order.size(); ++p) {
    state.x[order[p]] = turn.transpose() * x[p];
    state.v[order[p]] = turn.transpose() * v[p];
  }
  return state;
}

/// Largest difference of velocities, of order 1 m/s, and of positions, of order 1 m.
template <int D>
double difference(State<D> const& a, State<D> const& b) {
  double worst = 0;
  for (std::size_t p = 0; p < a.x.size(); ++p)
    worst = std::max({worst, (a.x[p] - b.x[p]).norm(), (a.v[p] - b.v[p]).norm()});
  return worst;
}

template <class Kinematics>
void of(Findings& findings, Scheme const& scheme, std::string const& where) {
  constexpr int D = Kinematics::dimension;
  std::vector<std::size_t> order(two_blocks<D>().size());
  for (std::size_t p = 0; p < order.size(); ++p) order[p] = p;
  Turn<D> const same = Turn<D>::Identity();
  Turn<D> mirror = same, quarter = same;
  mirror(0, 0) = -1;
  quarter.template topLeftCorner<2, 2>() << 0, -1, 1, 0;
  Cost cost;
  auto const plain = solved<Kinematics>(scheme, same, order, cost);
  std::string const subject = scheme.name() + ", " + where, why = "a symmetry of the discrete problem";
  auto const compare = [&](std::string const& what, Turn<D> const& turn, std::vector<std::size_t> const& in_order) {
    Cost own;
    double const off = difference(plain, solved<Kinematics>(scheme, turn, in_order, own));
    findings.check(subject, what, off, at_most(1e-12), why + "; 150 steps of rounding", own);
  };
  compare("mirrored", mirror, order);
  compare("turned by 90 degrees", quarter, order);
  auto shuffled = order;
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(3));
  compare("particles in another order", same, shuffled);
}

/// Largest difference between runs on 1, 2 and 3 threads.
template <class Kinematics>
void on_threads(Findings& findings, Scheme const& scheme, std::string const& where) {
  constexpr int D = Kinematics::dimension;
  std::vector<std::size_t> order(two_blocks<D>().size());
  for (std::size_t p = 0; p < order.size(); ++p) order[p] = p;
  int const before = thread_count();
  std::vector<State<D>> states;
  Cost cost;
  for (int const threads : {1, 2, 3}) {
    set_thread_count(threads);
    states.push_back(solved<Kinematics>(scheme, Turn<D>::Identity(), order, cost));
  }
  set_thread_count(before);
  findings.check(scheme.name() + ", " + where, "1, 2 and 3 threads",
                 std::max(difference(states[0], states[1]), difference(states[0], states[2])), at_most(0),
                 "sums are taken in an order that threads have no part in", cost);
}

void run(Findings& findings) {
  for (std::string const integrator : {"usl", "musl"})
    for (Scheme const& scheme : all_schemes(integrator)) {
      of<kinematics::PlaneStrain>(findings, scheme, "2-D");
      if (scheme.degree() == 2 && integrator == "usl") of<kinematics::Solid>(findings, scheme, "3-D");
    }
  for (std::string const transfer : {"apic", "aflip"}) {
    on_threads<kinematics::PlaneStrain>(findings, {"quadratic", transfer}, "2-D");
    on_threads<kinematics::Solid>(findings, {"cubic", transfer, "musl"}, "3-D");
  }
}

}  // namespace

Case const the_case{"conservation/symmetry",
                    "Mirrored, turned, in another order, on more threads: the same solution",
                    "the solution itself",
                    "symmetry of the discrete problem",
                    0,
                    15,
                    run};

}  // namespace talus::verification::conservation_symmetry
