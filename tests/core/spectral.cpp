#include "core/spectral.hpp"

#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>
#include <random>

BOOST_AUTO_TEST_SUITE(spectral)

using namespace talus;

namespace {

namespace bt = boost::test_tools;
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
using Shapes = boost::mpl::list<shape::Plane, shape::PlaneStrain, shape::Solid>;
using Flat = boost::mpl::list<shape::Plane, shape::Solid>;
std::mt19937 generator(11);

double uniform() {
  return std::uniform_real_distribution<double>(-1.0, 1.0)(generator);
}

/// Q diag(values) Q^T with a random rotation Q.
template <class Shape>
Symmetric<double, Shape> with_principal(std::array<double, 3> values) {
  Matrix<double, Shape::normals> n = principal([] {
                                       Symmetric<double, Shape> random;
                                       for (double& e : random.entries) e = uniform();
                                       return random;
                                     }())
                                         .directions;
  Vector<double, Shape::normals> used;
  for (std::size_t k = 0; k < used.size(); ++k) used[k] = values[k];
  return rebuild<double, Shape>(used, n);
}

/// Principal values of every kind: apart, near one another by 1e-6 and 1e-12, two equal, all equal, one zero.
std::vector<std::array<double, 3>> kinds(double scale) {
  double const a = scale * uniform(), b = scale * uniform(), c = scale * uniform();
  return {{a, b, c},
          {a, a * (1 + 1e-6), b},
          {a, a * (1 + 1e-12), a * (1 - 1e-12)},
          {a, b, a},
          {a, a, a},
          {0.0, b, a},
          {a, -a, 1e-8 * a},
          {scale, 0.0, 0.0}};
}

/// max |a n - lambda n| and |n^T n - I|, in units in the last place of the largest entry of a, and of 1.
template <class Shape>
double defect(Symmetric<double, Shape> const& a, Principal<double, Shape> const& p) {
  constexpr int N = Shape::normals;
  auto const entry = [&a](int i, int j) -> long double {
    return Shape::normals > Shape::plane && i != j && (i == 2 || j == 2) ? 0.0L : static_cast<long double>(a(i, j));
  };
  long double largest = 0, worst = 0, skew = 0;
  for (double const e : a.entries) largest = std::max(largest, std::abs(static_cast<long double>(e)));
  for (int k = 0; k < N; ++k)
    for (int i = 0; i < N; ++i) {
      long double residual = -p.values[static_cast<std::size_t>(k)] * static_cast<long double>(p.directions(i, k));
      long double product = i == k ? -1 : 0;
      for (int j = 0; j < N; ++j) {
        residual += entry(i, j) * p.directions(j, k);
        product += static_cast<long double>(p.directions(j, i)) * p.directions(j, k);
      }
      worst = std::max(worst, std::abs(residual));
      skew = std::max(skew, std::abs(product));
    }
  return static_cast<double>(std::max(largest > 0 ? worst / largest : worst, skew)) / eps;
}

/// Largest entry of a - b.
template <class Shape>
double distance(Symmetric<double, Shape> const& a, Symmetric<double, Shape> const& b) {
  double worst = 0;
  for (int e = 0; e < a.size; ++e) worst = std::max(worst, std::abs(a[e] - b[e]));
  return worst;
}

template <class T, class Shape>
Symmetric<T, Shape> squared(Symmetric<T, Shape> const& a) {
  Symmetric<T, Shape> r;
  for (int i = 0; i < Shape::plane; ++i)
    for (int j = i; j < Shape::plane; ++j) {
      r(i, j) = T(0.0);
      for (int k = 0; k < Shape::plane; ++k) r(i, j) = r(i, j) + a(i, k) * a(k, j);
    }
  return r;
}

}  // namespace

// The bound: twelve rotations, each with an error of about a unit in the last place.
BOOST_AUTO_TEST_CASE_TEMPLATE(values_and_directions_are_exact_to_the_last_digits_at_every_size, Shape, Shapes) {
  double worst = 0;
  for (double const scale : {1e-140, 1e-12, 1e-8, 1e-3, 1.0, 1e6, 1e140})
    for (int sample = 0; sample < 300; ++sample)
      for (auto const& values : kinds(scale)) {
        auto const a = with_principal<Shape>(values);
        worst = std::max(worst, defect(a, principal(a)));
      }
  BOOST_TEST_MESSAGE("worst defect " << worst << " units in the last place");
  BOOST_TEST(worst < 12);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_diagonal_tensor_keeps_its_axes, Shape, Shapes) {
  Symmetric<double, Shape> a = isotropic<Shape>(3.0);
  a[1] = -2.0;
  auto const p = principal(a);
  for (int k = 0; k < Shape::normals; ++k) {
    BOOST_TEST(p.values[static_cast<std::size_t>(k)] == a[k]);
    for (int i = 0; i < Shape::normals; ++i) BOOST_TEST(p.directions(i, k) == (i == k ? 1.0 : 0.0));
  }
  BOOST_TEST(defect(isotropic<Shape>(0.0), principal(isotropic<Shape>(0.0))) == 0.0);
}

