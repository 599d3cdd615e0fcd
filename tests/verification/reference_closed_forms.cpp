/// The integrated paths meet solutions in closed form.

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "verification/reference/closed_forms.hpp"
#include "verification/reference/cvode_path.hpp"
#include "verification/reference/ida_path.hpp"
#include "verification/suite/strain_paths.hpp"

BOOST_AUTO_TEST_SUITE(reference_closed_forms)

using namespace talus;
using namespace talus::reference;
using boost::test_tools::tolerance;
using verification::eighths;
using verification::elastic;
using verification::glass;
using verification::soft;
using verification::under_pressure;

namespace {

constexpr double accuracy = 1e-9;  ///< relative, of a stress

/// The state of pressure p and of shear stress q along x (stretched) and y.
State sheared(Elasticity const& e, double p, double q) {
  State state = under_pressure(e, p);
  state.eps.diagonal() += Eigen::Vector3d(1, -1, 0) * (q / (2 * e.G()));
  return state;
}

/// Shear at that rate along the same axes.
Path pure_shear(double rate, double duration) {
  return {{duration, velocity_gradient(rate / 2, -rate / 2, 0, 0), 0}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(isotropic_compression_is_a_lambert_function) {
  // the value of VERIFICATION 2.3 of the project's notes, computed there independently
  BOOST_TEST(isotropic_compression(8.333e5, {100, 50}, 0.08) == 4234.734631528, tolerance(1e-10));
  for (double const beta : {0.0, 0.3}) {
    auto const law = cam_clay(elastic(3), {0.4, beta}, soft());
    double const K = law.elastic.K();
    Path const path{{5e-3, velocity_gradient(-10, -10, -10, 0), 0}};
    for (auto const& row : cvode_path(law, under_pressure(law.elastic, 90), path, eighths(5e-3))) {
      BOOST_TEST(row.plastic);
      BOOST_TEST(row.p == isotropic_compression(K, soft(), 90 / K + 30 * row.t), tolerance(accuracy));
    }
  }
}

BOOST_AUTO_TEST_CASE(shear_at_constant_volume_ends_at_the_critical_state) {
  for (double const beta : {0.0, 0.1, 0.3})
    for (double const p_i : {20.0, 60.0, 90.0})
      for (int const normals : {2, 3}) {
        auto const e = elastic(normals);
        Ellipse const ellipse{glass().mu_1, beta};
        auto const path = pure_shear(10, 0.05);
        auto const end = constant_volume_critical_state(e.K(), ellipse, soft(), p_i);
        auto const slow = cvode_path(cam_clay(e, ellipse, soft()), sheared(e, p_i, 1), path, {0.05}).front();
        BOOST_TEST(slow.p == end.p, tolerance(accuracy));
        BOOST_TEST(slow.q == end.q, tolerance(accuracy));
        auto const fast = cvode_path(cam_clay_mu_i(e, beta, soft(), glass()), sheared(e, p_i, 1), path, {0.05}).front();
        BOOST_TEST(fast.p == end.p, tolerance(accuracy));
        BOOST_TEST(fast.q == critical_friction(glass(), beta, end.p, 10) * end.p, tolerance(accuracy));
      }
}

BOOST_AUTO_TEST_CASE(recorded_critical_pressure_is_met) {
  // VERIFICATION 2.3 of the project's notes, K = 8.333e5 Pa
  auto const end = constant_volume_critical_state(8.333e5, {0.4, 0}, soft(), 60);
  BOOST_TEST(end.p == 50.029920384, tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(start_up_of_mu_of_I_shear) {
  for (double const beta : {0.0, 0.2})
    for (double const rate : {1.0, 20.0, 500.0}) {
      auto const law = cam_clay_mu_i(elastic(2), beta, soft(), glass());
      double const p_c = 100, p = (1 - beta) / 2 * p_c, S = (1 + beta) / 2 * p_c;
      MuIStartUp const exact{glass(), law.elastic.G(), S, S, rate};
      double const half = exact.time(0.5 * (glass().mu_1 + exact.limit()));
      BOOST_TEST(exact.friction(half) == 0.5 * (glass().mu_1 + exact.limit()), tolerance(1e-12));
      auto const start = sheared(law.elastic, p, glass().mu_1 * S);
      for (auto const& row : cvode_path(law, start, pure_shear(rate, 8 * half), eighths(8 * half))) {
        BOOST_TEST(row.p == p, tolerance(accuracy));
        BOOST_TEST(row.q == S * exact.friction(row.t), tolerance(accuracy));
        double const x = exact.friction(row.t), left = (exact.limit() - x) / (exact.limit() - glass().mu_1);
        if (left > 1e-3) BOOST_TEST(exact.time(x) == row.t, tolerance(1e-11));  // later ln(x_inf - x) loses digits
      }
    }
}

BOOST_AUTO_TEST_CASE(linear_viscous_stress_rises_and_relaxes) {
  double const q_y = 20, t_v = 0.05;
  auto const e = elastic(3);
  Cone const von_mises{0, q_y};
  auto const meets = [&](RateLaw const& law, double eta) {
    double const time = eta / e.G();
    for (double const rate : {0.0, 20.0})
      for (auto const& row : cvode_path(law, sheared(e, 50, 1.5 * q_y), pure_shear(rate, 4 * time), eighths(4 * time)))
        BOOST_TEST(row.q == linear_viscous_stress(e.G(), q_y, eta, 1.5 * q_y, rate, row.t), tolerance(accuracy));
  };
  meets(cone_perzyna(e, von_mises, {t_v, 1}), q_y * t_v);
  meets(cone_duvaut_lions(e, von_mises, {1e-5}), e.G() * 1e-5);
}

BOOST_AUTO_TEST_CASE(friction_at_critical_state_as_recorded) {
  // q/p of PHYSICS 2.4 of the project's notes: an earlier driver of the law in another language
  for (auto const& [beta, friction] : {std::pair{0.1, 0.60985957}, {0.2, 0.73859020}, {0.3, 0.90190194}})
    BOOST_TEST(critical_friction(glass(), beta, 100, 20) == friction, tolerance(1e-7));
}

BOOST_AUTO_TEST_CASE(direct_shear_ends_at_mu_of_I_and_the_critical_volume) {
  for (double const p_c0 : {400.0, 140.0})  // dilates, compacts
    for (int const normals : {2, 3})
      for (double const rate : {20.0, -20.0}) {
        double const sigma_n = 100;
        ExponentialStrength const strength{p_c0, 100};
        auto const e = elastic(normals);
        auto const law = cam_clay_mu_i(e, 0, strength, glass());
        auto const rows = ida_path(law, under_pressure(e, sigma_n), direct_shear(rate, 0.06), eighths(0.06));
        for (auto const& row : rows) BOOST_TEST(row.tau(1, 1) == -sigma_n, tolerance(accuracy));
        auto const& end = rows.back();
        auto const exact = steady_direct_shear(e.G(), glass(), strength, sigma_n, std::abs(rate));
        BOOST_TEST(end.p == exact.p, tolerance(accuracy));
        BOOST_TEST(std::abs(end.tau(0, 1)) == exact.tau_xy, tolerance(accuracy));
        BOOST_TEST(end.gamma == exact.gamma, tolerance(accuracy));
        BOOST_TEST(end.tau(0, 1) * rate > 0);
        BOOST_TEST(std::abs(end.state.eps_V - exact.eps_V) * strength.xi <= accuracy);  // of p_c, relative
        // without the rotation by finite elastic strain, which changes p by q^2/(G p)
        double const small = end.q / e.G();
        BOOST_TEST(std::abs(end.tau(0, 1)) == critical_friction(glass(), 0, sigma_n, std::abs(rate)) * sigma_n,
                   tolerance(small));
        BOOST_TEST(std::abs(end.state.eps_V - std::log(p_c0 / (2 * sigma_n)) / strength.xi) <= small / strength.xi);
        BOOST_TEST((end.state.eps_V > 0) == (p_c0 > 2 * sigma_n));
      }
}

BOOST_AUTO_TEST_CASE(triaxial_compression_ends_on_the_critical_state_line) {
  // tau_yy - tau_xx = sqrt(3) q and p = p_r + q/sqrt(3), so q = M omega p gives p = p_r/(1 - M omega/sqrt(3))
  double const p_r = 60, M = 0.4, beta = 0.1, omega = 1.1 / 0.9;
  auto const law = cam_clay(elastic(3), {M, beta}, ExponentialStrength{100, 100});
  auto const rows = ida_path(law, under_pressure(law.elastic, p_r), triaxial_compression(10, 0.12), eighths(0.12));
  for (auto const& row : rows) {
    BOOST_TEST(row.tau(0, 0) == -p_r, tolerance(accuracy));
    BOOST_TEST(row.tau(2, 2) == -p_r, tolerance(accuracy));
  }
  double const p = p_r / (1 - M * omega / std::numbers::sqrt3);
  BOOST_TEST(rows.back().p == p, tolerance(accuracy));
  BOOST_TEST(rows.back().q == M * omega * p, tolerance(accuracy));
}

BOOST_AUTO_TEST_SUITE_END()
