#include <Eigen/Geometry>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/body.hpp"
#include "models/bodies/velocities/at_rest.hpp"
#include "models/bodies/velocities/linear.hpp"
#include "models/bodies/velocities/rotation.hpp"
#include "models/bodies/velocities/uniform.hpp"
#include "tests/models/bodies.hpp"

BOOST_AUTO_TEST_SUITE(bodies_velocities)

using namespace talus;
using body::refuses;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

static_assert(body::InitialVelocity<body::AtRest> && body::InitialVelocity<body::Uniform> &&
              body::InitialVelocity<body::Linear> && body::InitialVelocity<body::Rotation>);
struct WithoutGradient {
  static constexpr int dimension = 2;
  Point<2> velocity(Point<2> const& x) const;
};
static_assert(!body::VelocityField<WithoutGradient> && !body::InitialVelocity<WithoutGradient>);

body::Rotation::Parameters const tilted{.angular_velocity = 3, .centre = {0.2, -0.4, 1}, .axis = {1, -2, 2}};
body::Linear::Parameters const shear{
    .velocity = {1, -2, 0.5}, .origin = {0.3, 0.1, -1}, .gradient = {{1, 2, 3}, {-4, 5, -6}, {7, 8, -9}}};

/// Largest difference between the gradient and central differences, which are exact for linear fields but for
/// round-off.
template <class Field>
double gradient_error(Field const& field) {
  constexpr int D = Field::dimension;
  Point<D> const x = Point<D>::LinSpaced(0.7, -1.3);
  double worst = 0;
  for (int j = 0; j < D; ++j) {
    Point<D> const step = 0.5 * Point<D>::Unit(j);
    Point<D> const column = field.velocity(x + step) - field.velocity(x - step);
    for (int i = 0; i < D; ++i) worst = std::max(worst, std::abs(field.gradient(x)(i, j) - column[i]));
  }
  return worst;
}

}  // namespace

BOOST_AUTO_TEST_CASE(gradients_are_those_of_the_velocities) {
  double const slack = 200 * eps;  // differences of velocities up to 50
  BOOST_TEST(gradient_error(body::AtRest::In<2>({})) == 0);
  BOOST_TEST(gradient_error(body::AtRest::In<3>({})) == 0);
  BOOST_TEST(gradient_error(body::Uniform::In<2>({{3, 4}})) == 0);
  BOOST_TEST(gradient_error(body::Uniform::In<3>({{3, 4, 5}})) == 0);
  BOOST_TEST(gradient_error(body::Linear::In<2>(shear)) <= slack);
  BOOST_TEST(gradient_error(body::Linear::In<3>(shear)) <= slack);
  BOOST_TEST(gradient_error(body::Rotation::In<2>({.angular_velocity = -7})) <= slack);
  BOOST_TEST(gradient_error(body::Rotation::In<3>(tilted)) <= slack);
}

BOOST_AUTO_TEST_CASE(a_body_at_rest_does_not_move) {
  BOOST_TEST((body::AtRest::In<3>({}).velocity({1, 2, 3}) == Point<3>(0, 0, 0)));
}

BOOST_AUTO_TEST_CASE(a_uniform_velocity_is_the_same_everywhere) {
  body::Uniform::In<2> const field({{3, 4}});
  BOOST_TEST((field.velocity({1, 2}) == Point<2>(3, 4)));
  BOOST_TEST((field.velocity({-1e9, 2}) == Point<2>(3, 4)));
}

BOOST_AUTO_TEST_CASE(rows_of_the_gradient_belong_to_components_of_the_velocity) {
  // v_x = 4 y/0.05: a layer 0.05 m high that moves with 4 m/s at its surface
  body::Linear::In<2> const field({.gradient = {{0, 80}, {0, 0}}});
  BOOST_TEST((field.velocity({7, 0.05}) == Point<2>(4, 0)));
  BOOST_TEST(field.gradient({7, 0.05})(0, 1) == 80);
  BOOST_TEST(field.gradient({7, 0.05})(1, 0) == 0);
  BOOST_TEST((body::Linear::In<3>(shear).velocity({0.3, 0.1, -1}) == Point<3>(1, -2, 0.5)));
}

BOOST_AUTO_TEST_CASE(a_rotation_is_counter_clockwise_about_its_centre) {
  body::Rotation::In<2> const plane({.angular_velocity = 2, .centre = {1, 1}});
  BOOST_TEST((plane.velocity({1, 1}) == Point<2>(0, 0)));
  BOOST_TEST((plane.velocity({2, 1}) == Point<2>(0, 2)));
  BOOST_TEST((plane.velocity({1, 2}) == Point<2>(-2, 0)));
}

BOOST_AUTO_TEST_CASE(a_rotation_in_space_is_the_cross_product_with_the_unit_axis) {
  body::Rotation::In<3> const field(tilted);
  Point<3> const x(0.7, 0.9, -0.3);
  Point<3> const omega = 3 * Point<3>(1, -2, 2) / 3;  // |(1, -2, 2)| = 3
  Point<3> const exact = omega.cross(x - Point<3>(0.2, -0.4, 1));
  BOOST_TEST((field.velocity(x) - exact).norm() <= 16 * eps * exact.norm());
  BOOST_TEST(field.velocity(Point<3>(0.2, -0.4, 1) + 5 * omega).norm() <= 100 * eps);  // the axis stands still
  auto const L = field.gradient(x);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) BOOST_TEST(L(i, j) == -L(j, i));  // rigid: no strain
  }
}

BOOST_AUTO_TEST_CASE(a_rotation_about_z_is_the_same_in_space_and_in_the_plane) {
  body::Rotation::In<3> const space({.angular_velocity = 2, .centre = {1, 1, 5}, .axis = {0, 0, 4}});
  body::Rotation::In<2> const plane({.angular_velocity = 2, .centre = {1, 1}, .axis = {0, 0, 4}});
  BOOST_TEST((space.velocity({3, 4, -2}).head<2>() == plane.velocity({3, 4})));
  BOOST_TEST(space.velocity({3, 4, -2})[2] == 0);
  body::Rotation::In<2> const clockwise({.angular_velocity = 2, .centre = {1, 1}, .axis = {0, 0, -1}});
  BOOST_TEST((clockwise.velocity({3, 4}) == -plane.velocity({3, 4})));
}

BOOST_AUTO_TEST_CASE(velocities_that_cannot_be_are_refused) {
  refuses([] { return body::Uniform::In<2>({{NAN, 0}}); }, "finite");
  refuses([] { return body::Linear::In<3>({.gradient = {{0, 0, 0}, {0, 0, 0}}}); }, "row for each axis");
  refuses([] { return body::Linear::In<2>({.gradient = {{0, INFINITY}, {0, 0}}}); }, "finite");
  refuses([] { return body::Rotation::In<3>({.angular_velocity = 1, .axis = {0, 0, 0}}); }, "length");
  refuses([] { return body::Rotation::In<3>({.angular_velocity = 1, .axis = {0, 1}}); }, "three");
  refuses([] { return body::Rotation::In<2>({.angular_velocity = 1, .axis = {0, 1, 0}}); }, "plane");
  refuses([] { return body::Rotation::In<2>({.angular_velocity = NAN}); }, "finite");
}

BOOST_AUTO_TEST_SUITE_END()
