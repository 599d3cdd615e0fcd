#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/errors.hpp"
#include "core/wall.hpp"
#include "tests/support/random_geometry.hpp"

BOOST_AUTO_TEST_SUITE(wall)

using namespace talus;
using namespace talus::test;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr ContactRule sticks{.sticks = true}, slips{.separates = false}, separates{};

template <int D>
Touch<D> touch(ContactRule rule, Point<D> const& normal, Point<D> const& wall_velocity = Point<D>::Zero()) {
  return {normal, wall_velocity, rule, rule.friction, 0};
}
template <int D>
Touch<D> rough(double friction, Point<D> const& normal, Point<D> const& wall_velocity = Point<D>::Zero()) {
  return touch<D>({.friction = friction}, normal, wall_velocity);
}

template <int D>
struct Resolved {
  Point<D> v;
  std::vector<Point<D>> changes;
  Resolved(std::vector<Touch<D>> const& touches, Point<D> const& before) : changes(touches.size()) {
    v = resolve<D>(touches, before, changes);
  }
};

using P2 = Point<2>;
using P3 = Point<3>;

double distance(auto const& a, auto const& b) {
  return (a - b).norm();
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_node_without_walls_is_left_alone) {
  BOOST_TEST((Resolved<2>({}, {1, 2}).v == P2(1, 2)));
}

BOOST_AUTO_TEST_CASE(what_sticks_takes_the_velocity_of_the_wall) {
  for (P2 const& v : {P2(3, -1), P2(3, 1)}) {
    Resolved<2> const result({touch<2>(sticks, {0, 1}, {0.1, 0.2})}, v);
    BOOST_TEST((result.v == P2(0.1, 0.2)));
    BOOST_TEST((result.changes[0] == result.v - v));
  }
}

BOOST_AUTO_TEST_CASE(free_slip_keeps_the_tangential_velocity_to_the_last_bit) {
  for (double const v_n : {-1.0, 1.0})
    for (double const sign : {-1.0, 1.0})  // of the normal: plays no part
      BOOST_TEST((Resolved<2>({touch<2>(slips, {0, sign})}, {1.0 / 3, v_n}).v == P2(1.0 / 3, 0)));
  BOOST_TEST((Resolved<2>({touch<2>(separates, {0, 1})}, {1.0 / 3, -1}).v == P2(1.0 / 3, 0)));
}

BOOST_AUTO_TEST_CASE(what_separates_is_left_alone_whatever_the_friction) {
  P2 const v(1.0 / 3, 1e-300);
  Resolved<2> const result({rough<2>(1e6, {0, 1})}, v);
  BOOST_TEST((result.v == v));
  BOOST_TEST((result.changes[0] == P2(0, 0)));
}

BOOST_AUTO_TEST_CASE(without_a_push_there_is_no_friction) {
  BOOST_TEST((Resolved<2>({rough<2>(1e6, {0, 1})}, {1, 0}).v == P2(1, 0)));
  BOOST_TEST((Resolved<2>({rough<2>(1e6, {0, 1}, {0, 1}), rough<2>(1e6, {1, 0})}, {1, 1}).v == P2(1, 1)));
}

BOOST_AUTO_TEST_CASE(friction_takes_mu_times_the_push_from_the_slip_and_keeps_its_direction) {
  BOOST_TEST((Resolved<2>({rough<2>(0.5, {0, 1})}, {3, -1}).v == P2(2.5, 0)));
  BOOST_TEST((Resolved<2>({rough<2>(0.5, {0, 1})}, {-3, -1}).v == P2(-2.5, 0)));
  BOOST_TEST(distance(Resolved<3>({rough<3>(0.5, {0, 0, 1})}, {3, 4, -2}).v, P3(2.4, 3.2, 0)) <= 4 * eps);  // 5 to 4
}

BOOST_AUTO_TEST_CASE(friction_that_suffices_stops_the_slip_exactly) {
  P2 const w(0.1, 0.3);
  for (double const mu : {3.0, 1e6, 1e300}) BOOST_TEST((Resolved<2>({rough<2>(mu, {0, 1}, w)}, w + P2(2, -1)).v == w));
}

BOOST_AUTO_TEST_CASE(friction_of_the_material_is_what_the_node_brings) {
  Touch<2> given = touch<2>({.material_friction = true, .friction = 7}, {0, 1});
  given.friction = 0.25;
  BOOST_TEST((Resolved<2>({given}, {1, -1}).v == P2(0.75, 0)));
}

