#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/half_spaces.hpp"
#include "tests/support/random_geometry.hpp"

BOOST_AUTO_TEST_SUITE(half_spaces)

using namespace talus;
using namespace talus::test;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

template <int D>
struct Projected {
  Point<D> x;
  std::vector<double> pushes;
  Projected(std::vector<Constraint<D>> const& constraints, Point<D> const& from) : pushes(constraints.size(), -1) {
    x = project<D>(constraints, from, pushes);
  }
};

/// The same by another way: ascent of the multipliers, one after the other, over and over.
/// Source: Hildreth (1957), Naval Research Logistics Quarterly 4, 79-85 (from memory).
template <int D>
Point<D> by_ascent(std::vector<Constraint<D>> const& constraints, Point<D> x) {
  std::vector<double> multipliers(constraints.size(), 0);
  for (int sweep = 0; sweep < 20000; ++sweep)
    for (std::size_t k = 0; k < constraints.size(); ++k) {
      double step = constraints[k].lacking(x);
      if (!constraints[k].is_plane) step = std::max(step, -multipliers[k]);
      multipliers[k] += step;
      x += step * constraints[k].normal;
    }
  return x;
}

/// The difference of the two, relative to the numbers at hand, over random sets of `count` half-spaces.
template <int D>
double worst_difference(int count, bool with_plane) {
  generator.seed(static_cast<unsigned>(count));
  double worst = 0;
  for (int sample = 0; sample < 60; ++sample) {
    std::vector<Constraint<D>> constraints;
    Point<D> const inside = random_point<D>(-1, 1);  // so that there is a point that meets them all
    for (int k = 0; k < count; ++k) {
      Point<D> const n = random_direction<D>();
      bool const is_plane = with_plane && k == 0;
      constraints.push_back({n, n.dot(inside) - (is_plane ? 0 : between(0, 0.5)), is_plane});
    }
    Point<D> const from = 3 * random_point<D>(-1, 1);
    worst = std::max(worst, (Projected<D>(constraints, from).x - by_ascent<D>(constraints, from)).norm());
  }
  return worst;
}

