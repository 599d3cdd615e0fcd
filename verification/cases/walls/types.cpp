/// What kinds of wall do to a block, and the law of a node at a wall with Coulomb friction.
///
///   slip         takes v_n and leaves the momentum along the wall
///   stick        takes all velocity
///   separating   pushes and never pulls: what leaves is as if there were no wall, bit by bit
///   Coulomb      v' = w + max(0, 1 - mu |v_n|/|v_t|) v_t where v_n < 0, v_r = v - w = v_n n + v_t      (1)
///
/// (1), applied to its own result, changes nothing; it holds in any frame that moves and turns; with several walls at a
/// node the order in which they are listed plays no part, and |T| <= mu N at each of them.
///
/// Source: Coulomb's law; derived here.

#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "core/contact.hpp"
#include "models/boundaries/contacts/coulomb.hpp"
#include "models/boundaries/contacts/mirrored_slip.hpp"
#include "models/boundaries/contacts/mirrored_stick.hpp"
#include "models/boundaries/contacts/separating.hpp"
#include "models/boundaries/contacts/slip.hpp"
#include "models/boundaries/contacts/stick.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/boundaries/motions/fixed.hpp"
#include "models/boundaries/shapes/half_space.hpp"
#include "models/kinematics/plane_strain.hpp"
#include "models/laws/hencky.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification::walls_types {

namespace {

constexpr double h = 0.1, density = 1000;
constexpr int nodes = 10000;

/// A block of four by four cells on a wall that leans, without gravity. Its velocities are `v` and, along n, a stretch.
struct Block {
  Scheme scheme = {};
  double lean = 0;
  Point<2> v = Point<2>::Zero();
  double stretch = 0;  ///< [1/s]
  double base = 0;     ///< height of the wall [m]

  [[nodiscard]] Point<2> along() const { return {std::cos(lean), -std::sin(lean)}; }
  [[nodiscard]] Point<2> normal() const { return {std::sin(lean), std::cos(lean)}; }

