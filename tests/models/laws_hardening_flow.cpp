/// The flow rule of the reference computations: twelve stresses that the authors' solver of 2023 returned.
#include "models/laws/cam_clay_hardening_flow.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

BOOST_AUTO_TEST_SUITE(laws_hardening_flow)

namespace {

using namespace talus;

/// p_tr, q_tr [Pa], eps_V^P, beta, and the pressure that came back, in reduced plane strain with E = 1 MPa, nu = 0.3,
/// xi = 50, p_c0 = 100 Pa, mu_1 = tan 20.9. Source: the solver of Blatny, Gray & Gaume (2024), version of 2023, run for
/// these states; printed to six digits, of which its tolerance (1e-3 Pa^2 on the yield function) leaves about five.
struct Returned {
  double p_tr, q_tr, eps_V, beta, p;
};
constexpr Returned returned[] = {
    {60, 80, 0, 0, 54.5421},   {60, 80, 0, 0.2, 50.3875},       {20, 60, 0, 0, 33.7081},
    {20, 60, 0, 0.3, 25.2119}, {-10, 30, 0, 0, 11.1547},        {-10, 30, 0, 0.3, -3.1238},
    {500, 10, 0, 0, 102.0772}, {500, 400, -0.02, 0.1, 220.086}, {0.5, 5, 0.1, 0, 0.347906},
    {50, 100, 0, 0, 49.9213},  {-40, 5, 0, 0.3, -29.3548},      {2000, 1500, -0.06, 0, 1443.08}};

}  // namespace

BOOST_AUTO_TEST_CASE(the_pressures_are_those_that_the_reference_solver_returned) {
  for (Returned const& state : returned) {
    law::CamClayMuIHardeningFlow::Parameters p;
    p.mu_1 = std::tan(20.9 * std::numbers::pi / 180);
    p.beta = state.beta;
    p.xi = 50;
    p.p_c0 = 100;
    law::CamClayMuIHardeningFlow const law(p);
    double const K = law.bulk<shape::Plane>(), G = law.G;
    Symmetric<double, shape::Plane> trial;
    trial[0] = trial[1] = -state.p_tr / (2 * K);
    trial[2] = state.q_tr / (2 * G);
    Record<double, law::CamClayMuIHardeningFlow::State> record{{state.eps_V}};
    auto const eps = law.project(trial, record, 2.5e-5);
    BOOST_TEST_CONTEXT("p_tr " << state.p_tr << ", q_tr " << state.q_tr << ", beta " << state.beta) {
      BOOST_TEST(pressure(law.stress(eps)) == state.p, boost::test_tools::tolerance(2e-5));
    }
  }
}

BOOST_AUTO_TEST_CASE(volume_stays_where_the_pressure_is_the_strength_over_two_plus_s) {
  law::CamClayMuIHardeningFlow::Parameters p;
  p.xi = 50;
  p.p_c0 = 2000;
  law::CamClayMuIHardeningFlow const law(p);
  double const K = law.bulk<shape::Plane>(), s = p.xi * p.p_c0 / K, p_critical = p.p_c0 / (2 + s);
  Symmetric<double, shape::Plane> trial;
  trial[0] = trial[1] = -p_critical / (2 * K);
  trial[2] = 3 * p_critical / (2 * law.G);
  Record<double, law::CamClayMuIHardeningFlow::State> record{{0.0}};
  auto const eps = law.project(trial, record, 1.0);
  BOOST_TEST(pressure(law.stress(eps)) == p_critical, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(std::abs(record.values[0]) < 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()