Point<2> direction(double degrees) {
  double const radians = degrees * std::numbers::pi / 180;
  return {std::cos(radians), std::sin(radians)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_point_that_meets_all_constraints_comes_back_bit_by_bit) {
  Point<2> const x(0.1, 1e-300);
  Projected<2> const result({{{0, 1}, 0}, {{1, 0}, 0}}, x);
  BOOST_TEST((result.x == x));
  BOOST_TEST((result.pushes == std::vector<double>{0, 0}));
}

BOOST_AUTO_TEST_CASE(one_half_space_pushes_along_its_normal) {
  Projected<2> const result({{{0.6, 0.8}, 1}}, {3, -4});  // n.x = -1.4
  BOOST_TEST((result.x - Point<2>(3 + 2.4 * 0.6, -4 + 2.4 * 0.8)).norm() <= 8 * eps);
  BOOST_TEST(result.pushes[0] == 2.4, boost::test_tools::tolerance(4 * eps));
}

BOOST_AUTO_TEST_CASE(a_plane_pulls_and_a_half_space_does_not) {
  BOOST_TEST((Projected<2>({{{0, 1}, 0, true}}, {3, 4}).x == Point<2>(3, 0)));
  BOOST_TEST((Projected<2>({{{0, 1}, 0, false}}, {3, 4}).x == Point<2>(3, 4)));
}

BOOST_AUTO_TEST_CASE(in_a_right_corner_each_half_space_pushes_for_itself) {
  Projected<3> const result({{{1, 0, 0}, 0}, {{0, 1, 0}, 0}, {{0, 0, -1}, 0}}, {-1, -2, 3});
  BOOST_TEST((result.x == Point<3>(0, 0, 0)));
  BOOST_TEST((result.pushes == std::vector<double>{1, 2, 3}));
}

BOOST_AUTO_TEST_CASE(behind_one_face_of_an_acute_corner_only_that_face_pushes) {
  // faces at 60 degrees; from behind both, but with a nearest point on the first face
  std::vector<Constraint<2>> const wedge{{direction(90), 0}, {direction(90 + 120), 0}};
  Projected<2> const result(wedge, {-1.9, -0.1});
  BOOST_TEST((result.x - Point<2>(-1.9, 0)).norm() <= 4 * eps);
  BOOST_TEST(result.pushes[1] == 0);
  // on the other side of the corner both push, to the corner
  Projected<2> const corner(wedge, {1, -0.1});
  BOOST_TEST(corner.x.norm() <= 4 * eps);
  BOOST_TEST(corner.pushes[0] > 0);
  BOOST_TEST(corner.pushes[1] > 0);
}

BOOST_AUTO_TEST_CASE(the_point_is_that_of_coordinate_ascent) {
  // what the ascent leaves of slow corners after 20000 sweeps; 3000 points in all
  for (int count = 1; count <= 5; ++count)
    for (bool const with_plane : {false, true}) BOOST_TEST_CONTEXT(count << " constraints, plane " << with_plane) {
        BOOST_TEST(worst_difference<2>(count, with_plane) <= 1e-9);
        BOOST_TEST(worst_difference<3>(count, with_plane) <= 1e-9);
      }
}

BOOST_AUTO_TEST_CASE(faces_that_all_but_coincide_are_told_apart) {
  for (double const angle : {1e-2, 1e-5, 1e-8, 1e-11}) {
    std::vector<Constraint<2>> const kink{{direction(90 - angle), 0}, {direction(90 + angle), 0}};
    BOOST_TEST_CONTEXT("kink of 2 x " << angle << " degrees") {
      double const radians = angle * std::numbers::pi / 180;
      Projected<2> const straight_down(kink, {0, -1});  // the corner is placed along the faces to eps / angle
      BOOST_TEST(straight_down.x.norm() <= std::min(16 * eps / radians, 2 * radians));
      for (auto const& face : kink) BOOST_TEST(face.lacking(straight_down.x) <= 16 * eps);
      Projected<2> const to_the_right(kink, {1, -1});
      BOOST_TEST(to_the_right.pushes[0] == 0);  // slides up the right-hand face, at 90 + angle
      BOOST_TEST(std::abs(kink[1].lacking(to_the_right.x)) <= 16 * eps);
      BOOST_TEST((to_the_right.x - Point<2>(1, 0)).norm() <= 2 * angle);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_constraint_given_twice_changes_nothing) {
  std::vector<Constraint<2>> const once{{direction(80), 0.3}, {direction(170), -0.2}};
  std::vector<Constraint<2>> const twice{once[0], once[0], once[1], once[1]};
  generator.seed(5);
  for (int sample = 0; sample < 100; ++sample) {
    Point<2> const x = random_point<2>(-1, 1);
    BOOST_TEST((Projected<2>(once, x).x == Projected<2>(twice, x).x));
  }
}

BOOST_AUTO_TEST_CASE(half_spaces_that_share_no_point_get_the_least_squares_compromise) {
  // x >= 1 and x <= -1, y >= 0: the middle, however far away it began
  std::vector<Constraint<2>> const closing{{{1, 0}, 1}, {{-1, 0}, 1}, {{0, 1}, 0}};
  for (double const start : {0.5, -5.0, 1e3}) {
    Projected<2> const result(closing, {start, -2});
    BOOST_TEST(std::abs(result.x[0]) <=
               1e-12 * std::max(1.0, std::abs(start)));  // ends below round-off a turn, 2/3 left
    BOOST_TEST(std::abs(result.x[1]) <= 1e-12 * std::max(2.0, std::abs(start)));
    for (double const push : result.pushes) BOOST_TEST(push >= 0);
  }
}

BOOST_AUTO_TEST_CASE(half_spaces_that_meet_only_far_away_count_as_sharing_no_point) {
  // x >= 1 and x <= -1 tilted by 1e-9: they meet at y = 2e9
  std::vector<Constraint<2>> const closing{{{1, 0}, 1}, {Point<2>(-1, 1e-9).normalized(), 1}};
  Projected<2> const result(closing, {0.5, 0});
  BOOST_TEST(result.x.norm() <= 1e-6);
}

BOOST_AUTO_TEST_CASE(what_is_no_number_stays_so) {
  double const nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(std::isnan(Projected<2>({{{0, 1}, 0}, {{1, 0}, 0}}, {nan, -1}).x[0]));
}

BOOST_AUTO_TEST_SUITE_END()