  [[nodiscard]] std::unique_ptr<Simulation<2>> begin_at(std::unique_ptr<Wall<2>> wall) const {
    Scene<2> scene = scene_of<kinematics::PlaneStrain, law::Hencky>(scheme, h, density, {1e5, 0.3});
    if (wall) scene.walls.push_back(std::move(wall));
    set_step(scene, 1e-3);
    std::vector<Seed<2>> seeds;
    for (Point<2> const& x : lattice<2>({0, 0}, {4, 4}, {2, 2}, h))
      seeds.push_back(
          {x[0] * along() + x[1] * normal() + Point<2>(0, base), v + stretch * x[1] * normal(), density * h * h / 4});
    return begin(std::move(scene), seeds);
  }
  template <class Contact>
  [[nodiscard]] std::unique_ptr<Wall<2>> wall(typename Contact::Parameters const& contact = {}) const {
    return make_wall<2, wall::HalfSpace, Contact, wall::Fixed>("plane", {{0, base}, {normal()[0], normal()[1]}},
                                                               contact, {});
  }
  [[nodiscard]] double mass() const { return density * 16 * h * h; }
};

Point<2> momentum(Simulation<2> const& simulation) {
  Point<2> sum = Point<2>::Zero();
  for (auto const& v : vectors(simulation, "velocity")) sum += density * h * h / 4 * v;
  return sum;
}

void block_that_hits(Findings& findings, Block block, std::string const& subject) {
  block.v = 0.7 * block.along() - 0.5 * block.normal();
  Cost cost;
  auto slips = block.begin_at(block.wall<wall::Slip>());
  double along_step = 0;
  take_steps(*slips, 300, cost,
             [&] { along_step = std::max(along_step, std::abs(slips->momentum().walls[0].dot(block.along()))); });
  double const given = block.mass() * 0.7;
  findings.check(subject + ", slip", "|change of momentum along the wall|",
                 std::abs(momentum(*slips).dot(block.along()) / given - 1), at_most(1e-12), "exact; rounding", cost);
  findings.check(subject + ", slip", "|impulse along the wall| over the momentum", along_step / given, at_most(1e-13),
                 "exact; rounding");
  auto sticks = block.begin_at(block.wall<wall::Stick>());
  Cost of_stick;
  take_steps(*sticks, 300, of_stick);
  Point<2> const left = momentum(*sticks) - block.mass() * block.v - sticks->momentum().walls[0];
  findings.check(subject + ", stick", "|momentum - impulses| over the momentum", left.norm() / given, at_most(1e-12),
                 "exact; rounding", of_stick);
  findings.check(subject + ", stick", "impulse against the way along the wall over the momentum",
                 -sticks->momentum().walls[0].dot(block.along()) / given, at_least(0.5),
                 "the block is caught and goes round its base");
}

/// It leaves faster at the top: all of it is in tension until the waves come back, which is after the run's 30 ms.
void block_that_leaves(Findings& findings, Block block, std::string const& subject) {
  block.v = 0.3 * block.along() + 0.5 * block.normal();
  block.stretch = 0.5;
  auto const differing = [&](std::unique_ptr<Wall<2>> wall, Cost& cost) {
    auto const with = block.begin_at(std::move(wall)), without = block.begin_at(nullptr);
    take_steps(*with, 30, cost);
    take_steps(*without, 30, cost);
    double count = with->momentum().walls[0].norm() == 0 ? 0 : 1;
    for (std::string_view const field : {"position", "velocity", "elastic_strain"})
      for (int c = 0; c < 2; ++c) {
        auto const a = column(*with, field, c), b = column(*without, field, c);
        for (std::size_t p = 0; p < a.size(); ++p) count += a[p] == b[p] ? 0 : 1;
      }
    return count;
  };
  Cost separating, coulomb, slip;
  findings.check(subject + ", separating", "numbers that differ from a run without the wall",
                 differing(block.wall<wall::Separating>(), separating), at_most(0), "no tension: bit by bit",
                 separating);
  findings.check(subject + ", Coulomb", "numbers that differ from a run without the wall",
                 differing(block.wall<wall::Coulomb>({0.5}), coulomb), at_most(0), "no tension: bit by bit", coulomb);
  findings.check(subject + ", slip", "numbers that differ from a run without the wall",
                 differing(block.wall<wall::Slip>(), slip), at_least(1), "it holds what it touches", slip);
}

/// A wall at whatever row of nodes holds alike, although the places of most rows are not exact in binary numbers.
template <class Contact>
void rows_of_nodes(Findings& findings, std::string const& subject) {
  Point<2> first = Point<2>::Zero();
  double worst = 0;
  Cost cost;
  for (int row = 0; row <= 60; ++row) {
    Block block{.v = {0.3, 0.5}, .base = row / 10.0};
    auto const simulation = block.begin_at(block.wall<Contact>());
    take_steps(*simulation, 10, cost);
    Point<2> const impulse = simulation->momentum().walls[0];
    if (row == 0) first = impulse;
    worst = std::max(worst, (impulse - first).norm() / first.norm());
  }
  findings.check(subject + " that is pulled at, on rows 0 to 60", "largest difference of its impulse", worst,
                 at_most(1e-9), "the same scene, moved by whole cells", cost);
}

/// The lowest nodes that the block sends mass to lie 0.04 h before the wall: they are stopped in the step in which they
/// would end behind it, and not where they end before it.
void block_that_comes(Findings& findings) {
  auto const impulse = [](double way, Cost& cost) {
    Block const block{.v = Point<2>(0, -way * h / 1e-3)};
    wall::HalfSpace::Parameters plane;
    plane.point = {0, -1.04 * h};
    plane.normal = {0, 1};
    auto const wall_at = [&] {
      return make_wall<2, wall::HalfSpace, wall::Separating, wall::Fixed>("plane", plane, {}, {});
    };
    auto const simulation = block.begin_at(wall_at());
    take_steps(*simulation, 1, cost);
    return simulation->momentum().walls[0][1] / (block.mass() * block.v.norm());
  };
  Cost before, behind;
  findings.check("a node that ends 0.01 h before the wall", "impulse over the momentum", impulse(0.03, before),
                 at_most(0), "it does not touch", before);
  findings.check("a node that would end 0.01 h behind the wall", "impulse over the momentum", impulse(0.05, behind),
                 at_least(1e-4), "walls are looked for where a node goes", behind);
}

/// Random touches and velocities.
template <int D>
struct Chance {
  std::mt19937_64 generator{D};

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator); }
  Point<D> vector() {
    Point<D> x;
    for (int d = 0; d < D; ++d) x[d] = between(-1, 1);
    return x;
  }
  /// Normals that do not face each other.
  Touch<D> touch(double friction) {
    Point<D> n = vector();
    n[D - 1] += 2;
    return {n.normalized(), 0.3 * vector(), {.friction = friction}, friction, 0};
  }
  /// Orthogonal: rotations in the planes of all pairs of axes, and half of the times a reflection.
  Eigen::Matrix<double, D, D> frame() {
    Eigen::Matrix<double, D, D> Q = Eigen::Matrix<double, D, D>::Identity();
    for (int d = 0; d < D; ++d)
      for (int e = d + 1; e < D; ++e) {
        double const angle = between(-std::numbers::pi, std::numbers::pi);
        Point<D> const a = Q.col(d), b = Q.col(e);
        Q.col(d) = std::cos(angle) * a + std::sin(angle) * b;
        Q.col(e) = std::cos(angle) * b - std::sin(angle) * a;
      }
    if (between(-1, 1) < 0) Q.col(0) *= -1;
    return Q;
  }
};

