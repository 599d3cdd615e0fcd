#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "core/dual.hpp"
#include "models/laws/cam_clay_mu_i.hpp"
#include "models/laws/modified_cam_clay.hpp"
#include "tests/support/exact_cam_clay.hpp"
#include "tests/support/law_states.hpp"

BOOST_AUTO_TEST_SUITE(laws_vectors)

using namespace talus;
using support::Real;
using support::tan_deg;

namespace {

/// One step of E = 1 MPa, nu = 0.3, xi = 50, p_c0 = 100 Pa, mu_1 = tan 20.9 deg, mu_2 = tan 32.76 deg,
/// I_0/(d sqrt(rho_s)) = 2.232, dt = 2.5e-5 s: trial p, q, eps_V^P, and beta.
struct Step {
  double p_tr, q_tr, eps_V, beta;
};
/// Reduced plane strain: p, q_y, eps_V^P, p_c, and with viscosity q and the shear rate.
struct Plane {
  double p, q_y, eps_V, p_c, q, rate;
};
/// d_s = 3: p, q_y.
struct Solid {
  double p, q_y;
};
struct Vector {
  Step step;
  Plane plane;
  Solid solid;
};

constexpr double dt = 2.5e-5;

// Ten digits of a bisection with the equations of CamClayMap and MuI, made before this code was written and without it.
constexpr std::array<Vector, 12> vectors{{
    {{60, 80, 0, 0},
     {54.6179893, 19.01739554, -5.597291123e-06, 100.0279904, 22.48452933, 5.981608949},
     {54.97283679, 19.0048407}},
    {{60, 80, 0, 0.2},
     {50.38789612, 22.57874526, -9.996588035e-06, 100.0499954, 26.14013407, 5.601426057},
     {51.08471822, 22.53138644}},
    {{20, 60, 0, 0},
     {33.74539881, 18.04631073, 1.429521477e-05, 99.92854946, 20.99263913, 4.056765531},
     {32.76530011, 17.91281439}},
    {{20, 60, 0, 0.3},
     {25.17448807, 24.52966271, 5.38146759e-06, 99.97309628, 27.38406617, 3.392057119},
     {24.70705513, 24.50141442}},
    {{-10, 30, 0, 0},
     {11.16007734, 12.01644912, 2.200648044e-05, 99.89002811, 13.55256577, 1.71053316},
     {10.15157217, 11.52489793}},
    {{-10, 30, 0, 0.3},
     {-3.143613226, 20.09050472, 7.130642245e-06, 99.96435314, 21.10946143, 0.9246160113},
     {-3.790223054, 19.9088766}},
    {{500, 10, 0, 0},
     {102.0773522, 0.4466371668, -4.138395537e-04, 102.0907541, 0.4595326699, 0.9922086023},
     {102.4040243, 0.3909221822}},
    {{500, 400, -0.02, 0.1},
     {220.5676861, 44.70813378, -0.02029060961, 275.8068126, 60.06435838, 35.35330673},
     {227.3636714, 42.66180405}},
    {{0.5, 5, 0.1, 0},
     {0.3479118886, 0.1285808647, 0.09999984183, 0.6738000287, 0.1529705751, 0.5040910602},
     {0.3494738291, 0.1285601237}},
    {{50, 100, 0, 0}, {50, 19.09314337, 0, 100, 23.47784216, 7.958304415}, {50, 19.09314337}},
    {{-40, 5, 0, 0.3},
     {-29.35606466, 3.439203045, 1.106969276e-05, 99.94466685, 3.616530032, 0.1438808767},
     {-29.40776444, 3.287946967}},
    {{2000, 1500, -0.06, 0},
     {1477.291224, 355.4786468, -0.06054361713, 2063.896629, 489.5547344, 105.0863076},
     {1508.953692, 350.9188765}},
}};

law::CamClayMuI::Parameters mu_i(double beta) {
  law::CamClayMuI::Parameters p;
  p.mu_1 = tan_deg(20.9);
  p.mu_2 = tan_deg(32.76);
  p.beta = beta;
  return p;
}
law::CamClay::Parameters rate_independent(double beta) {
  law::CamClay::Parameters p;
  p.M = tan_deg(20.9);
  p.beta = beta;
  return p;
}

/// What a law makes of a step: p, q and the fields it derives.
template <class Shape, class L, class T>
struct Outcome {
  T p, q;
  Record<T, typename L::State> state{};
  Record<T, typename L::Derived> derived;

