#include <Eigen/LU>
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "core/contact.hpp"
#include "models/catalogue.hpp"
#include "tests/support/random_geometry.hpp"

BOOST_AUTO_TEST_SUITE(boundaries)

using namespace talus;
using namespace talus::test;

namespace {

/// A law of nodes: the velocity that the walls leave, and the change that each causes.
template <int D>
using NodeLaw =
    std::function<Point<D>(std::vector<Touch<D>> const& touches, Point<D> const& v, std::vector<Point<D>>& changes)>;

template <int D>
Point<D> all_at_once(std::vector<Touch<D>> const& touches, Point<D> const& v, std::vector<Point<D>>& changes) {
  changes.resize(touches.size());
  return resolve<D>(touches, v, changes);
}
/// A law of one wall, applied wall by wall in the order of the list.
template <int D>
NodeLaw<D> one_by_one(Point<D> (*allowed)(Touch<D> const&, Point<D> const&)) {
  return [allowed](std::vector<Touch<D>> const& touches, Point<D> v, std::vector<Point<D>>& changes) {
    changes.clear();
    for (auto const& touch : touches) {
      Point<D> const next = allowed(touch, v);
      changes.push_back(next - v);
      v = next;
    }
    return v;
  };
}

template <int D>
struct Node {
  std::vector<Touch<D>> touches;
  Point<D> v;
  bool alike = true;  ///< the walls move alike