/// (1), written down once more.
template <int D>
Point<D> coulomb(Touch<D> const& touch, Point<D> const& v) {
  Point<D> const v_r = v - touch.wall_velocity;
  double const v_n = v_r.dot(touch.normal);
  if (v_n >= 0) return v;
  Point<D> const v_t = v_r - v_n * touch.normal;
  return touch.wall_velocity + std::max(0.0, 1 - touch.friction * -v_n / v_t.norm()) * v_t;
}

/// Largest defects over random nodes at `walls` walls.
struct Defects {
  double law = 0, repeated = 0, frame = 0, order = 0, entered = 0, excess = 0, touched = 0;
};
template <int D>
void add(Defects& worst, std::vector<Touch<D>> const& touches, Point<D> const& v, Chance<D>& chance) {
  std::size_t const count = touches.size();
  std::vector<Point<D>> changes(count), again(count);
  auto const law = [&](std::vector<Touch<D>> const& these, Point<D> const& u, std::vector<Point<D>>& out) {
    return resolve<D>(std::span<Touch<D> const>(these), u, std::span<Point<D>>(out));
  };
  Point<D> const result = law(touches, v, changes);
  auto const raise = [](double& most, double value) { most = std::max(most, value); };
  if (count == 1) raise(worst.law, (result - coulomb<D>(touches[0], v)).norm());
  raise(worst.repeated, (law(touches, result, again) - result).norm());
  auto turned = touches, reversed = touches;
  Eigen::Matrix<double, D, D> const Q = chance.frame();
  Point<D> const w = chance.vector();
  bool leaves = true;
  for (std::size_t k = 0; k < count; ++k) {
    Touch<D> const& touch = touches[k];
    turned[k].normal = Q * touch.normal;
    turned[k].wall_velocity = Q * touch.wall_velocity + w;
    reversed[count - 1 - k] = touch;
    double const N = changes[k].dot(touch.normal), v_n = touch.normal.dot(result - touch.wall_velocity);
    raise(worst.entered, -v_n);
    raise(worst.excess, (changes[k] - N * touch.normal).norm() - touch.friction * N);
    leaves = leaves && touch.normal.dot(v - touch.wall_velocity) >= 0;
  }
  raise(worst.frame, (law(turned, Q * v + w, again) - (Q * result + w)).norm());
  raise(worst.order, law(reversed, v, again) == result ? 0 : 1);
  if (leaves) raise(worst.touched, result == v ? 0 : 1);
}

template <int D>
void node_law(Findings& findings, int walls) {
  Chance<D> chance;
  Defects worst;
  for (int k = 0; k < nodes; ++k) {
    std::vector<Touch<D>> touches;
    for (int w = 0; w < walls; ++w) touches.push_back(chance.touch(chance.between(0, 0.3)));
    add<D>(worst, touches, chance.vector(), chance);
  }
  std::string const subject =
      std::to_string(D) + "-D, " + std::to_string(walls) + (walls == 1 ? " wall" : " walls") + ", random nodes";
  auto const row = [&](char const* measure, double found) {
    findings.check(subject, measure, found, at_most(1e-13), "exact; rounding of velocities of 1 m/s").unit = "m/s";
  };
  if (walls == 1) row("largest difference from Coulomb's law", worst.law);
  row("largest change when applied twice", worst.repeated);
  row("largest change by the frame", worst.frame);
  row("largest velocity into a wall", worst.entered);
  row("largest |T| - mu N", worst.excess);
  findings.check(subject, "whether the order of the walls counts", worst.order, at_most(0), "bit by bit");
  findings.check(subject, "whether a node that leaves is touched", worst.touched, at_most(0), "bit by bit");
}

void run(Findings& findings) {
  for (Scheme const& scheme : {Scheme{"quadratic", "apic"}, Scheme{"quadratic", "flip"}, Scheme{"cubic", "aflip"}})
    for (double const degrees : {0.0, 35.0}) {
      Block const block{.scheme = scheme, .lean = degrees * std::numbers::pi / 180};
      std::string const subject = scheme.name() + ", leaning " + std::to_string(int(degrees)) + " deg";
      block_that_hits(findings, block, subject);
      block_that_leaves(findings, block, subject);
    }
  block_that_comes(findings);
  rows_of_nodes<wall::Stick>(findings, "stick");
  rows_of_nodes<wall::Slip>(findings, "slip");
  rows_of_nodes<wall::MirroredStick>(findings, "mirrored stick");
  rows_of_nodes<wall::MirroredSlip>(findings, "mirrored slip");
  for (int const walls : {1, 2, 3}) {
    node_law<2>(findings, walls);
    node_law<3>(findings, walls);
  }
}

}  // namespace

Case const the_case{"walls/types",
                    "Walls that slip, stick, separate and rub",
                    "conservation of momentum, and the law of a node",
                    "derived in the case's file",
                    0,
                    20,
                    run};

}  // namespace talus::verification::walls_types
