/// Two integrators and a differential-algebraic one give the same paths of a material point.

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>

#include "verification/reference/cvode_path.hpp"
#include "verification/reference/gsl_path.hpp"
#include "verification/reference/ida_path.hpp"
#include "verification/suite/strain_paths.hpp"

BOOST_AUTO_TEST_SUITE(reference_integrators)

using namespace talus;
using namespace talus::reference;
using talus::reference::Matrix;
using verification::difference;
using verification::eighths;
using verification::glass;
using verification::soft;
using verification::StrainPath;
using verification::under_pressure;

namespace {

/// Of the largest of p_c, |p| and q. Measured: 4e-11, at a relative tolerance of 1e-13 of the strains in a step.
constexpr double agreement = 1e-9;

using Law = std::function<RateLaw(Elasticity const&, double beta)>;

RateLaw rate_independent(Elasticity const& e, double beta) {
  return cam_clay(e, {glass().mu_1, beta}, soft());
}
RateLaw mu_i(Elasticity const& e, double beta) {
  return cam_clay_mu_i(e, beta, soft(), glass());
}

/// CVODE against GSL on every path; what is plastic at the end must be flowing.
void compare(Law const& make, std::vector<StrainPath> const& paths, std::vector<double> const& betas) {
  for (double const beta : betas)
    for (auto const& path : paths) {
      auto const law = make(verification::elastic(path.normals), beta);
      auto const start = under_pressure(law.elastic, path.p);
      auto const times = eighths(path.path.front().duration);
      auto const rows = cvode_path(law, start, path.path, times);
      BOOST_TEST_CONTEXT(path.name << ", beta " << beta) {
        BOOST_TEST(rows.back().plastic);
        double const apart = difference(rows, gsl_path(law, start, path.path, times));
        BOOST_TEST(apart <= agreement);
        BOOST_TEST_MESSAGE(path.name << ", beta " << beta << ": " << apart);
      }
    }
}

MixedPath mixed(Path const& path) {
  MixedPath result;
  for (auto const& segment : path) result.push_back({segment.duration, segment.l, {}});
  return result;
}

/// Loaded in shear, unloaded by 3 Pa, loaded the other way: five phases.
Path back_and_forth() {
  auto const shear = velocity_gradient(5, -5, 0, 0);
  return {{1e-3, shear, 0}, {4e-4, -2e-3 * shear, 0}, {1e-3, velocity_gradient(-5, 4, 0, 0), 0}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(cvode_and_gsl_agree_on_rate_independent_cam_clay) {
  compare(&rate_independent, verification::strain_paths(0), {0, 0.1, 0.3});
}

BOOST_AUTO_TEST_CASE(cvode_and_gsl_agree_on_the_consistent_mu_of_I_law) {
  compare(&mu_i, verification::strain_paths(0.3), {0, 0.1, 0.3});
}

BOOST_AUTO_TEST_CASE(cvode_and_gsl_agree_on_the_other_viscous_cam_clay_laws) {
  auto const paths = verification::strain_paths(0.3);
  auto const perzyna = [](Elasticity const& e, double beta) {
    return cam_clay_perzyna(e, {0.4, beta}, soft(), {0.02, 0.7});
  };
  auto const duvaut_lions = [](Elasticity const& e, double beta) {
    return cam_clay_duvaut_lions(e, {0.4, beta}, soft(), {1e-5});
  };
  compare(perzyna, paths, {0.1});
  compare(duvaut_lions, paths, {0.1});
}

BOOST_AUTO_TEST_CASE(cvode_and_gsl_agree_on_cones) {
  auto const of = [](Cone const& surface, std::vector<StrainPath> const& paths) {
    compare([=](Elasticity const& e, double) { return cone(e, surface); }, paths, {0});
    compare([=](Elasticity const& e, double) { return cone_perzyna(e, surface, {0.02, 0.7}); }, paths, {0});
    compare([=](Elasticity const& e, double) { return cone_duvaut_lions(e, surface, {1e-5}); }, paths, {0});
  };
  auto paths = verification::strain_paths(0.1);
  of({0, 20}, paths);
  std::erase_if(paths, [](StrainPath const& path) {  // the one ends in the tip, the other stays elastic
    return path.name == "pure shear and extension" || path.name == "isotropic compression";
  });
  of({0.4, 5}, paths);
}

BOOST_AUTO_TEST_CASE(unloading_is_found_by_all) {
  for (auto const& make : {Law(&rate_independent), Law(&mu_i)}) {
    auto const law = make(verification::elastic(3), 0.1);
    auto const start = under_pressure(law.elastic, 60);
    std::vector<double> times;
    for (int k = 1; k <= 23; ++k) times.push_back(k * 1e-4);
    auto const rows = cvode_path(law, start, back_and_forth(), times);
    int changes = 0;
    for (std::size_t k = 1; k < rows.size(); ++k) changes += rows[k].plastic != rows[k - 1].plastic ? 1 : 0;
    BOOST_TEST(changes == 2);
    BOOST_TEST(!rows[11].plastic);
    BOOST_TEST(rows.back().plastic);
    BOOST_TEST(difference(rows, gsl_path(law, start, back_and_forth(), times)) <= agreement);
    BOOST_TEST(difference(rows, ida_path(law, start, mixed(back_and_forth()), times)) <= agreement);
  }
}

BOOST_AUTO_TEST_CASE(ida_equals_cvode_where_all_is_strain_controlled) {
  for (auto const& path : verification::strain_paths(0.1)) {
    if (path.path.front().turn != 0) continue;  // a mixed segment has fixed axes
    for (auto const& make : {Law(&rate_independent), Law(&mu_i)}) {
      auto const law = make(verification::elastic(path.normals), 0.1);
      auto const start = under_pressure(law.elastic, path.p);
      auto const times = eighths(path.path.front().duration);
      BOOST_TEST_CONTEXT(path.name) {
        auto const rows = ida_path(law, start, mixed(path.path), times);
        BOOST_TEST(difference(rows, cvode_path(law, start, path.path, times)) <= agreement);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(turning_axes_are_those_of_an_observer_who_turns) {
  // in a frame that turns with R(omega t), the gradient R l R^T is l - omega [0 -1; 1 0]
  auto const law = mu_i(verification::elastic(3), 0.1);
  double const omega = 200, time = 5e-3;
  Matrix const l = velocity_gradient(5, -4, -1, 3);
  Matrix seen = l;
  seen(0, 1) += omega;
  seen(1, 0) -= omega;
  auto const start = under_pressure(law.elastic, 60);
  auto const rows = cvode_path(law, start, {{time, l, omega}}, eighths(time));
  auto turned = cvode_path(law, start, {{time, seen, 0}}, eighths(time));
  for (auto& row : turned) {
    double const c = std::cos(omega * row.t), s = std::sin(omega * row.t);
    Matrix R;
    R << c, -s, 0, s, c, 0, 0, 0, 1;
    row.tau = R * row.tau * R.transpose();
  }
  BOOST_TEST(difference(rows, turned) <= agreement);
}

BOOST_AUTO_TEST_CASE(a_law_that_is_not_defined_stops_with_a_reason) {
  auto const viscous = mu_i(verification::elastic(2), 0), rigid = rate_independent(verification::elastic(2), 0);
  double const e = 100 / viscous.elastic.G();  // q = 100 Pa, above mu_2 S
  State start = under_pressure(viscous.elastic, 60);
  start.eps.diagonal() += Eigen::Vector3d(e / 2, -e / 2, 0);
  Path const path{{1e-3, velocity_gradient(5, -5, 0, 0), 0}};
  BOOST_CHECK_THROW((void)cvode_path(viscous, start, path, {1e-3}), std::runtime_error);
  BOOST_CHECK_THROW((void)gsl_path(viscous, start, path, {1e-3}), std::runtime_error);
  BOOST_CHECK_THROW((void)ida_path(viscous, start, mixed(path), {1e-3}), std::domain_error);
  BOOST_CHECK_THROW((void)cvode_path(rigid, start, path, {1e-3}), std::domain_error);
}

BOOST_AUTO_TEST_SUITE_END()
