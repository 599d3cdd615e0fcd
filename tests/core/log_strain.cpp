#include "core/log_strain.hpp"

#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>
#include <random>

#include "tests/support/quadruple.hpp"

BOOST_AUTO_TEST_SUITE(log_strain)

using namespace talus;

namespace {

namespace bt = boost::test_tools;
using Flat = boost::mpl::list<shape::Plane, shape::Solid>;
using Shapes = boost::mpl::list<shape::Plane, shape::PlaneStrain, shape::Solid>;
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
std::mt19937 generator(5);

double uniform() {
  return std::uniform_real_distribution<double>(-1.0, 1.0)(generator);
}
template <class Shape>
Symmetric<double, Shape> random_strain(double size) {
  Symmetric<double, Shape> r;
  for (double& e : r.entries) e = size * uniform();
  return r;
}
template <int D>
Matrix<double, D> random_step(double size) {
  Matrix<double, D> r;
  for (double& e : r.entries) e = size * uniform();
  return r;
}

/// Principal strains of the given spread around zero: apart, nearly equal (1e-6, 1e-13), equal.
template <class Shape>
std::vector<Symmetric<double, Shape>> strains(double spread) {
  double const a = 0.5 * spread;
  std::vector<Symmetric<double, Shape>> r;
  for (std::array<double, 3> const values : {std::array{a, -a, a * uniform()},
                                             {a, -a, a * (1 + 1e-6)},
                                             {a * (1 + 1e-13), a, -a},
                                             {a, a, -a},
                                             {a, a, a},
                                             {-a, -a, -a}}) {
    Vector<double, Shape::normals> used;
    for (std::size_t k = 0; k < used.size(); ++k) used[k] = values[k];
    r.push_back(rebuild<double, Shape>(used, principal(random_strain<Shape>(1.0)).directions));
  }
  return r;
}

template <class Shape>
double error_of_step(Symmetric<double, Shape> const& strain, Matrix<double, Shape::plane> const& H) {
  return quadruple::error(trial_strain(strain, H), quadruple::trial_strain(strain, H));
}

/// The worst error over strains of a spread and steps a tenth of it (at most 0.03).
template <class Shape>
double worst_error(double spread, int samples) {
  double worst = 0;
  for (int sample = 0; sample < samples; ++sample)
    for (auto const& strain : strains<Shape>(spread))
      worst = std::max(worst, error_of_step(strain, random_step<Shape::plane>(std::min(0.1 * spread, 0.03))));
  BOOST_TEST_MESSAGE("spread " << spread << ": " << worst);
  return worst;
}

/// The tensor or matrix in one lane of packs that hold `fill` elsewhere.
template <class Packed, class Single>
Packed in_lane(int lane, Single const& a, double fill) {
  Packed r;
  for (std::size_t e = 0; e < r.entries.size(); ++e) {
    r.entries[e] = fill;
    r.entries[e].set(lane, a.entries[e]);
  }
  return r;
}

/// One copy of the code, so that equal lanes have equal bits.
template <class Shape>
[[gnu::noinline]] Symmetric<Lanes, Shape> packed_step(Symmetric<Lanes, Shape> const& strain,
                                                      Matrix<Lanes, Shape::plane> const& H) {
  return trial_strain(strain, H);
}

}  // namespace

// Rounding of the dozen operations of the last terms: a few units of 1.1e-16.
BOOST_AUTO_TEST_CASE_TEMPLATE(the_polynomials_keep_every_digit_however_small_the_strain, Shape, Flat) {
  for (double const spread : {1e-12, 1e-8, 1e-5, 1e-3, 1e-2, 0.05}) BOOST_TEST(worst_error<Shape>(spread, 20) < 1e-15);
}

