#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "models/boundaries/contacts/coulomb.hpp"
#include "models/boundaries/contacts/material_friction.hpp"
#include "models/boundaries/contacts/separating.hpp"
#include "models/boundaries/contacts/slip.hpp"
#include "models/boundaries/contacts/stick.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/boundaries/motions/fixed.hpp"
#include "models/boundaries/motions/translation.hpp"
#include "models/boundaries/shapes/box.hpp"
#include "models/boundaries/shapes/container.hpp"
#include "models/boundaries/shapes/half_space.hpp"
#include "models/boundaries/shapes/polyline.hpp"
#include "tests/support/random_geometry.hpp"

BOOST_AUTO_TEST_SUITE(walls)

using namespace talus;
using namespace talus::test;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// The faces of a shape near a point.
template <int D>
std::vector<Surface<D>> faces(auto const& shape, Point<D> const& x) {
  std::array<Surface<D>, Wall<D>::max_surfaces> out;
  int const count = shape.surfaces(x, out);
  return {out.begin(), out.begin() + count};
}
template <int D>
bool is(Surface<D> const& face, double distance, Point<D> const& normal) {
  return std::abs(face.distance - distance) <= 4 * eps && (face.normal - normal).norm() <= 4 * eps;
}
using P2 = Point<2>;
using P3 = Point<3>;
using Line = wall::Polyline::In<2>;

/// What an InputError says, or nothing.
std::string refusal(auto const& make) {
  try {
    make();
  } catch (InputError const& error) {
    return error.what();
  }
  return "";
}
std::string refusal_of_line(std::vector<Coordinates> points) {
  return refusal([&] { Line const line({std::move(points)}); });
}
bool says(std::string const& text, std::string const& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_half_space_measures_along_its_normal_of_any_length) {
  wall::HalfSpace::In<2> const plane({{1, 1}, {30, 40}});
  BOOST_TEST(is<2>(faces<2>(plane, {4, 5})[0], 5, {0.6, 0.8}));
  BOOST_TEST(is<2>(faces<2>(plane, {1, 0})[0], -0.8, {0.6, 0.8}));
  wall::HalfSpace::In<3> const axis({{0, 0, 0}, {0, 0, -7}});
  BOOST_TEST((faces<3>(axis, {5, 5, -2})[0].normal == P3(0, 0, -1)));
  BOOST_TEST(axis.distance({5, 5, -2}) == 2);
}

BOOST_AUTO_TEST_CASE(a_half_space_without_a_direction_is_refused) {
  BOOST_TEST(says(refusal([] { wall::HalfSpace::In<2> const bad({{0, 0}, {0, 0}}); }), "must not be zero"));
  BOOST_TEST(says(refusal([] { wall::HalfSpace::In<2> const bad({{0, 0}, {0, 0, 1}}); }), "must not be zero"));
  double const nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(says(refusal([&] { wall::HalfSpace::In<2> const bad({{0, 0}, {1, nan}}); }), "not a finite number"));
  BOOST_TEST(wall::HalfSpace::Parameters::check({{0, 0}, {0, 0}}).has_value());
  BOOST_TEST(!wall::HalfSpace::Parameters::check({}).has_value());
}

BOOST_AUTO_TEST_CASE(a_container_has_the_nearer_face_of_each_axis) {
  wall::Container::In<3> const room({{0, 0, 0}, {4, 2, 1}});
  auto const inside = faces<3>(room, {3.5, 0.25, 0.75});
  BOOST_TEST_REQUIRE(inside.size() == 3U);
  BOOST_TEST(is<3>(inside[0], 0.5, {-1, 0, 0}));
  BOOST_TEST(is<3>(inside[1], 0.25, {0, 1, 0}));
  BOOST_TEST(is<3>(inside[2], 0.25, {0, 0, -1}));
  BOOST_TEST(room.distance({3.5, 0.25, 0.75}) == 0.25);
  auto const beyond_a_corner = faces<3>(room, {-0.5, 2.25, 0.5});
  BOOST_TEST(beyond_a_corner[0].distance == -0.5);
  BOOST_TEST(beyond_a_corner[1].distance == -0.25);
  BOOST_TEST(beyond_a_corner[2].distance == 0.5);
  BOOST_TEST(room.distance({-0.5, 2.25, 0.5}) == -0.5);
}