BOOST_AUTO_TEST_CASE(the_direction_across_the_plane_stays_third) {
  Symmetric<double, shape::PlaneStrain> const a{{1.0, 2.0, 7.0, 0.5}};
  auto const p = principal(a);
  BOOST_TEST(p.values[2] == 7.0);
  BOOST_TEST(p.directions(2, 2) == 1.0);
  BOOST_TEST(p.directions(0, 2) == 0.0);
  BOOST_TEST(p.directions(2, 0) == 0.0);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_lane_has_the_bits_of_any_other_lane_and_the_digits_of_a_number, Shape, Shapes) {
  for (auto const& values : kinds(1e-3)) {
    auto const a = with_principal<Shape>(values);
    Symmetric<Lanes, Shape> packed;
    for (int e = 0; e < a.size; ++e) {
      packed[e] = Lanes(nan);
      packed[e].set(5, a[e]);
      packed[e].set(2, a[e]);
    }
    auto const alone = principal(a);
    auto const in_lanes = principal(packed);
    for (std::size_t k = 0; k < alone.values.size(); ++k) {
      BOOST_TEST(in_lanes.values[k][5] == in_lanes.values[k][2]);
      BOOST_TEST(std::abs(in_lanes.values[k][5] - alone.values[k]) < 8 * eps * 1e-3);
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(the_square_as_an_isotropic_function_is_the_square, Shape, Flat) {
  auto const square = [](auto const& x) { return x * x; };
  for (double const scale : {1e-8, 1.0})
    for (int sample = 0; sample < 100; ++sample)
      for (auto const& values : kinds(scale)) {
        auto const a = with_principal<Shape>(values);
        BOOST_TEST(distance(isotropic_function(a, square), squared(a)) <= 16 * eps * contract(a, a));
      }
}

BOOST_AUTO_TEST_CASE(across_the_plane_the_function_is_that_of_the_entry) {
  Symmetric<double, shape::PlaneStrain> const a{{0.3, -0.2, 0.7, 0.1}};
  auto const f = isotropic_function(a, [](auto const& x) { return exp(x); });
  auto const plane = isotropic_function(in_plane(a), [](auto const& x) { return exp(x); });
  BOOST_TEST(f[2] == std::exp(0.7), bt::tolerance(2 * eps));
  BOOST_TEST(distance(in_plane(f), plane) == 0.0);
}

// d(a^2) = da a + a da holds for duals of any tensor; the isotropic function must give the same through its principal
// values. 1e-12 is what Simpson's rule and the difference quotient leave where values are 1e-3 apart.
BOOST_AUTO_TEST_CASE_TEMPLATE(derivatives_exist_at_equal_principal_values, Shape, Flat) {
  using T = Dual<2>;
  auto const cube_of_root = [](auto const& x) { return sqrt(x * x * x); };
  for (int sample = 0; sample < 50; ++sample)
    for (auto values : kinds(0.3)) {
      for (double& v : values) v = 1.0 + 0.5 * v;
      auto const a = with_principal<Shape>(values);
      Symmetric<T, Shape> dual;
      for (int e = 0; e < a.size; ++e) {
        dual[e] = T(a[e]);
        dual[e].gradient = {uniform(), uniform()};
      }
      // f(a)^2 = a^3
      auto const f = squared(isotropic_function(dual, cube_of_root));
      auto const a2 = squared(dual);
      Symmetric<T, Shape> a3;
      for (int i = 0; i < Shape::plane; ++i)
        for (int j = i; j < Shape::plane; ++j)
          for (int k = 0; k < Shape::plane; ++k) a3(i, j) = a3(i, j) + a2(i, k) * dual(k, j);
      for (int e = 0; e < a.size; ++e) {
        BOOST_TEST(std::abs(f[e].value - a3[e].value) < 1e-14);
        for (int k = 0; k < 2; ++k) BOOST_TEST(std::abs(f[e].derivative(k) - a3[e].derivative(k)) < 1e-11);
      }
    }
}

BOOST_AUTO_TEST_SUITE_END()