// The bar of the design, 1e-14, which the loss e^(2 s) eps of s = 2 reaches: 55 x 2.2e-16.
BOOST_AUTO_TEST_CASE_TEMPLATE(principal_values_keep_fourteen_digits_up_to_a_spread_of_two, Shape, Flat) {
  for (double const spread : {0.1, 0.15, 0.3, 1.0, 1.5, 2.0}) BOOST_TEST(worst_error<Shape>(spread, 20) < 1e-14);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(beyond_it_the_loss_is_that_of_rounding_b, Shape, Flat) {
  for (double const spread : {3.0, 6.0, 9.0}) BOOST_TEST(worst_error<Shape>(spread, 10) < eps * std::exp(2 * spread));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(steps_as_large_as_the_body_are_exact, Shape, Flat) {
  for (double const size : {0.2, 0.5}) {
    double worst = 0;
    for (int sample = 0; sample < 30; ++sample) {
      auto H = random_step<Shape::plane>(size);
      for (int i = 0; i < Shape::plane; ++i) H(i, i) = H(i, i) + 0.3;  // away from det(I + H) = 0
      worst = std::max(worst, error_of_step(random_strain<Shape>(0.1), H));
    }
    BOOST_TEST(worst < 1e-13);  // b is then as badly conditioned as I + H
  }
}

// A series without its guard has lost digits at 0.6; with it, both sides of the limit are right.
BOOST_AUTO_TEST_CASE_TEMPLATE(the_guard_takes_over_where_the_polynomial_ends, Shape, Flat) {
  Matrix<double, Shape::plane> const no_step{};
  auto direction = random_strain<Shape>(1.0);
  direction = (1.0 / norm(direction)) * direction;
  auto const exact_log = [](Symmetric<double, Shape> const& x) {
    Matrix<double, Shape::plane> H;  // (I + H) I (I + H)^T = (I + x)^2
    for (int i = 0; i < Shape::plane; ++i)
      for (int j = 0; j < Shape::plane; ++j) H(i, j) = x(i, j);
    return quadruple::trial_strain(isotropic<Shape>(0.0), H);  // ln(I + x)
  };
  auto const of = [&direction](double size) { return size * direction; };
  for (double const side : {1 - 1e-9, 1 + 1e-9}) {
    auto const x = of(polynomial_limit * side);
    BOOST_TEST(quadruple::error(2.0 * talus::log_strain(x), exact_log(x)) < 2e-15);
    BOOST_TEST(error_of_step(0.5 * x, no_step) < 2e-15);  // expm1 of x, and its logarithm
  }
  auto const x = of(0.6);
  BOOST_TEST(quadruple::error(2.0 * detail::half_small_log1p(x), exact_log(x)) > 1e-13);
  BOOST_TEST(quadruple::error(2.0 * talus::log_strain(x), exact_log(x)) < 2e-15);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(log_strain_undoes_expm1_twice, Shape, Shapes) {
  for (double const size : {1e-12, 1e-3, 0.04, 0.2, 1.0})
    for (int sample = 0; sample < 50; ++sample) {
      auto const strain = random_strain<Shape>(size);
      BOOST_TEST(norm(talus::log_strain(expm1_twice(strain)) - strain) < 1e-14 * std::exp(4 * size) * norm(strain));
    }
}

BOOST_AUTO_TEST_CASE(across_the_plane_b_is_that_of_the_entry_and_a_step_leaves_the_strain) {
  for (double const zz : {1e-12, -0.03, 0.0499, 0.0501, -0.7}) {
    Symmetric<double, shape::PlaneStrain> const strain{{0.01, -0.02, zz, 0.005}};
    auto const H = random_step<2>(0.01);
    auto const after = trial_strain(strain, H), b = expm1_twice(strain);
    auto const after_in_plane = trial_strain(in_plane(strain), H), b_in_plane = expm1_twice(in_plane(strain));
    BOOST_TEST(after[2] == zz);
    BOOST_TEST(b[2] == std::expm1(2 * zz), bt::tolerance(4 * eps));
    BOOST_TEST(norm(in_plane(after) - after_in_plane) < 4 * eps * norm(after_in_plane));
    BOOST_TEST(norm(in_plane(b) - b_in_plane) < 4 * eps * norm(b_in_plane));
  }
}

BOOST_AUTO_TEST_CASE(a_rotation_turns_the_strain_and_strains_nothing) {
  double const angle = 0.7, c = std::cos(angle), s = std::sin(angle);
  Matrix<double, 2> const H{{c - 1, -s, s, c - 1}};
  BOOST_TEST(norm(trial_strain(isotropic<shape::Plane>(0.0), H)) < 4 * eps);
  for (double const size : {1e-2, 0.5}) {
    Symmetric<double, shape::Plane> const strain{{size, -0.4 * size, 0.0}};
    Symmetric<double, shape::Plane> const turned{
        {size * (c * c - 0.4 * s * s), size * (s * s - 0.4 * c * c), 1.4 * size * c * s}};
    BOOST_TEST(norm(trial_strain(strain, H) - turned) < 16 * eps);
  }
}

// Lanes on both sides of the guard, and a lane of NaN, in one pack.
BOOST_AUTO_TEST_CASE_TEMPLATE(every_lane_is_on_its_own, Shape, Shapes) {
  using Strains = Symmetric<Lanes, Shape>;
  using Steps = Matrix<Lanes, Shape::plane>;
  for (double const size : {1e-3, 0.04, 0.4}) {
    auto const strain = random_strain<Shape>(size);
    auto const H = random_step<Shape::plane>(0.1 * size);
    auto const alone = trial_strain(strain, H);
    auto const among_zeros = packed_step<Shape>(in_lane<Strains>(3, strain, 0.0), in_lane<Steps>(3, H, 0.0));
    for (double const other : {1e-4, 0.3, nan}) {
      auto const r = packed_step<Shape>(in_lane<Strains>(3, strain, other), in_lane<Steps>(3, H, 0.1 * other));
      for (int e = 0; e < alone.size; ++e) {
        BOOST_TEST(r[e][3] == among_zeros[e][3]);
        BOOST_TEST(std::abs(r[e][3] - alone[e]) < 16 * eps * size);
      }
      BOOST_TEST(std::isnan(r[0][2]) == std::isnan(other));
    }
  }
}

// ln b of F = I + t A: eps = t sym A + t^2/2 (A A^T - (A + A^T)^2/2) + ...
BOOST_AUTO_TEST_CASE_TEMPLATE(derivatives_exist_at_rest, Shape, Flat) {
  using T = Dual<1, Dual<1>>;
  constexpr int D = Shape::plane;
  auto const A = random_step<D>(1.0);
  T const t = T::variable(Dual<1>::variable(0.0, 0), 0);
  Matrix<T, D> H;
  for (std::size_t e = 0; e < H.entries.size(); ++e) H.entries[e] = t * A.entries[e];
  auto const r = trial_strain(isotropic<Shape>(T(0.0)), H);
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j) {
      double second = 0;
      for (int k = 0; k < D; ++k) second += A(i, k) * A(j, k) - 0.5 * (A(i, k) + A(k, i)) * (A(k, j) + A(j, k));
      BOOST_TEST(r(i, j).value.value == 0.0);
      BOOST_TEST(r(i, j).derivative(0).value == 0.5 * (A(i, j) + A(j, i)), bt::tolerance(4 * eps));
      BOOST_TEST(std::abs(r(i, j).derivative(0).derivative(0) - second) < 16 * eps);
    }
}

// The judge: central differences in quadruple precision, whose error is h^2 = 1e-20 and rounding 1e-30/h.
BOOST_AUTO_TEST_CASE_TEMPLATE(derivatives_are_exact_on_both_sides_of_the_guard_and_at_equal_stretches, Shape, Flat) {
  using T = Dual<1>;
  constexpr int D = Shape::plane;
  constexpr double h = 0x1p-34;  // a power of two, and entries of A and H of few bits: H + h A is exact
  for (double const spread : {1e-3, 0.05, 0.3, 1.0})
    for (auto const& strain : strains<Shape>(spread)) {
      Matrix<double, D> A, forward, backward;
      Matrix<T, D> H;
      Symmetric<T, Shape> lifted;
      for (std::size_t e = 0; e < A.entries.size(); ++e) {
        A.entries[e] = std::round(8 * uniform()) / 8;
        double const at = std::round(8 * uniform()) / 1024;
        forward.entries[e] = at + h * A.entries[e];
        backward.entries[e] = at - h * A.entries[e];
        H.entries[e] = T(at);
        H.entries[e].gradient[0] = A.entries[e];
      }
      for (int e = 0; e < strain.size; ++e) lifted[e] = T(strain[e]);
      auto const r = trial_strain(lifted, H);
      auto const slope = quadruple::combine<D>(0.5 / h, quadruple::trial_strain(strain, forward), -0.5 / h,
                                               quadruple::trial_strain(strain, backward));
      Symmetric<double, Shape> mine;
      for (int e = 0; e < mine.size; ++e) mine[e] = r[e].derivative(0);
      BOOST_TEST(quadruple::error(mine, slope) < 1e-12);
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(the_result_is_finite_while_b_is, Shape, Shapes) {
  for (double const size : {10.0, 18.0, 40.0, 80.0})
    for (int sample = 0; sample < 50; ++sample) {
      auto const r = trial_strain(random_strain<Shape>(size), random_step<Shape::plane>(0.3));
      for (double const e : r.entries) BOOST_TEST(std::isfinite(e));
    }
  // det(I + H) = 1e-30 and 0: the lowest strain there is, 1/2 ln 2^-53.
  for (double const remains : {1e-15, 0.0}) {
    Matrix<double, Shape::plane> H;
    for (int i = 0; i < Shape::plane; ++i) H(i, i) = remains - 1;
    BOOST_TEST(trial_strain(isotropic<Shape>(0.0), H)[0] == -26.5 * std::log(2.0), bt::tolerance(4 * eps));
  }
}

BOOST_AUTO_TEST_SUITE_END()
