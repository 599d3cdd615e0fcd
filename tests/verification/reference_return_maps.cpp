/// The maps in fifty digits: against recorded ones, against closed forms, and against the rate equations as the step
/// goes to 0.

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>

#include "verification/reference/closed_forms.hpp"
#include "verification/reference/cvode_path.hpp"
#include "verification/reference/return_maps.hpp"
#include "verification/suite/strain_paths.hpp"

BOOST_AUTO_TEST_SUITE(reference_return_maps)

using namespace talus;
using namespace talus::reference;
using boost::test_tools::tolerance;
using verification::elastic;
using verification::glass;
using verification::soft;

namespace {

StressOf<Digits> wide(StressOf<double> const& s) {
  return {s.p, s.q, s.eps_V};
}

struct Recorded {
  StressOf<double> trial;
  double beta, p, q_y, eps_V, q;
  double p_3, q_y_3;  // K = 833333.3333
};
/// PHYSICS 2.6 of the project's notes: a bisection of 12 digits in another language, E = 1e6, nu = 0.3, xi = 50,
/// p_c0 = 100, glass beads with Q = 2.232, dt = 2.5e-5.
std::vector<Recorded> const recorded{
    {{60, 80, 0}, 0, 54.6179893, 19.01739554, -5.597291123e-06, 22.48452933, 54.97283679, 19.0048407},
    {{60, 80, 0}, 0.2, 50.38789612, 22.57874526, -9.996588035e-06, 26.14013407, 51.08471822, 22.53138644},
    {{20, 60, 0}, 0, 33.74539881, 18.04631073, 1.429521477e-05, 20.99263913, 32.76530011, 17.91281439},
    {{20, 60, 0}, 0.3, 25.17448807, 24.52966271, 5.38146759e-06, 27.38406617, 24.70705513, 24.50141442},
    {{-10, 30, 0}, 0, 11.16007734, 12.01644912, 2.200648044e-05, 13.55256577, 10.15157217, 11.52489793},
    {{-10, 30, 0}, 0.3, -3.143613226, 20.09050472, 7.130642245e-06, 21.10946143, -3.790223054, 19.9088766},
    {{500, 10, 0}, 0, 102.0773522, 0.4466371668, -4.138395537e-04, 0.4595326699, 102.4040243, 0.3909221822},
    {{500, 400, -0.02}, 0.1, 220.5676861, 44.70813378, -0.02029060961, 60.06435838, 227.3636714, 42.66180405},
    {{0.5, 5, 0.1}, 0, 0.3479118886, 0.1285808647, 0.09999984183, 0.1529705751, 0.3494738291, 0.1285601237},
    {{50, 100, 0}, 0, 50, 19.09314337, 0, 23.47784216, 50, 19.09314337},
    {{-40, 5, 0}, 0.3, -29.35606466, 3.439203045, 1.106969276e-05, 3.616530032, -29.40776444, 3.287946967},
    {{2000, 1500, -0.06}, 0, 1477.291224, 355.4786468, -0.06054361713, 489.5547344, 1508.953692, 350.9188765},
};

/// Coaxial shear at the rate `shear` [1/s] with the rate of volume `volume` [1/s] for `time` [s], from isotropic p_0.
struct Course {
  double p_0, shear, volume, time;
};

/// In n steps of a map.
template <class Map>
StressOf<double> stepped(Elasticity const& e, Course const& c, int n, Map map) {
  double const dt = c.time / n;
  StressOf<double> s{c.p_0, 0, 0};
  for (int k = 0; k < n; ++k)
    s = map(StressOf<double>{s.p - e.K() * c.volume * dt, s.q + e.G() * c.shear * dt, s.eps_V}, dt);
  return s;
}

/// The rate equations, to whose end the steps tend: error(n)/error(2 n) -> 2.
template <class Map>
void tends_to_first_order(std::string const& name, RateLaw const& law, Course const& c, Map map) {
  double const v = c.volume / law.elastic.normals, s = 0.5 * c.shear;
  Path const path{{c.time, velocity_gradient(v + s, v - s, law.elastic.normals == 3 ? v : 0, 0), 0}};
  auto const exact = cvode_path(law, verification::under_pressure(law.elastic, c.p_0), path, {c.time}).front();
  auto const error = [&](int n) {
    auto const end = stepped(law.elastic, c, n, map);
    return std::hypot(end.p - exact.p, end.q - exact.q) / exact.p_c;
  };
  double const coarse = error(1600), fine = error(3200), order = std::log2(coarse / fine);
  BOOST_TEST_MESSAGE(name << ": error " << fine << ", order " << order);
  BOOST_TEST_CONTEXT(name) {
    BOOST_TEST(exact.plastic);
    BOOST_TEST(fine < 1e-2);
    BOOST_TEST(order == 1.0, tolerance(0.03));
  }
}

/// So short that the stress is still on its way.
constexpr Course compacts{60, 10, -3, 4e-5}, dilates{60, 10, 1, 4e-5};

}  // namespace