BOOST_AUTO_TEST_CASE(a_box_is_measured_to_its_nearest_point) {
  wall::Box::In<2> const block({{0, 0}, {4, 2}});
  BOOST_TEST(is<2>(faces<2>(block, {1, 2.5})[0], 0.5, {0, 1}));
  BOOST_TEST(is<2>(faces<2>(block, {1, 1.75})[0], -0.25, {0, 1}));
  BOOST_TEST(is<2>(faces<2>(block, {1, 2})[0], 0, {0, 1}));
  BOOST_TEST(is<2>(faces<2>(block, {-0.5, 1})[0], 0.5, {-1, 0}));
  BOOST_TEST(is<2>(faces<2>(block, {4, 2})[0], 0, {1, 0}));  // the corner itself
  BOOST_TEST(is<2>(faces<2>(block, {7, -4})[0], 5, {0.6, -0.8}));
  wall::Box::In<2> const at_the_origin({{-1, -1}, {0, 0}});
  BOOST_TEST(is<2>(faces<2>(at_the_origin, {3e-200, 4e-200})[0], 0, {0.6, 0.8}));  // squares underflow
}

BOOST_AUTO_TEST_CASE(boxes_without_volume_are_refused) {
  BOOST_TEST(says(refusal([] { wall::Box::In<2> const bad({{0, 0}, {1, 0}}); }), "min must be less than max"));
  BOOST_TEST(says(refusal([] { wall::Container::In<3> const bad({{0, 0, 0}, {1, 1}}); }), "min must be less than max"));
  BOOST_TEST(wall::Extent::check({{0, 0, 0}, {1, 1}}).has_value());
  BOOST_TEST(wall::Extent::check({{0, 0}, {1, 0}}).has_value());
  BOOST_TEST(!wall::Extent::check({{0, 0}, {1, 1}}).has_value());
}

BOOST_AUTO_TEST_CASE(the_material_is_to_the_left_of_a_polyline_which_goes_on_beyond_its_ends) {
  Line const ground({{{0, 0}, {1, 0}}}), ceiling({{{1, 0}, {0, 0}}});
  for (double const x : {-50.0, 0.0, 0.5, 1.0, 70.0}) {
    BOOST_TEST(is<2>(faces<2>(ground, {x, 2})[0], 2, {0, 1}));
    BOOST_TEST(is<2>(faces<2>(ground, {x, -2})[0], -2, {0, 1}));
    BOOST_TEST(is<2>(faces<2>(ceiling, {x, 2})[0], -2, {0, -1}));
  }
}

BOOST_AUTO_TEST_CASE(at_a_corner_that_juts_out_the_normal_points_away_from_it) {
  Line const brink({{{-1, 0}, {0, 0}, {0, -1}}});  // material above and to the right
  BOOST_TEST(is<2>(faces<2>(brink, {3, 4})[0], 5, {0.6, 0.8}));
  BOOST_TEST(is<2>(faces<2>(brink, {-3, 4})[0], 4, {0, 1}));
  BOOST_TEST(is<2>(faces<2>(brink, {3, -4})[0], 3, {1, 0}));
  BOOST_TEST(is<2>(faces<2>(brink, {-3, -1})[0], -1, {0, 1}));  // in the wall: the nearer face
  BOOST_TEST(faces<2>(brink, {-3, -1}).size() == 1U);
  double const diagonal = std::numbers::sqrt2 / 2;
  BOOST_TEST(is<2>(faces<2>(brink, {0, 0})[0], 0, {diagonal, diagonal}));  // the corner itself
}

BOOST_AUTO_TEST_CASE(a_node_behind_a_corner_that_wedges_the_material_in_has_both_faces) {
  Line const step({{{-1, 0}, {0, 0}, {0, 1}}});  // floor, then a wall on the right
  auto const behind = faces<2>(step, {3, -4});
  BOOST_TEST_REQUIRE(behind.size() == 2U);
  BOOST_TEST(is<2>(behind[0], -3, {-1, 0}));
  BOOST_TEST(is<2>(behind[1], -4, {0, 1}));
  BOOST_TEST(step.distance({3, -4}) == -5);
  BOOST_TEST(faces<2>(step, {-3, 4}).size() == 1U);  // in the open
}

BOOST_AUTO_TEST_CASE(a_polyline_of_three_points_that_wedges_in_touches_as_two_half_spaces_do) {
  generator.seed(11);
  for (double const degrees : {10.0, 90.0, 150.0}) {  // by how much the line turns left
    double const turn = degrees * std::numbers::pi / 180;
    P2 const along(std::cos(turn), std::sin(turn)), normal(-along[1], along[0]);
    Line const line({{{-1, 0}, {0, 0}, {along[0], along[1]}}});
    for (int sample = 0; sample < 500; ++sample) {
      P2 const x = random_point<2>(-1, 1);
      std::array<double, 2> touched{};  // distance to the floor and to the slope, where they are touched
      for (auto const& face : faces<2>(line, x))
        if (face.distance <= 0) touched[(face.normal - P2(0, 1)).norm() < 1e-9 ? 0 : 1] = face.distance;
      BOOST_TEST(std::abs(touched[0] - std::min(x[1], 0.0)) <= 4 * eps);
      BOOST_TEST(std::abs(touched[1] - std::min(normal.dot(x), 0.0)) <= 4 * eps);
    }
  }
}

