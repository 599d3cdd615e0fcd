#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "models/boundaries/make_wall.hpp"
#include "models/catalogue.hpp"
#include "tests/support/random_geometry.hpp"

BOOST_AUTO_TEST_SUITE(wall_parts)

using namespace talus;
using namespace talus::test;

namespace {

/// Parameters to try a shape with: its defaults, and what is odd about it.
template <class S>
std::vector<typename S::Parameters> examples(std::type_identity<S>) {
  return {{}};
}
std::vector<wall::HalfSpace::Parameters> examples(std::type_identity<wall::HalfSpace>) {
  return {{}, {{0.2, -0.1, 0.3}, {3, -4, 12}}, {{0, 0, 0}, {-1e-200, 2e-200, 0}}};
}
std::vector<wall::Polyline::Parameters> examples(std::type_identity<wall::Polyline>) {
  return {{},
          {{{0, 0.5}, {0.5, 0}, {1, 0}}},                                  // a slope that runs out
          {{{0, 1}, {0, 0}, {1, 0}, {1, 1}}},                              // a trough
          {{{0, 0}, {0.3, 0}, {0.3, 0.4}, {0.7, 0.4}, {0.7, 0}, {1, 0}}},  // a step
          {{{0, 0}, {0.9, 0.1}, {0.2, 0.3}, {1, 0.5}}}};                   // an overhang
}

std::vector<wall::Translation::Parameters> examples(std::type_identity<wall::Translation>) {
  return {{{1.5, -2}, -0.5, 0.75}, {{0.25, 0.5}, 1, 1}};
}

template <int D>
using Judge = std::function<void(Wall<D> const&)>;

/// Calls judge(a wall at rest) for every example of every shape of the catalogue that there is in D dimensions.
template <int D>
void for_each_shape(Judge<D> const& judge) {
  for_each_type(catalogue::Shapes{}, [&]<class S>(std::type_identity<S> type) {
    if constexpr (S::supports(D)) {
      std::size_t number = 0;
      for (auto const& parameters : examples(type))
        BOOST_TEST_CONTEXT(S::name << " in " << D << " dimensions, example " << number++) {
          generator.seed(number);
          judge(*make_wall<D, S, wall::Slip, wall::Fixed>("tried", parameters, {}, {}));
        }
    }
  });
}

// What the concepts must refuse.
struct WithoutDistance : wall::Box {
  template <int D>
  struct In {
    explicit In(Parameters const&) {}
    int surfaces(Point<D> const&, std::span<Surface<D>>) const { return 0; }
  };
};
struct WithoutRule : wall::Slip {
  static double rule(Parameters const&) { return 0; }
};
struct WithoutOffset : wall::Fixed {
  template <int D>
  struct In {
    explicit In(Parameters const&) {}
    [[nodiscard]] Point<D> velocity(double) const { return Point<D>::Zero(); }
  };
};
static_assert(!WallShape<WithoutDistance> && !WallShape<wall::Slip> && !WallContact<WithoutRule> &&
              !WallContact<wall::Box> && !WallMotion<WithoutOffset> && !WallMotion<wall::Box>);

/// How far a shape is, at worst, from what a distance and its faces must be. Coordinates are of order 1.
struct Defects {
  double lipschitz = 0, length = 0, gradient = 0, bound = 0;
  int compared = 0, inside = 0, outside = 0, touched_wrongly = 0;
};

template <int D>
void compare_gradient(Wall<D> const& wall, Point<D> const& x, Defects& worst) {
  constexpr double h = 1e-6;
  std::array<Surface<D>, Wall<D>::max_surfaces> here, ahead, behind;
  int const count = wall.surfaces(x, 0, here);
  for (int axis = 0; axis < D; ++axis) {
    Point<D> const step = h * Point<D>::Unit(axis);
    if (wall.surfaces(x + step, 0, ahead) != count || wall.surfaces(x - step, 0, behind) != count) continue;
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
      if ((ahead[k].normal - behind[k].normal).norm() > 1e-4) continue;  // another face, or a corner nearer than 2 cm
      double const slope = (ahead[k].distance - behind[k].distance) / (2 * h);
      worst.gradient = std::max(worst.gradient, std::abs(slope - here[k].normal[axis]));
      ++worst.compared;
    }
  }
}