BOOST_AUTO_TEST_CASE(recorded_steps_are_met) {
  constexpr double printed = 1e-9;  // ten digits
  for (auto const& r : recorded) {
    auto const trial = wide(r.trial);
    CamClay const law{elastic(2), {glass().mu_1, r.beta}, soft(), implicit_hardening};
    auto const projected = cam_clay_projection(law, trial), viscous = cam_clay_two_stage(law, glass(), trial, 2.5e-5);
    BOOST_TEST_CONTEXT("p_tr " << r.trial.p << ", q_tr " << r.trial.q << ", beta " << r.beta) {
      BOOST_TEST(static_cast<double>(projected.p) == r.p, tolerance(printed));
      BOOST_TEST(static_cast<double>(projected.q) == r.q_y, tolerance(printed));
      BOOST_TEST(static_cast<double>(projected.eps_V) == r.eps_V, tolerance(printed));
      BOOST_TEST(static_cast<double>(viscous.q) == r.q, tolerance(printed));
      auto const space = cam_clay_projection(CamClay{elastic(3), law.surface, soft(), implicit_hardening}, trial);
      BOOST_TEST(static_cast<double>(space.p) == r.p_3, tolerance(printed));
      BOOST_TEST(static_cast<double>(space.q) == r.q_y_3, tolerance(printed));
    }
  }
}

BOOST_AUTO_TEST_CASE(doubles_keep_eleven_of_the_fifty_digits) {
  for (auto const& r : recorded)
    for (Hardening const& hardening :
         {Hardening(ConstantStrength{100}), Hardening(soft()), Hardening(HyperbolicSineStrength{100, 0.01})})
      for (bool const is_implicit : {implicit_hardening, explicit_hardening}) {
        CamClay const law{elastic(2), {glass().mu_1, r.beta}, hardening, is_implicit};
        auto const same = [&](auto map) {
          auto const a = map(r.trial);
          auto const b = map(wide(r.trial));
          double const size =
              std::max({strength<double>(hardening, r.trial.eps_V, law.elastic.K()), std::abs(a.p), a.q});
          BOOST_TEST(std::abs(a.p - static_cast<double>(b.p)) <= 1e-11 * size);
          BOOST_TEST(std::abs(a.q - static_cast<double>(b.q)) <= 1e-11 * size);
        };
        same([&](auto const& trial) { return cam_clay_projection(law, trial); });
        same([&](auto const& trial) { return cam_clay_two_stage(law, glass(), trial, 2.5e-5); });
        same([&](auto const& trial) { return cam_clay_two_stage(law, Perzyna{0.02, 0.7}, trial, 2.5e-5); });
        same([&](auto const& trial) { return cam_clay_duvaut_lions(law, DuvautLions{1e-5}, trial, 2.5e-5); });
        same([&](auto const& trial) { return cam_clay_consistent(law, glass(), trial, 2.5e-5); });
      }
}

BOOST_AUTO_TEST_CASE(an_implicit_step_of_isotropic_compression_is_exact) {
  for (double const eps_v : {1e-3, 0.02, 0.08}) {
    CamClay const law{elastic(3), {0.4, 0.2}, soft(), implicit_hardening};
    double const K = law.elastic.K();
    auto const end = cam_clay_projection(law, StressOf<Digits>{K * eps_v, 0, 0});
    BOOST_TEST(static_cast<double>(end.p) == isotropic_compression(K, soft(), eps_v), tolerance(1e-13));
  }
}