BOOST_AUTO_TEST_CASE(polylines_without_a_direction_are_refused) {
  BOOST_TEST(says(refusal_of_line({{0, 0}}), "two points or more"));
  BOOST_TEST(says(refusal_of_line({{0, 0}, {0, 0}}), "points 0 and 1 are the same"));
  BOOST_TEST(says(refusal_of_line({{0, 0}, {1, 0}, {1, 0}}), "points 1 and 2 are the same"));
  BOOST_TEST(says(refusal_of_line({{0, 0}, {1, 0}, {0.5, 0}}), "turns back onto itself"));
  BOOST_TEST(says(refusal_of_line({{0, 0}, {1, 0, 0}}), "two coordinates"));
  BOOST_TEST(says(refusal_of_line({{0, 0}, {std::numeric_limits<double>::infinity(), 0}}), "not a finite number"));
}

BOOST_AUTO_TEST_CASE(contacts_say_what_they_let_a_node_do) {
  BOOST_TEST(wall::Stick::rule({}).sticks);
  BOOST_TEST(!wall::Slip::rule({}).separates);
  BOOST_TEST((wall::Separating::rule({}).separates && wall::Separating::rule({}).friction == 0));
  BOOST_TEST((wall::Coulomb::rule({0.3}).separates && wall::Coulomb::rule({0.3}).friction == 0.3));
  BOOST_TEST((wall::MaterialFriction::rule({}).material_friction && wall::MaterialFriction::rule({}).separates));
}

BOOST_AUTO_TEST_CASE(friction_must_be_a_finite_number_and_not_negative) {
  for_each_parameter<wall::Coulomb::Parameters>([](auto const& row) {
    for (double const fine : {0.0, 0.5, 1e6}) BOOST_TEST(row.range.contains(fine));
    for (double const bad : {-1e-300, std::nan(""), std::numeric_limits<double>::infinity()})
      BOOST_TEST(!row.range.contains(bad));
  });
}

BOOST_AUTO_TEST_CASE(a_translation_moves_between_its_start_and_end) {
  wall::Translation::In<2> const gate({{0, 2}, 1, 3});
  for (double const t : {-10.0, 0.0, 0.999}) BOOST_TEST((gate.offset(t) == P2(0, 0) && gate.velocity(t) == P2(0, 0)));
  for (double const t : {1.0, 2.0, 3.0})
    BOOST_TEST((gate.offset(t) == P2(0, 2 * (t - 1)) && gate.velocity(t) == P2(0, 2)));
  for (double const t : {3.001, 1e6}) BOOST_TEST((gate.offset(t) == P2(0, 4) && gate.velocity(t) == P2(0, 0)));
  wall::Translation::In<2> const endless({{1, 0}});
  BOOST_TEST((endless.offset(1e6) == P2(1e6, 0)));
  BOOST_TEST(says(refusal([] { wall::Translation::In<2> const bad({{1, 0}, 1, 0.5}); }), "before it starts"));
}

BOOST_AUTO_TEST_CASE(a_wall_is_its_shape_carried_along_by_its_motion) {
  auto const gate = make_wall<2, wall::HalfSpace, wall::Coulomb, wall::Translation>("gate", {{1, 0}, {-1, 0}}, {0.4},
                                                                                    {{0.5, 0}, 2, 4});
  BOOST_TEST(gate->name == "gate");
  BOOST_TEST(gate->contact.friction == 0.4);
  for (double const t : {0.0, 3.0, 4.0, 9.0}) {
    double const face = 1 + 0.5 * std::clamp(t - 2, 0.0, 2.0);
    std::array<Surface<2>, 3> out;
    BOOST_TEST(gate->surfaces({0, 7}, t, out) == 1);
    BOOST_TEST(is<2>(out[0], face, {-1, 0}));
    BOOST_TEST(gate->distance({0, 7}, t) == face);
  }
  BOOST_TEST((gate->velocity(3) == P2(0.5, 0)));
  BOOST_TEST((gate->velocity(5) == P2(0, 0)));
}

BOOST_AUTO_TEST_CASE(a_wall_that_cannot_be_is_refused_by_its_name) {
  auto const in_space = refusal([] { (void)make_wall<3, wall::Polyline, wall::Slip, wall::Fixed>("bed", {}, {}, {}); });
  BOOST_TEST(says(in_space, "wall 'bed': polyline is not available in 3 dimensions"));
  auto const flat = refusal([] {
    (void)make_wall<2, wall::HalfSpace, wall::Slip, wall::Fixed>("bed", {{0, 0}, {0, 0}}, {}, {});
  });
  BOOST_TEST(says(flat, "wall 'bed': half_space"));
}

BOOST_AUTO_TEST_SUITE_END()