  Outcome(L const& law, Symmetric<T, Shape> const& trial, T eps_V) {
    state[field::plastic_volumetric_strain] = eps_V;
    auto const eps = law.project(trial, state, T(dt));
    auto const [pressure, shear] = invariants(law, eps);
    p = pressure;
    q = shear;
    derived = law.derive(eps, state);
  }
};

template <class Shape, class L>
Outcome<Shape, L, double> step(L const& law, Step const& s) {
  return {law, support::strain_of<Shape>(law, s.p_tr, s.q_tr), s.eps_V};
}

/// Largest difference from the 50-digit map, over the largest of p_c, |p| and q.
template <class Shape>
double error_against_exact(Vector const& v) {
  law::CamClay const slow(rate_independent(v.step.beta));
  law::CamClayMuI const fast(mu_i(v.step.beta));
  auto const y = step<Shape>(slow, v.step);
  auto const o = step<Shape>(fast, v.step);
  support::ExactCamClay const exact(fast, fast.bulk<Shape>(), v.step.p_tr, v.step.q_tr, v.step.eps_V, dt);
  Real const scale = max(Real(abs(exact.p)), max(exact.p_c, exact.q));
  Real worst = 0;
  auto const compare = [&](double got, Real want, Real unit) { worst = max(worst, Real(abs(got - want) / unit)); };
  compare(y.p, exact.p, scale);
  compare(o.p, exact.p, scale);
  compare(y.q, exact.q_y, scale);
  compare(o.q, exact.q, scale);
  compare(o.derived[field::compressive_strength], exact.p_c, scale);
  compare(o.state[field::plastic_volumetric_strain], exact.eps_V, scale / fast.bulk<Shape>() + abs(exact.eps_V));
  return static_cast<double>(worst);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_rate_independent_map_gives_the_printed_values, *boost::unit_test::tolerance(1e-9)) {
  for (auto const& v : vectors) {
    law::CamClay const law(rate_independent(v.step.beta));
    BOOST_TEST_CONTEXT("p_tr " << v.step.p_tr << " q_tr " << v.step.q_tr << " beta " << v.step.beta) {
      auto const plane = step<shape::Plane>(law, v.step);
      BOOST_TEST(plane.p == v.plane.p);
      BOOST_TEST(plane.q == v.plane.q_y);
      BOOST_TEST(plane.state[field::plastic_volumetric_strain] == v.plane.eps_V);
      BOOST_TEST(plane.derived[field::compressive_strength] == v.plane.p_c);
      auto const solid = step<shape::Solid>(law, v.step);
      BOOST_TEST(solid.p == v.solid.p);
      BOOST_TEST(solid.q == v.solid.q_y);
      auto const full = step<shape::PlaneStrain>(law, v.step);
      BOOST_TEST(full.p == v.solid.p);
      BOOST_TEST(full.q == v.solid.q_y);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_viscous_step_gives_the_printed_values, *boost::unit_test::tolerance(1e-9)) {
  for (auto const& v : vectors) {
    law::CamClayMuI const law(mu_i(v.step.beta));
    auto const o = step<shape::Plane>(law, v.step);
    BOOST_TEST_CONTEXT("p_tr " << v.step.p_tr << " q_tr " << v.step.q_tr << " beta " << v.step.beta) {
      BOOST_TEST(o.p == v.plane.p);
      BOOST_TEST(o.q == v.plane.q);
      BOOST_TEST(o.derived[field::shear_rate] == v.plane.rate);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_maps_agree_with_bisection_in_fifty_digits) {
  double worst = 0;
  for (auto const& v : vectors) {
    double const error = std::max({error_against_exact<shape::Plane>(v), error_against_exact<shape::PlaneStrain>(v),
                                   error_against_exact<shape::Solid>(v)});
    BOOST_TEST(error < law::CamClayMap<law::ExponentialHardening>::tolerance,
               "p_tr " << v.step.p_tr << " q_tr " << v.step.q_tr << ": " << error);
    worst = std::max(worst, error);
  }
  BOOST_TEST_MESSAGE("largest error of a stress against 50 digits: " << worst);
}

BOOST_AUTO_TEST_CASE(random_plastic_steps_agree_with_bisection_in_fifty_digits) {
  support::LogUniform random(0.01, 10, 11);
  double worst = 0;
  int plastic = 0;
  while (plastic < 300) {
    Step const step{100 * random.signed_(), 100 * random.positive(), 0.1 * random.unit() - 0.05, 0.5 * random.unit()};
    law::CamClayMuI const law(mu_i(step.beta));
    if (law.yield(support::strain_of<shape::Plane>(law, step.p_tr, step.q_tr), {{step.eps_V}}) < 1e-6) continue;
    worst = std::max(worst, error_against_exact<shape::Plane>({step, {}, {}}));
    ++plastic;
  }
  BOOST_TEST_MESSAGE("largest error of a stress in " << plastic << " random steps: " << worst);
  BOOST_TEST(worst < 1e-11);
}

BOOST_AUTO_TEST_CASE(a_recovered_shear_rate_is_the_one_that_relaxed_the_stress) {
  for (auto const& v : vectors) {
    law::CamClayMuI const law(mu_i(v.step.beta));
    auto const o = step<shape::Plane>(law, v.step);
    double const rate = o.derived[field::shear_rate];
    // the rate loses the digits that q - q_y and the limit of q have in common with q: so many, by a pressure that is
    // nudged by four units in its last place
    auto const nudged = law.derive(support::strain_of<shape::Plane>(law, o.p * (1 + 1e-15), o.q), o.state);
    double const lost = std::abs(nudged[field::shear_rate] / rate - 1);
    BOOST_TEST(lost < 1e-9);
    BOOST_TEST(rate == (v.step.q_tr - o.q) / (law.G * dt), boost::test_tools::tolerance(1e-14 + lost));
  }
}

BOOST_AUTO_TEST_CASE(packs_and_duals_hold_the_same_values) {
  for (auto const& v : vectors) {
    law::CamClayMuI const law(mu_i(v.step.beta));
    Symmetric<Lanes, shape::Plane> packed;
    Symmetric<Dual<3>, shape::Plane> dual;
    std::array<Symmetric<double, shape::Plane>, lanes> trial;
    for (int lane = 0; lane < lanes; ++lane) {
      double const stretch = 1 - 0.1 * lane;  // lanes that leave the loop at different times
      trial[static_cast<std::size_t>(lane)] =
          support::strain_of<shape::Plane>(law, stretch * v.step.p_tr, stretch * v.step.q_tr);
      support::set_lane(packed, lane, trial[static_cast<std::size_t>(lane)]);
    }
    for (int k = 0; k < dual.size; ++k) dual[k] = Dual<3>::variable(trial[0][k], k);

    Outcome<shape::Plane, law::CamClayMuI, Lanes> const many(law, packed, Lanes(v.step.eps_V));
    Outcome<shape::Plane, law::CamClayMuI, Dual<3>> const traced(law, dual, Dual<3>(v.step.eps_V));
    for (int lane = 0; lane < lanes; ++lane) {
      Outcome<shape::Plane, law::CamClayMuI, double> const one(law, trial[static_cast<std::size_t>(lane)],
                                                               v.step.eps_V);
      double const scale = std::max({one.derived[field::compressive_strength], std::abs(one.p), one.q});
      double const round_off = 16 * std::numeric_limits<double>::epsilon() * scale;  // exp of packs differs by an ulp
      BOOST_TEST(std::abs(many.p[lane] - one.p) <= round_off);
      BOOST_TEST(std::abs(many.q[lane] - one.q) <= round_off);
      if (lane == 0) {
        BOOST_TEST(std::abs(traced.p.value - one.p) <= round_off);
        BOOST_TEST(std::abs(traced.q.value - one.q) <= round_off);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_derivative_of_the_map_is_the_slope_of_its_values) {
  // central differences with h = 1e-5 of the strain leave about 1e-10: h^2 of curvature, eps/h of rounding
  for (auto const& v : vectors) {
    bool const starts_at_the_apex = v.step.p_tr == 50;  // there the bracket is a point and no Newton step is made
    if (starts_at_the_apex) continue;
    law::CamClayMuI const law(mu_i(v.step.beta));
    auto const trial = support::strain_of<shape::Plane>(law, v.step.p_tr, v.step.q_tr);
    Symmetric<Dual<3>, shape::Plane> dual;
    for (int k = 0; k < dual.size; ++k) dual[k] = Dual<3>::variable(trial[k], k);
    Outcome<shape::Plane, law::CamClayMuI, Dual<3>> const traced(law, dual, Dual<3>(v.step.eps_V));
    for (int k = 0; k < dual.size; ++k) {
      double const h = 1e-5 * support::largest(trial);
      auto up = trial, down = trial;
      up[k] += h;
      down[k] -= h;
      Outcome<shape::Plane, law::CamClayMuI, double> const above(law, up, v.step.eps_V), below(law, down, v.step.eps_V);
      double const scale = law.G + law.bulk<shape::Plane>();
      BOOST_TEST(std::abs((above.p - below.p) / (2 * h) - traced.p.derivative(k)) < 1e-6 * scale);
      BOOST_TEST(std::abs((above.q - below.q) / (2 * h) - traced.q.derivative(k)) < 1e-6 * scale);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