  [[nodiscard]] Node in_frame(Eigen::Matrix<double, D, D> const& Q, Point<D> const& shift) const {
    Node other = *this;
    other.v = Q * v + shift;
    for (auto& touch : other.touches) {
      touch.normal = Q * touch.normal;
      touch.wall_velocity = Q * touch.wall_velocity + shift;
    }
    return other;
  }
};

/// A node on `faces` faces whose normals are at least 25 degrees from the plane of the others.
template <int D>
Node<D> random_node(ContactRule rule, double friction, int faces, bool alike) {
  Eigen::Matrix<double, D, D> normals;
  do {
    for (int k = 0; k < D; ++k) normals.col(k) = random_direction<D>();
  } while (std::abs(normals.determinant()) < 0.4);
  if (!alike) normals = random_frame<D>();  // friction of oblique walls that move differently may jam
  Node<D> node{{}, random_point<D>(-1, 1), alike};
  Point<D> const w = random_point<D>(-1, 1);
  for (int k = 0; k < faces; ++k)
    node.touches.push_back({normals.col(k), alike ? w : random_point<D>(-1, 1), rule, friction, k});
  return node;
}

/// How far a law of nodes is, at worst, from what walls may do. Velocities are of order 1.
struct Defects {
  double sum = 0, penetration = 0, gain = 0, repetition = 0, frame = 0, order = 0, untouched = 0, pull = 0,
         friction = 0;
  [[nodiscard]] double worst() const {
    return std::max({sum, penetration, gain, repetition, frame, order, untouched, pull, friction});
  }
};

void raise(double& most, double value) {
  most = std::max(most, std::isnan(value) ? INFINITY : value);
}

template <int D>
bool same_bits(std::vector<Point<D>> const& a, std::vector<Point<D>> const& b) {
  for (std::size_t k = 0; k < a.size(); ++k)
    if (a[k] != b[k]) return false;
  return true;
}

/// Normals push only, and |T| <= mu |N| against the slip, equal to it where there is slip.
template <int D>
void judge_impulses(Node<D> const& node, Point<D> const& after, std::vector<Point<D>> const& changes, Defects& worst) {
  for (std::size_t k = 0; k < node.touches.size(); ++k) {
    auto const& touch = node.touches[k];
    if (touch.rule.sticks) continue;
    double const push = touch.normal.dot(changes[k]);
    Point<D> const drag = changes[k] - push * touch.normal;
    Point<D> v_t = after - touch.wall_velocity;
    v_t -= touch.normal.dot(v_t) * touch.normal;
    double const slip = v_t.norm(), limit = touch.friction * std::abs(push);
    if (touch.rule.separates) raise(worst.pull, -push);
    raise(worst.friction, drag.norm() - limit);
    if (slip > 1e-9) raise(worst.friction, (drag + limit / slip * v_t).norm());
  }
}

template <int D>
void judge(NodeLaw<D> const& law, Node<D> const& node, Defects& worst) {
  std::vector<Point<D>> changes, again;
  Point<D> const after = law(node.touches, node.v, changes);
  Point<D> sum = node.v;
  for (auto const& change : changes) sum += change;
  raise(worst.sum, (sum - after).norm());

  bool clear = true;
  for (auto const& touch : node.touches) {
    double const v_n = touch.normal.dot(after - touch.wall_velocity);
    if (!touch.rule.sticks || node.alike) raise(worst.penetration, touch.rule.separates ? -v_n : std::abs(v_n));
    clear = clear && !touch.rule.sticks && touch.rule.separates && touch.normal.dot(node.v - touch.wall_velocity) > 0;
  }
  if (clear) raise(worst.untouched, after == node.v ? 0 : 1);
  if (node.alike) {
    Point<D> const& w = node.touches[0].wall_velocity;
    raise(worst.gain, (after - w).squaredNorm() - (node.v - w).squaredNorm());
  }
  raise(worst.repetition, (law(node.touches, after, again) - after).norm());
  judge_impulses(node, after, changes, worst);

  auto const Q = random_frame<D>();
  Point<D> const shift = random_point<D>(-1, 1);
  auto const moved = node.in_frame(Q, shift);
  raise(worst.frame, (law(moved.touches, moved.v, again) - Q * after - shift).norm());

  std::vector<std::size_t> places(node.touches.size());
  for (std::size_t k = 0; k < places.size(); ++k) places[k] = k;
  while (std::next_permutation(places.begin(), places.end())) {
    std::vector<Touch<D>> listed;
    std::vector<Point<D>> expected;
    for (std::size_t k : places) listed.push_back(node.touches[k]), expected.push_back(changes[k]);
    bool const same = law(listed, node.v, again) == after && same_bits<D>(again, expected);
    raise(worst.order, same ? 0 : 1);
  }
}

/// All defects of a law with a rule at nodes on one face up to D, walls alike or not.
template <int D>
Defects defects(ContactRule rule, NodeLaw<D> const& law = all_at_once<D>) {
  generator.seed(20240917);
  Defects worst;
  for (int faces = 1; faces <= D; ++faces)
    for (bool const alike : {true, false})
      for (int sample = 0; sample < 400; ++sample) {
        bool const rubs = rule.material_friction || rule.friction > 0;
        judge(law, random_node<D>(rule, rubs ? between(0.05, alike ? 2.0 : 0.4) : 0, faces, alike), worst);
      }
  return worst;
}

// Wrong laws of one wall, to be refused.

/// Friction scales with the whole velocity, not with the slip.
template <int D>
Point<D> total_velocity(Touch<D> const& touch, Point<D> const& v) {
  Point<D> const v_r = v - touch.wall_velocity;
  double const v_n = touch.normal.dot(v_r);
  if (!(v_n < 0)) return v;
  Point<D> const v_t = v_r - v_n * touch.normal;
  return touch.wall_velocity + std::max(0.0, 1 + touch.friction * v_n / v_r.norm()) * v_t;
}
/// Sign of the friction.
template <int D>
Point<D> friction_pushes(Touch<D> const& touch, Point<D> const& v) {
  Point<D> const v_r = v - touch.wall_velocity;
  double const v_n = touch.normal.dot(v_r);
  if (!(v_n < 0)) return v;
  Point<D> const v_t = v_r - v_n * touch.normal;
  return touch.wall_velocity + (1 - touch.friction * v_n / v_t.norm()) * v_t;
}
/// Pulls what leaves, lets in what comes.
template <int D>
Point<D> normal_reversed(Touch<D> const& given, Point<D> const& v) {
  Touch<D> touch = given;
  touch.normal = -touch.normal;
  return allowed_by(touch, v);
}
/// Friction on a node that separates.
template <int D>
Point<D> rubs_what_leaves(Touch<D> const& touch, Point<D> const& v) {
  Point<D> const v_r = v - touch.wall_velocity;
  double const v_n = touch.normal.dot(v_r);
  Point<D> const v_t = v_r - v_n * touch.normal;
  double const kept = std::max(0.0, 1 - touch.friction * std::abs(v_n) / v_t.norm());
  return touch.wall_velocity + std::max(v_n, 0.0) * touch.normal + kept * v_t;
}
/// Each tangential component by itself.
template <int D>
Point<D> axis_by_axis(Touch<D> const& touch, Point<D> const& v) {
  Point<D> const v_r = v - touch.wall_velocity;
  double const v_n = touch.normal.dot(v_r);
  if (!(v_n < 0)) return v;
  Point<D> v_t = v_r - v_n * touch.normal;
  for (int i = 0; i < D; ++i) v_t[i] = std::copysign(std::max(0.0, std::abs(v_t[i]) + touch.friction * v_n), v_t[i]);
  return touch.wall_velocity + v_t;
}
/// Forgets that the wall moves.
template <int D>
Point<D> at_rest(Touch<D> const& given, Point<D> const& v) {
  Touch<D> touch = given;
  touch.wall_velocity.setZero();
  return allowed_by(touch, v);
}

/// Calls judge(defects) for every contact of the catalogue in 2 and 3 dimensions.
template <class F>
void for_each_contact(F judge) {
  for_each_type(catalogue::Contacts{}, [&]<class C>(std::type_identity<C>) {
    BOOST_TEST_CONTEXT(C::name << " in 2 dimensions") {
      judge(defects<2>(C::rule({})));
    }
    BOOST_TEST_CONTEXT(C::name << " in 3 dimensions") {
      judge(defects<3>(C::rule({})));
    }
  });
}

// 100 times the round-off of numbers of order 1: corners of 25 degrees amplify it, tens of operations add it up.
constexpr double small = 100 * std::numeric_limits<double>::epsilon();

}  // namespace

