#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/body.hpp"
#include "core/type_list.hpp"
#include "models/bodies/seedings/lattice.hpp"
#include "models/bodies/seedings/poisson_disk.hpp"
#include "models/bodies/shapes/polygon.hpp"
#include "models/kernels/cubic.hpp"
#include "models/kernels/linear.hpp"
#include "models/kernels/quadratic.hpp"
#include "tests/models/bodies.hpp"

BOOST_AUTO_TEST_SUITE(bodies_seeds)

using namespace talus;
using body::box, body::refuses, body::Lattice, body::PoissonDisk, body::Polygon;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

static_assert(body::SeedingOf<Lattice, body::Box::In<3>> && body::SeedingOf<PoissonDisk, Polygon::In<2>>);
struct WithoutCount : PoissonDisk {
  template <int D>
  double per_volume(double h) const = delete;
};
static_assert(!body::SeedingOf<WithoutCount, body::Box::In<2>> && !body::SeedingOf<int, body::Box::In<2>>);

/// Whether every one of the cells of side h between 0 and `cells` h holds as many particles.
template <int D>
bool every_cell_holds(int number, std::vector<Point<D>> const& points, double h, int cells) {
  std::vector<int> count(static_cast<std::size_t>(std::pow(cells, D)));
  for (auto const& x : points) {
    int place = 0;
    for (int axis = 0; axis < D; ++axis) place = place * cells + static_cast<int>(x[axis] / h);
    ++count[static_cast<std::size_t>(place)];
  }
  return std::all_of(count.begin(), count.end(), [&](int n) { return n == number; });
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_lattice_fills_every_cell_alike) {
  for (int const n : {1, 2, 3, 5}) {
    BOOST_TEST_CONTEXT("per axis " << n) {
      auto const plane = seed(box<2>({0, 0}, {0.7, 0.7}), Lattice({n}), 0.1);
      BOOST_TEST(plane.points.size() == static_cast<std::size_t>(49 * n * n));
      BOOST_TEST(every_cell_holds<2>(n * n, plane.points, 0.1, 7));
      auto const space = seed(box<3>({0, 0, 0}, {0.3, 0.3, 0.3}), Lattice({n}), 0.1);
      BOOST_TEST(space.points.size() == static_cast<std::size_t>(27 * n * n * n));
      BOOST_TEST(every_cell_holds<3>(n * n * n, space.points, 0.1, 3));
      BOOST_TEST(space.volume == std::pow(0.1 / n, 3), boost::test_tools::tolerance(16 * eps));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_lattice_begins_half_a_spacing_from_the_corner_and_has_the_centroid_of_its_box) {
  auto const seeds = seed(box<3>({-1.3, 0.25, 2}, {-0.5, 1.25, 2.5}), Lattice({2}), 0.1);
  BOOST_TEST_REQUIRE(seeds.points.size() == 16 * 20 * 10);
  Point<3> sum = Point<3>::Zero(), first = seeds.points.front();
  for (auto const& x : seeds.points) {
    sum += x;
    first = first.cwiseMin(x);
  }
  BOOST_TEST((first - Point<3>(-1.275, 0.275, 2.025)).norm() <= 4 * eps);
  // a sum of 3200 numbers of up to 2.5, rounded 3200 times
  BOOST_TEST((sum / 3200 - Point<3>(-0.9, 0.75, 2.25)).norm() <= 3200 * 2.5 * eps);
}

BOOST_AUTO_TEST_CASE(particles_of_a_lattice_share_the_volume_of_a_body_that_does_not_fit_the_grid) {
  auto const odd = box<2>({0, 0}, {0.26, 0.1});  // 5.2 spacings
  auto const seeds = seed(odd, Lattice({2}), 0.1);
  BOOST_TEST(seeds.points.size() == 10);
  BOOST_TEST(seeds.volume * 10 == odd.volume(), boost::test_tools::tolerance(2 * eps));
  auto const triangle = Polygon::In<2>({{{0, 0}, {1, 0}, {0, 1}}});
  auto const in_triangle = seed(triangle, Lattice({4}), 0.1);
  // pairs (i, j) with (i + 1/2) + (j + 1/2) < 40: i + j <= 38; the diagonal i + j = 39 lies on the edge, up to rounding
  BOOST_TEST(in_triangle.points.size() >= 39 * 40 / 2);
  BOOST_TEST(in_triangle.points.size() <= 40 * 41 / 2);
  for (auto const& x : in_triangle.points) BOOST_TEST_REQUIRE(triangle.contains(x));
}

BOOST_AUTO_TEST_CASE(a_constant_stress_on_a_lattice_exerts_no_force_inside) {
  for_each_type(TypeList<kernel::Linear, kernel::Quadratic, kernel::Cubic>{}, [](auto type) {
    using K = typename decltype(type)::type;
    for (int const n : {1, 2, 3, 4}) {
      auto const seeds = seed(box<2>({0, 0}, {8, 8}), Lattice({n}), 1);
      Point<2> force = Point<2>::Zero();  // on the node (4, 4), for a stress of 1
      for (auto const& x : seeds.points) {
        std::array<std::array<double, K::width>, 2> w{}, g{};
        Eigen::Array2i node;
        for (int axis = 0; axis < 2; ++axis) {
          auto const base = static_cast<int>(std::floor(x[axis] - K::base_shift));
          auto const of_axis = static_cast<std::size_t>(axis);
          K::weights(x[axis] - base, w[of_axis]);
          K::slopes(x[axis] - base, g[of_axis]);
          node[axis] = 4 - base;
        }
        if ((node < 0).any() || (node >= K::width).any()) continue;
        auto const i = static_cast<std::size_t>(node[0]), j = static_cast<std::size_t>(node[1]);
        force += seeds.volume * Point<2>(g[0][i] * w[1][j], w[0][i] * g[1][j]);
      }
      BOOST_TEST(force.norm() <= 16 * eps);  // up to 256 terms below 1/n^2 that cancel in pairs
    }
  });
}

BOOST_AUTO_TEST_CASE(a_body_smaller_than_a_particle_gets_hardly_any_or_is_refused) {
  for (int const number : {0, 1, 2, 42}) {
    auto const few = seed(box<2>({0, 0}, {1e-3, 1e-3}), PoissonDisk({.per_cell = 1, .seed = number}), 1);
    BOOST_TEST(few.points.size() >= 1);
    BOOST_TEST(few.points.size() <= 2);  // within one of the one that there must be
  }
  BOOST_TEST(seed(box<3>({0, 0, 0}, {0.6, 0.6, 0.6}), Lattice({1}), 1).points.size() == 1);
  refuses([] { return seed(box<2>({0, 0}, {1, 0.4}), Lattice({1}), 1); }, "holds no particle");
}

BOOST_AUTO_TEST_CASE(too_many_particles_are_refused_with_what_they_would_take) {
  refuses([] { return seed(box<3>({0, 0, 0}, {10, 10, 10}), Lattice({10}), 0.01); }, "1e+12 particles");
  refuses([] { return seed(box<3>({0, 0, 0}, {10, 10, 10}), Lattice({10}), 0.01); }, "104000 GB");
  refuses(
      [] {
        return seed(box<2>({0, 0}, {1e6, 1e6}), PoissonDisk(PoissonDisk::Parameters{}), 1e-3);
      },
      "at most 2e+08");
  refuses([] { return seed(box<2>({0, 0}, {1, 1}), Lattice({1}), 0); }, "spacing");
  refuses([] { return seed(box<2>({0, 0}, {1, 1}), Lattice({1}), NAN); }, "spacing");
}

BOOST_AUTO_TEST_SUITE_END()