BOOST_AUTO_TEST_CASE(a_projection_is_on_the_surface_along_its_normal) {
  for (auto const& r : recorded)
    for (bool const is_implicit : {implicit_hardening, explicit_hardening}) {
      CamClay const law{elastic(3), {0.5, r.beta}, HyperbolicSineStrength{100, 0.01}, is_implicit};
      Digits const K = law.elastic.K(), G = law.elastic.G(), beta = r.beta;
      auto const trial = wide(r.trial);
      auto const m = cam_clay_projection(law, trial);
      Digits const p_c = strength<Digits>(law.hardening, is_implicit ? m.eps_V : trial.eps_V, law.elastic.K());
      Digits const y = m.q * m.q - 0.25 * (p_c - m.p) * (m.p + beta * p_c), y_p = 0.25 * (2 * m.p - (1 - beta) * p_c);
      BOOST_TEST(static_cast<double>(abs(y) / (p_c * p_c)) < 1e-30);
      // plastic strains: (p - p_tr)/K of volume, (q_tr - q)/G of shear; their ratio is -y_p to y_q
      Digits const across = (m.p - trial.p) / K * 2 * m.q + (trial.q - m.q) / G * y_p;
      BOOST_TEST(static_cast<double>(abs(across) * G / (p_c * p_c)) < 1e-25);
    }
}

BOOST_AUTO_TEST_CASE(viscous_steps_satisfy_the_laws_they_discretise) {
  double const dt = 2.5e-5;
  auto const m = glass();
  Perzyna const v{0.02, 0.7};
  for (auto const& r : recorded)
    for (auto const& e : {elastic(2), elastic(3)}) {
      CamClay const law{e, {m.mu_1, r.beta}, soft(), implicit_hardening};
      auto const trial = wide(r.trial);
      auto const on_dynamic_ellipse = [&](StressOf<Digits> const& end, auto rate, bool consistent) {
        Digits const p_c = strength<Digits>(law.hardening, end.eps_V, e.K()), P = end.p + r.beta * p_c;
        Digits const S = sqrt(Digits((p_c - end.p) * P)), mu = end.q / S, gamma_dt = (trial.q - end.q) / e.G();
        Digits const volume = gamma_dt * mu * ((1 - Digits(r.beta)) * p_c - 2 * end.p) / (2 * S);
        BOOST_TEST(static_cast<double>(abs(rate(mu, P) * dt / gamma_dt - 1)) < 1e-25);
        BOOST_TEST(static_cast<double>(abs(end.eps_V - trial.eps_V - (end.p - trial.p) / e.K())) < 1e-40);
        if (consistent) BOOST_TEST(static_cast<double>(abs(volume - (end.eps_V - trial.eps_V)) / gamma_dt) < 1e-25);
      };
      auto const mu_i = [&](Digits const& mu, Digits const& P) {
        return Digits(m.Q() * sqrt(P) * (mu - m.mu_1) / (m.mu_2 - mu));
      };
      auto const perzyna = [&](Digits const& mu, Digits const&) {
        return Digits((pow(Digits(mu / m.mu_1), Digits(1 / Digits(v.s))) - 1) / v.t_v);
      };
      on_dynamic_ellipse(cam_clay_consistent(law, m, trial, dt), mu_i, true);
      on_dynamic_ellipse(cam_clay_consistent(law, v, trial, dt), perzyna, true);
      on_dynamic_ellipse(cam_clay_two_stage(law, m, trial, dt), mu_i, false);
      on_dynamic_ellipse(cam_clay_two_stage(law, v, trial, dt), perzyna, false);
    }
}

BOOST_AUTO_TEST_CASE(viscosity_vanishes_in_its_limits) {
  for (auto const& r : recorded) {
    CamClay const law{elastic(2), {glass().mu_1, r.beta}, soft(), implicit_hardening};
    auto const trial = wide(r.trial);
    auto const projected = cam_clay_projection(law, trial);
    auto const meets = [&](StressOf<Digits> const& end) {
      BOOST_TEST(static_cast<double>(abs(end.p - projected.p)) <= 1e-9 * 100);
      BOOST_TEST(static_cast<double>(abs(end.q - projected.q)) <= 1e-9 * 100);
    };
    auto slippery = glass();
    slippery.mu_2 = slippery.mu_1;
    meets(cam_clay_two_stage(law, slippery, trial, 1));
    meets(cam_clay_consistent(law, slippery, trial, 1));
    meets(cam_clay_two_stage(law, Perzyna{1e-15, 1}, trial, 1e-3));
    meets(cam_clay_consistent(law, Perzyna{1e-15, 1}, trial, 1e-3));
    meets(cam_clay_duvaut_lions(law, DuvautLions{1e-18}, trial, 1e-3));
  }
}

