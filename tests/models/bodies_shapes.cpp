#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/body.hpp"
#include "models/bodies/shapes/polygon.hpp"
#include "tests/models/bodies.hpp"

BOOST_AUTO_TEST_SUITE(bodies_shapes)

using namespace talus;
using body::box, body::refuses;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

static_assert(body::BodyShape<body::Box> && body::BodyShape<body::Polygon>);
static_assert(body::Region<body::Box::In<3>> && body::Box::supports(3) && !body::Polygon::supports(3));
struct WithoutVolume {
  static constexpr int dimension = 2;
  bool contains(Point<2> const&) const;
  std::pair<Point<2>, Point<2>> bounds() const;
};
static_assert(!body::Region<WithoutVolume> && !body::BodyShape<WithoutVolume> && !body::Region<int>);

body::Polygon::In<2> polygon(std::vector<Coordinates> points) {
  return body::Polygon::In<2>({std::move(points)});
}

/// Area by the shoelace formula as it stands in textbooks, with indices that wrap.
double shoelace(std::vector<Coordinates> const& x) {
  double sum = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    auto const &a = x[k], &b = x[(k + 1) % x.size()];
    sum += (b[0] - a[0]) * (b[1] + a[1]) / 2;
  }
  return std::abs(sum);
}

std::vector<Coordinates> const letter_u{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

std::vector<Coordinates> regular(int n) {
  std::vector<Coordinates> points;
  for (int k = 0; k < n; ++k) points.push_back({std::cos(2 * M_PI * k / n), std::sin(2 * M_PI * k / n)});
  return points;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_box_holds_its_lower_faces_and_not_its_upper_ones) {
  auto const b = box<3>({0, -1, 2}, {1, 1, 5});
  BOOST_TEST(b.volume() == 6);
  BOOST_TEST(b.contains({0, -1, 2}));
  BOOST_TEST(b.contains({0.5, 0, 4}));
  BOOST_TEST(!b.contains({1, 0, 4}));
  BOOST_TEST(!b.contains({0.5, 1, 4}));
  BOOST_TEST(!b.contains({0.5, 0, 5}));
  BOOST_TEST(!b.contains({-1e-300, 0, 4}));
  BOOST_TEST((b.bounds().first == Point<3>(0, -1, 2)));
  BOOST_TEST((b.bounds().second == Point<3>(1, 1, 5)));
}

BOOST_AUTO_TEST_CASE(a_box_without_a_finite_volume_is_refused) {
  refuses([] { return box<2>({0, 0}, {0, 1}); }, "less than max");
  refuses([] { return box<2>({0, 2}, {1, 1}); }, "less than max");
  refuses([] { return box<2>({0, NAN}, {1, 1}); }, "finite");
  refuses([] { return box<2>({0, 0}, {1, INFINITY}); }, "finite");
  refuses([] { return box<2>({0, 0}, {1e200, 1e200}); }, "finite");
  refuses([] { return box<3>({0, 0, 0}, {1e-200, 1e-200, 1}); }, "positive");
  refuses([] { return box<2>({0, 0, 0}, {1, 1}); }, "as many");
}

BOOST_AUTO_TEST_CASE(the_area_of_a_polygon_is_that_of_the_shoelace_formula_in_either_sense) {
  for (auto points :
       {letter_u, regular(3), regular(97), std::vector<Coordinates>{{1e3, 1e3}, {1e3 + 1, 1e3}, {1e3, 1e3 + 1}}}) {
    double const exact = shoelace(points);
    // round-off of products of coordinates up to 1e3, n of them
    double const slack = static_cast<double>(points.size()) * 4 * eps * std::max(1.0, points[0][0] * points[0][0]);
    BOOST_TEST(std::abs(polygon(points).volume() - exact) <= slack);
    std::reverse(points.begin(), points.end());
    BOOST_TEST(std::abs(polygon(points).volume() - exact) <= slack);
  }
  BOOST_TEST(polygon(letter_u).volume() == 5);
  BOOST_TEST(polygon(regular(97)).volume() == 97 / 2.0 * std::sin(2 * M_PI / 97),
             boost::test_tools::tolerance(100 * eps));
}

BOOST_AUTO_TEST_CASE(a_polygon_holds_its_inside_in_either_sense) {
  auto reversed = letter_u;
  std::reverse(reversed.begin(), reversed.end());
  for (auto const& u : {polygon(letter_u), polygon(reversed)}) {
    BOOST_TEST(u.contains({0.5, 1.5}));
    BOOST_TEST(u.contains({2.5, 1.5}));
    BOOST_TEST(u.contains({1.5, 0.5}));
    BOOST_TEST(!u.contains({1.5, 1.5}));
    BOOST_TEST(!u.contains({-0.5, 1}));
    BOOST_TEST(!u.contains({3.5, 1}));
    BOOST_TEST(!u.contains({1.5, 2.5}));
    BOOST_TEST(!u.contains({-1, 2}));  // on the line through two upper edges
    BOOST_TEST((u.bounds().first == Point<2>(0, 0)));
    BOOST_TEST((u.bounds().second == Point<2>(3, 2)));
  }
}

BOOST_AUTO_TEST_CASE(polygons_that_share_edges_share_no_point_and_leave_none_out) {
  // Six triangles around a centre, which tile a hexagon; points along and next to the shared edges.
  auto const corner = regular(6);
  Coordinates const centre{0.1, 0.05};
  std::vector<body::Polygon::In<2>> tiles;
  for (std::size_t k = 0; k < 6; ++k) tiles.push_back(polygon({centre, corner[k], corner[(k + 1) % 6]}));
  auto const owners = [&](Point<2> const& x) {
    return std::count_if(tiles.begin(), tiles.end(), [&](auto const& tile) { return tile.contains(x); });
  };
  for (auto const& c : corner) {
    for (int k = 1; k < 1000; ++k) {
      double const s = k / 1000.0;
      Point<2> const x{centre[0] + s * (c[0] - centre[0]), centre[1] + s * (c[1] - centre[1])};
      BOOST_TEST_REQUIRE(owners(x) == 1);
      BOOST_TEST_REQUIRE(owners({std::nextafter(x[0], 9.0), x[1]}) == 1);
      BOOST_TEST_REQUIRE(owners({x[0], std::nextafter(x[1], -9.0)}) == 1);
    }
  }
  BOOST_TEST(owners({centre[0], centre[1]}) == 1);
  BOOST_TEST(owners({2.0, 0.0}) == 0);
}

BOOST_AUTO_TEST_CASE(a_polygon_that_is_not_simple_is_refused) {
  refuses([] { return polygon({{0, 0}, {1, 0}}); }, "three points");
  refuses([] { return polygon({{0, 0}, {1, 0, 0}, {0, 1}}); }, "two coordinates");
  refuses([] { return polygon({{0, 0}, {1, 0}, {1, NAN}}); }, "finite");
  refuses([] { return polygon({{0, 0}, {1, 0}, {1, 0}, {0, 1}}); }, "points 1 and 2 are the same");
  refuses([] { return polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}}); }, "begin at points 0 and 2 meet");
  refuses([] { return polygon({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}); }, "meet");  // a vertex on an edge
  refuses([] { return polygon({{0, 0}, {1, 0}, {2, 0}}); }, "turns back");
  refuses([] { return polygon({{0, 0}, {2, 0}, {1, 0}, {1, 1}}); }, "turns back");
  refuses([] { return polygon({{0, 0}, {1, 0}, {1, 1e-17}}); }, "area");
  refuses([] { return polygon({{0, 0}, {1e200, 0}, {0, 1e200}}); }, "finite");
}

BOOST_AUTO_TEST_SUITE_END()