BOOST_AUTO_TEST_CASE(a_node_on_a_slope_slides_with_g_sin_minus_mu_cos_or_rests) {
  // v_k = k dt g (sin theta - mu cos theta): the law is exact in each step, so round-off alone adds up
  double const mu = std::tan(15 * std::numbers::pi / 180), g = 9.81, dt = 1e-3;
  int const steps = 1000;
  for (int degrees = 14; degrees <= 30; degrees += 2) {
    double const theta = degrees * std::numbers::pi / 180;
    P2 const normal(std::sin(theta), std::cos(theta)), down(std::cos(theta), -std::sin(theta));  // not along the grid
    P2 v(0, 0);
    for (int k = 0; k < steps; ++k) v = Resolved<2>({rough<2>(mu, normal)}, v + dt * P2(0, -g)).v;
    double const expected = std::max(0.0, steps * dt * g * (std::sin(theta) - mu * std::cos(theta)));
    BOOST_TEST_CONTEXT(degrees << " degrees") {
      BOOST_TEST(distance(v, expected * down) <= steps * 4 * eps);
      BOOST_TEST(((degrees < 15) == (v == P2(0, 0))));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_corner_of_two_walls_stops_what_runs_into_it) {
  std::vector<Touch<2>> const corner{touch<2>(separates, {1, 0}), touch<2>(separates, {0, 1})};
  Resolved<2> const both(corner, {-1, -2});
  BOOST_TEST((both.v == P2(0, 0)));
  BOOST_TEST((both.changes[0] == P2(1, 0)));
  BOOST_TEST((both.changes[1] == P2(0, 2)));
  BOOST_TEST((Resolved<2>(corner, {1, -2}).v == P2(1, 0)));
  BOOST_TEST((Resolved<2>(corner, {1, 2}).v == P2(1, 2)));
}

BOOST_AUTO_TEST_CASE(in_an_acute_corner_sliding_along_one_wall_never_enters_the_other) {
  // two walls at 60 degrees; wall after wall in either order leaves one of them penetrated
  double const half = std::numbers::pi / 6;
  P2 const left(std::cos(half), std::sin(half)), right(-std::cos(half), std::sin(half));
  Resolved<2> const result({touch<2>(separates, left), touch<2>(separates, right)}, {0.3, -1});
  BOOST_TEST(result.v.norm() <= 16 * eps);
}

BOOST_AUTO_TEST_CASE(one_wall_that_sticks_decides) {
  Resolved<2> const result({touch<2>(separates, {1, 0}, {5, 0}), touch<2>(sticks, {0, 1}, {0.1, 0})}, {-1, -2});
  BOOST_TEST((result.v == P2(0.1, 0)));
  BOOST_TEST((result.changes[0] == P2(0, 0)));
  BOOST_TEST((result.changes[1] == P2(1.1, 2)));
}

BOOST_AUTO_TEST_CASE(walls_that_stick_and_move_differently_leave_the_mean_of_their_velocities) {
  Resolved<2> const result({touch<2>(sticks, {1, 0}, {1, 0}), touch<2>(sticks, {0, 1}, {0, 3})}, {-1, -1});
  BOOST_TEST((result.v == P2(0.5, 1.5)));
  BOOST_TEST((result.changes[0] == P2(1, 0.5)));
  BOOST_TEST((result.changes[1] == P2(0.5, 2)));
}

BOOST_AUTO_TEST_CASE(a_wall_listed_twice_acts_once_and_shares_alike) {
  for (auto const& one :
       {touch<2>(separates, {0.6, 0.8}), rough<2>(0.5, {0.6, 0.8}, {0.1, 0}), touch<2>(sticks, {0, 1})}) {
    Resolved<2> const once({one}, {1, -2}), twice({one, one}, {1, -2});
    BOOST_TEST(distance(once.v, twice.v) <= 4 * eps);
    BOOST_TEST((twice.changes[0] == twice.changes[1]));
    BOOST_TEST(distance(2 * twice.changes[0], once.changes[0]) <= 8 * eps);
  }
}

BOOST_AUTO_TEST_CASE(along_the_edge_of_two_rough_walls_their_friction_adds) {
  // pushes 1 and 2, friction 0.1 * 1 + 0.2 * 2 = 0.5 of a slip of 3
  std::vector<Touch<3>> const edge{rough<3>(0.1, {1, 0, 0}), rough<3>(0.2, {0, 1, 0})};
  Resolved<3> const slides(edge, {-1, -2, 3});
  BOOST_TEST(distance(slides.v, P3(0, 0, 2.5)) <= 8 * eps);
  BOOST_TEST(distance(slides.changes[0], P3(1, 0, -0.1)) <= 8 * eps);
  BOOST_TEST(distance(slides.changes[1], P3(0, 2, -0.4)) <= 8 * eps);
  // a slip of 0.25 is stopped; the walls share it by what each can do
  Resolved<3> const rests(edge, {-1, -2, 0.25});
  BOOST_TEST((rests.v == P3(0, 0, 0)));
  BOOST_TEST(distance(rests.changes[0], P3(1, 0, -0.05)) <= 8 * eps);
  BOOST_TEST(distance(rests.changes[1], P3(0, 2, -0.2)) <= 8 * eps);
}

BOOST_AUTO_TEST_CASE(a_rising_gate_takes_weight_off_the_floor_however_slow_it_is) {
  // gate n = (1, 0) rising with u, node at (-a, -b): N_gate = a, T = mu a, N_floor = b - mu a; it lifts where mu a > b
  double const a = 1, b = 0.5;
  for (double const u : {1e-6, 1e-3, 1.0})
    for (double const mu : {0.1, 0.3, 0.9}) {
      Resolved<2> const result({rough<2>(mu, {1, 0}, {0, u}), rough<2>(0.2, {0, 1})}, {-a, -b});
      double const lift = std::clamp(mu * a - b, 0.0, u);
      BOOST_TEST_CONTEXT("u = " << u << ", mu = " << mu) {
        BOOST_TEST(distance(result.v, P2(0, lift)) <= 8 * eps);
        BOOST_TEST(distance(result.changes[0], P2(a, std::min(mu * a, b + u))) <= 8 * eps);
        BOOST_TEST(distance(result.changes[1], P2(0, std::max(b - mu * a, 0.0))) <= 8 * eps);
      }
    }
}

BOOST_AUTO_TEST_CASE(a_piston_carries_the_friction_of_the_floor) {
  // N_floor = b, against the slip u: -mu b; the piston gives u + a and mu b
  double const a = 0.5, b = 2, mu = 0.25, u = 1;
  Resolved<2> const result({touch<2>(separates, {1, 0}, {u, 0}), rough<2>(mu, {0, 1})}, {-a, -b});
  BOOST_TEST(distance(result.v, P2(u, 0)) <= 8 * eps);
  BOOST_TEST(distance(result.changes[0], P2(u + a + mu * b, 0)) <= 8 * eps);
  BOOST_TEST(distance(result.changes[1], P2(-mu * b, b)) <= 8 * eps);
}

BOOST_AUTO_TEST_CASE(walls_that_jam_leave_the_velocity_of_their_corner) {
  // each drags the node into the other: N_1 = a + mu N_2, N_2 = b + mu N_1, without bound at mu >= 1
  for (double const mu : {1.0, 2.0, 1e6}) {
    Resolved<2> const result({rough<2>(mu, {1, 0}, {0, -1}), rough<2>(mu, {0, 1}, {-1, 0})}, {-0.5, -0.25});
    BOOST_TEST(distance(result.v, P2(0, 0)) <= 8 * eps);
    BOOST_TEST(distance(result.changes[0] + result.changes[1], P2(0.5, 0.25)) <= 8 * eps);
  }
}

BOOST_AUTO_TEST_CASE(walls_that_close_on_each_other_leave_a_finite_velocity_between_theirs) {
  for (double const tilt : {0.0, 1e-15, 1e-9, 1e-4})
    for (double const mu : {0.0, 0.5}) {
      P2 const n = P2(-1, tilt).normalized();
      Resolved<2> const result({rough<2>(mu, {1, 0}, {1, 0}), rough<2>(mu, n, {-1, 0}), rough<2>(mu, {0, 1})},
                               {0.2, -1});
      BOOST_TEST(result.v.norm() <= 1);
      for (auto const& change : result.changes) BOOST_TEST(change.norm() <= 100);
      BOOST_TEST(distance(result.changes[0] + result.changes[1] + result.changes[2], result.v - P2(0.2, -1)) <= 1e-13);
    }
}

BOOST_AUTO_TEST_CASE(a_wall_as_fast_as_sound_only_shifts_the_velocities) {
  P2 const w(3000, -1000);
  Resolved<2> const slow({rough<2>(0.3, {0, 1})}, {2, -1}), fast({rough<2>(0.3, {0, 1}, w)}, w + P2(2, -1));
  BOOST_TEST(distance(fast.v - w, slow.v) <= 8 * eps * 3000);
}

BOOST_AUTO_TEST_CASE(a_velocity_that_is_no_number_is_not_hidden) {
  double const nan = std::numeric_limits<double>::quiet_NaN();
  for (auto const& rule : {slips, separates, ContactRule{.friction = 0.5}}) {
    BOOST_TEST(std::isnan(Resolved<2>({touch<2>(rule, {0, 1})}, {0, nan}).v[1]));
    BOOST_TEST(std::isnan(Resolved<2>({touch<2>(rule, {0, 1}), touch<2>(rule, {1, 0})}, {0, nan}).v[1]));
  }
}

BOOST_AUTO_TEST_CASE(sixteen_faces_are_resolved_and_more_are_refused) {
  generator.seed(7);
  std::vector<Touch<3>> dome;  // all open upwards: v_z large enough meets them all
  while (dome.size() < most_touches) {
    P3 const n = random_direction<3>();
    if (n[2] > 0.3) dome.push_back(touch<3>(separates, n));
  }
  Resolved<3> const result(dome, {0.1, 0.2, -1});
  for (auto const& face : dome) BOOST_TEST(face.normal.dot(result.v) >= -16 * eps);
  dome.push_back(dome[0]);
  BOOST_CHECK_THROW(Resolved<3>(dome, P3(0, 0, -1)), RunError);
}

BOOST_AUTO_TEST_SUITE_END()