BOOST_AUTO_TEST_CASE(steps_of_cam_clay_tend_to_its_rate_equations) {
  auto const e = elastic(3);
  Ellipse const ellipse{glass().mu_1, 0.1};
  for (auto const& course : {compacts, dilates})
    for (Hardening const& hardening : {Hardening(soft()), Hardening(HyperbolicSineStrength{100, 0.01})})
      for (bool const is_implicit : {implicit_hardening, explicit_hardening}) {
        CamClay const law{e, ellipse, hardening, is_implicit};
        tends_to_first_order("Cam-Clay", cam_clay(e, ellipse, hardening), course,
                             [&](StressOf<double> const& s, double) { return cam_clay_projection(law, s); });
      }
}

BOOST_AUTO_TEST_CASE(consistent_viscous_steps_tend_to_the_rate_equations) {
  auto const e = elastic(2);
  Ellipse const ellipse{glass().mu_1, 0.1};
  CamClay const law{e, ellipse, soft(), implicit_hardening};
  Perzyna const perzyna{0.02, 0.7};
  DuvautLions const duvaut_lions{1e-5};
  for (auto const& course : {compacts, dilates}) {
    tends_to_first_order("mu(I)", cam_clay_mu_i(e, 0.1, soft(), glass()), course,
                         [&](auto const& s, double dt) { return cam_clay_consistent(law, glass(), s, dt); });
    tends_to_first_order("Perzyna", cam_clay_perzyna(e, ellipse, soft(), perzyna), course,
                         [&](auto const& s, double dt) { return cam_clay_consistent(law, perzyna, s, dt); });
    tends_to_first_order("Duvaut-Lions", cam_clay_duvaut_lions(e, ellipse, soft(), duvaut_lions), course,
                         [&](auto const& s, double dt) { return cam_clay_duvaut_lions(law, duvaut_lions, s, dt); });
  }
}

BOOST_AUTO_TEST_CASE(steps_on_a_cone_tend_to_the_rate_equations) {
  auto const e = elastic(3);
  Perzyna const perzyna{0.02, 0.7};
  DuvautLions const duvaut_lions{1e-5};
  Course const course{60, 10, -1e-3, 2e-5};
  Cone const surface{0.4, 5};
  tends_to_first_order("Perzyna", cone_perzyna(e, surface, perzyna), course,
                       [&](auto const& s, double dt) { return cone_step(e, surface, perzyna, s, dt); });
  tends_to_first_order("Duvaut-Lions", cone_duvaut_lions(e, surface, duvaut_lions), course,
                       [&](auto const& s, double dt) { return cone_step(e, surface, duvaut_lions, s, dt); });
  auto const end = stepped(e, course, 10, [&](auto const& s, double) { return cone_step(e, surface, s); });
  Path const path{{course.time, velocity_gradient(5 - 1e-3 / 3, -5 - 1e-3 / 3, -1e-3 / 3, 0), 0}};
  auto const exact = cvode_path(cone(e, surface), verification::under_pressure(e, 60), path, {course.time}).front();
  BOOST_TEST(end.q == exact.q, tolerance(1e-9));  // without viscosity a step is exact
  BOOST_TEST(end.q == surface.M * end.p + surface.c, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(two_stages_end_in_the_same_steady_state) {
  auto const e = elastic(2);
  CamClay const law{e, {glass().mu_1, 0.1}, soft(), implicit_hardening};
  Course const shear{60, 10, 0, 0.01};
  auto const consistent = [&](auto const& s, double dt) { return cam_clay_consistent(law, glass(), s, dt); };
  auto const staged = [&](auto const& s, double dt) { return cam_clay_two_stage(law, glass(), s, dt); };
  auto const one = stepped(e, shear, 800, consistent), two = stepped(e, shear, 800, staged);
  double const p = constant_volume_critical_state(e.K(), law.surface, soft(), 60).p;
  for (auto const& end : {one, two}) {
    BOOST_TEST(end.p == p, tolerance(1e-11));
    BOOST_TEST(end.q == critical_friction(glass(), 0.1, p, 10) * p, tolerance(1e-11));
  }
}

BOOST_AUTO_TEST_SUITE_END()