template <int D>
Defects defects(Wall<D> const& wall) {
  Defects worst;
  for (int sample = 0; sample < 5000; ++sample) {
    Point<D> const x = random_point<D>(-1, 2), step = std::pow(10, between(-6, 0)) * random_direction<D>();
    double const distance = wall.distance(x, 0);
    worst.lipschitz = std::max(worst.lipschitz, std::abs(wall.distance(x + step, 0) - distance) - step.norm());

    std::array<Surface<D>, Wall<D>::max_surfaces> faces;
    int const count = wall.surfaces(x, 0, faces);
    BOOST_TEST_REQUIRE((count >= 1 && count <= Wall<D>::max_surfaces));
    bool touched = false;
    for (auto const& face : std::span(faces).first(static_cast<std::size_t>(count))) {
      worst.length = std::max(worst.length, std::abs(face.normal.norm() - 1));
      worst.bound = std::max(worst.bound, distance - face.distance);
      touched = touched || face.distance <= 0;
    }
    ++(distance <= 0 ? worst.inside : worst.outside);
    worst.touched_wrongly += touched != (distance <= 0);
    compare_gradient(wall, x, worst);
  }
  return worst;
}

template <int D>
void judge_shapes() {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  for_each_shape<D>([](Wall<D> const& wall) {
    auto const worst = defects(wall);
    BOOST_TEST(worst.lipschitz <= 8 * eps);  // round-off of distances up to 4
    BOOST_TEST(worst.length <= 4 * eps);
    BOOST_TEST(worst.gradient <= 1e-8);  // round-off 2e-16 / h; (h / r)^2 / 2 at r > 2 cm from a corner
    BOOST_TEST(worst.compared > 4000 * D);
    BOOST_TEST(worst.bound <= 8 * eps);
    BOOST_TEST(worst.touched_wrongly == 0);
    BOOST_TEST((worst.inside > 50 && worst.outside > 50));
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_policy_of_the_catalogue_fulfils_its_concept) {
  for_each_type(catalogue::Shapes{}, []<class S>(std::type_identity<S>) {
    static_assert(WallShape<S>);
    BOOST_TEST(S::supports(2));
  });
  for_each_type(catalogue::Contacts{}, []<class C>(std::type_identity<C>) { static_assert(WallContact<C>); });
  for_each_type(catalogue::Motions{}, []<class M>(std::type_identity<M>) { static_assert(WallMotion<M>); });
}

BOOST_AUTO_TEST_CASE(distance_bounds_that_of_every_face_and_normals_are_gradients_of_length_one) {
  judge_shapes<2>();
  judge_shapes<3>();
}

BOOST_AUTO_TEST_CASE(velocity_of_a_motion_is_the_rate_of_its_offset) {
  for_each_type(catalogue::Motions{}, []<class M>(std::type_identity<M> type) {
    for (auto const& parameters : examples(type)) BOOST_TEST_CONTEXT("motion " << M::name) {
        typename M::template In<2> const motion(parameters);
        double worst = 0;
        for (int sample = 0; sample < 1000; ++sample) {
          double const t = between(-3, 3), h = 1e-4;
          if (motion.velocity(t - h) != motion.velocity(t + h)) continue;  // it starts or stops here
          Point<2> const rate = (motion.offset(t + h) - motion.offset(t - h)) / (2 * h);
          worst = std::max(worst, (rate - motion.velocity(t)).norm());
        }
        BOOST_TEST(worst <= 1e-11);  // round-off 4e-16 / h of offsets up to 3
      }
  });
}

BOOST_AUTO_TEST_SUITE_END()