BOOST_AUTO_TEST_CASE(changes_of_velocity_add_up) {
  for_each_contact([](Defects const& worst) { BOOST_TEST(worst.sum <= small); });
}

BOOST_AUTO_TEST_CASE(no_wall_is_penetrated) {
  for_each_contact([](Defects const& worst) { BOOST_TEST(worst.penetration <= small); });
}

BOOST_AUTO_TEST_CASE(kinetic_energy_never_grows_as_seen_from_the_walls) {
  for_each_contact([](Defects const& worst) { BOOST_TEST(worst.gain <= small); });
}

BOOST_AUTO_TEST_CASE(applied_twice_is_applied_once) {
  for_each_contact([](Defects const& worst) { BOOST_TEST(worst.repetition <= small); });
}

BOOST_AUTO_TEST_CASE(an_observer_who_moves_or_turns_sees_the_same) {
  for_each_contact([](Defects const& worst) { BOOST_TEST(worst.frame <= small); });
}

BOOST_AUTO_TEST_CASE(order_of_the_walls_plays_no_part_to_the_last_bit) {
  for_each_contact([](Defects const& worst) { BOOST_TEST(worst.order == 0); });
}

BOOST_AUTO_TEST_CASE(what_leaves_a_separating_wall_is_left_alone_to_the_last_bit) {
  for_each_contact([](Defects const& worst) { BOOST_TEST(worst.untouched == 0); });
}

BOOST_AUTO_TEST_CASE(separating_walls_never_pull) {
  for_each_contact([](Defects const& worst) { BOOST_TEST(worst.pull <= small); });
}

BOOST_AUTO_TEST_CASE(friction_is_mu_times_the_push_against_the_slip_and_no_more_where_it_holds) {
  for_each_contact([](Defects const& worst) { BOOST_TEST(worst.friction <= small); });
}

BOOST_AUTO_TEST_CASE(planted_defects_are_seen) {
  ContactRule const coulomb{.friction = 0.5};
  BOOST_TEST(defects<2>(coulomb, one_by_one<2>(total_velocity)).friction > 0.1);
  BOOST_TEST(defects<2>(coulomb, one_by_one<2>(friction_pushes)).gain > 0.1);
  BOOST_TEST(defects<2>(coulomb, one_by_one<2>(normal_reversed)).penetration > 0.1);
  BOOST_TEST(defects<2>(coulomb, one_by_one<2>(normal_reversed)).pull > 0.1);
  BOOST_TEST(defects<2>(coulomb, one_by_one<2>(rubs_what_leaves)).untouched == 1);
  BOOST_TEST(defects<2>(coulomb, one_by_one<2>(rubs_what_leaves)).friction > 0.1);
  BOOST_TEST(defects<3>(coulomb, one_by_one<3>(axis_by_axis)).frame > 0.1);
  BOOST_TEST(defects<2>(coulomb, one_by_one<2>(at_rest)).frame > 0.1);
  BOOST_TEST(defects<2>({.sticks = true}, one_by_one<2>(at_rest)).frame > 0.1);
  // the right law wall by wall: what the second wall does, the first has not seen
  BOOST_TEST(defects<2>(coulomb, one_by_one<2>(allowed_by)).order == 1);
  BOOST_TEST(defects<2>(coulomb, one_by_one<2>(allowed_by)).penetration > 0.1);
  BOOST_TEST(defects<2>(coulomb).worst() <= small);
}

BOOST_AUTO_TEST_SUITE_END()
