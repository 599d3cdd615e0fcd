/// The products of factors: where they meet the elementary laws, and what each factor does.

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "models/laws/drucker_prager.hpp"
#include "models/laws/drucker_prager_softening.hpp"
#include "models/laws/drucker_prager_viscous.hpp"
#include "models/laws/modified_cam_clay.hpp"
#include "models/laws/von_mises.hpp"
#include "models/laws/von_mises_softening.hpp"
#include "tests/support/law_states.hpp"
#include "tests/support/material_point.hpp"

BOOST_AUTO_TEST_SUITE(laws_products)

using namespace talus;
using boost::test_tools::tolerance;
using support::MaterialPoint;
using support::simple_shear;

namespace {

constexpr double round_off = 1e-13;

/// Largest difference of the strains of two laws after the same random steps, over the largest trial strain.
template <class A, class B>
double difference(A const& a, B const& b) {
  support::LogUniform random(10, 1e4, 31);
  double worst = 0;
  for (int k = 0; k < 300; ++k) {
    MaterialPoint<shape::PlaneStrain, A> one{a};
    MaterialPoint<shape::PlaneStrain, B> other{b};
    auto const trial = support::strain_of<shape::PlaneStrain>(a, random.signed_(), random.positive());
    one.step(trial, 1e-4), other.step(trial, 1e-4);
    worst = std::max(worst, support::largest(one.eps - other.eps) / support::largest(trial));
  }
  return worst;
}

}  // namespace

BOOST_AUTO_TEST_CASE(without_softening_and_viscosity_the_products_are_the_elementary_laws) {
  law::DruckerPrager::Parameters cone;
  cone.c = 100;
  law::DruckerPrager const drucker_prager(cone);
  law::DruckerPragerSoftening::Parameters soft;
  soft.xi = 0;
  BOOST_TEST(difference(drucker_prager, law::DruckerPragerSoftening(soft)) < round_off);
  law::DruckerPragerPerzyna::Parameters perzyna;
  perzyna.c = 100, perzyna.t_v = 0;
  BOOST_TEST(difference(drucker_prager, law::DruckerPragerPerzyna(perzyna)) < round_off);
  law::DruckerPragerDuvautLions::Parameters relaxing;
  relaxing.c = 100, relaxing.t_v = 0;
  BOOST_TEST(difference(drucker_prager, law::DruckerPragerDuvautLions(relaxing)) < round_off);
  law::DruckerPragerMuI::Parameters mu_i;
  mu_i.c = 100, mu_i.mu_1 = mu_i.mu_2 = cone.M;
  BOOST_TEST(difference(drucker_prager, law::DruckerPragerMuI(mu_i)) < round_off);

  law::VonMisesSoftening::Parameters steel;
  steel.xi = 0, steel.p_t = 1e9;
  BOOST_TEST(difference(law::VonMises({}), law::VonMisesSoftening(steel)) < round_off);
}

BOOST_AUTO_TEST_CASE(softening_ends_at_the_residual_strength_and_takes_the_cohesion) {
  law::VonMisesSoftening const steel(law::VonMisesSoftening::Parameters{});
  MaterialPoint<shape::Solid, law::VonMisesSoftening> point{steel};
  for (int k = 0; k < 200; ++k) point.step(simple_shear<shape::Solid>(0.05), 1);
  double const e = point.state[field::plastic_shear_strain];
  BOOST_TEST(e == (200 * 0.05 - 500 / steel.G) / std::sqrt(2.0), tolerance(1e-6));
  BOOST_TEST(point.q() == 500 + 500 * std::exp(-10 * e), tolerance(1e-9));

  law::DruckerPragerSoftening const clay(law::DruckerPragerSoftening::Parameters{});
  MaterialPoint<shape::Solid, law::DruckerPragerSoftening> block{clay};
  block.eps = isotropic<shape::Solid>(-1000 / clay.volumetric_modulus<shape::Solid>());
  block.step(simple_shear<shape::Solid>(0.05), 1);
  double const c = 100 * std::exp(-10 * block.state[field::plastic_shear_strain]);
  BOOST_TEST(block.q() == clay.M * 1000 + c, tolerance(1e-9));
  BOOST_TEST(block.p() == 1000, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(tension_beyond_the_cut_off_leaves_no_stress_and_is_kept_as_volume) {
  law::VonMisesSoftening const law(law::VonMisesSoftening::Parameters{});
  MaterialPoint<shape::Solid, law::VonMisesSoftening> held{law}, torn{law};
  held.step(support::strain_of<shape::Solid>(law, -999, 300), 1);
  BOOST_TEST(held.p() == -999, tolerance(1e-12));
  BOOST_TEST(held.q() == 300, tolerance(1e-12));
  torn.step(support::strain_of<shape::Solid>(law, -1001, 300), 1);
  BOOST_TEST(support::largest(torn.eps) == 0);
  BOOST_TEST(torn.state[field::plastic_volumetric_strain] == 1001 / law.bulk<shape::Solid>(), tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_gap_closes_before_load_is_borne_only_with_the_volume_correction) {
  law::DruckerPrager const plain(law::DruckerPrager::Parameters{});
  law::DruckerPragerVolumeCorrected const corrected(law::DruckerPragerVolumeCorrected::Parameters{});
  MaterialPoint<shape::Solid, law::DruckerPrager> gains{plain};
  MaterialPoint<shape::Solid, law::DruckerPragerVolumeCorrected> closes{corrected};
  auto const by = [](double volume) { return isotropic<shape::Solid>(volume / 3); };
  double const K = plain.bulk<shape::Solid>();
  for (int k = 0; k < 10; ++k) gains.step(by(0.01), 1), closes.step(by(0.01), 1);
  BOOST_TEST(closes.state[field::plastic_volumetric_strain] == 0.1, tolerance(1e-12));
  for (int k = 0; k < 9; ++k) gains.step(by(-0.01), 1), closes.step(by(-0.01), 1);
  BOOST_TEST(gains.p() == 0.09 * K, tolerance(1e-12));  // a tenth of the volume gained
  BOOST_TEST(std::abs(closes.p()) < 1e-12 * K);
  closes.step(by(-0.011), 1);  // 0.001 beyond closed
  BOOST_TEST(closes.p() == 0.001 * K, tolerance(1e-10));
  BOOST_TEST(closes.state[field::plastic_volumetric_strain] == 0);
}

BOOST_AUTO_TEST_CASE(mu_i_on_the_cone_is_the_law_of_jop_at_steady_shear) {
  law::DruckerPragerMuI::Parameters parameters;
  law::DruckerPragerMuI const law(parameters);
  for (double const rate : {0.1, 10.0, 1000.0}) {
    MaterialPoint<shape::Plane, law::DruckerPragerMuI> point{law};
    double const p = 100, I = parameters.d * rate * std::sqrt(parameters.rho_s / p);
    point.eps = isotropic<shape::Plane>(-p / law.volumetric_modulus<shape::Plane>());
    for (int k = 0; k < 4000; ++k) point.step(simple_shear<shape::Plane>(rate * 1e-5), 1e-5);
    double const mu = parameters.mu_1 + (parameters.mu_2 - parameters.mu_1) / (parameters.I_0 / I + 1);
    BOOST_TEST(point.q() / point.p() == mu, tolerance(1e-10));
    BOOST_TEST(point.derived(field::inertial_number) == I, tolerance(1e-7));
  }
}

BOOST_AUTO_TEST_CASE(explicit_hardening_meets_the_implicit_one_with_order_one) {
  law::CamClay const implicit(law::CamClay::Parameters{});
  law::CamClayExplicit const lagging(law::CamClayExplicit::Parameters{});
  auto const after = [&](auto const& law, int n) {
    MaterialPoint<shape::Solid, std::decay_t<decltype(law)>> point{law};
    for (int k = 0; k < n; ++k)
      point.step(simple_shear<shape::Solid>(0.02 / n) + isotropic<shape::Solid>(-0.02 / (3 * n)), 1);
    return point;
  };
  auto const difference = [&](int n) { return std::abs(after(implicit, n).p() - after(lagging, n).p()); };
  BOOST_TEST(std::log2(difference(400) / difference(800)) == 1.0, tolerance(0.05));
  // off the surface by the strength gained in the last step, on the surface of the strength before it
  auto const last = after(lagging, 800);
  BOOST_TEST(lagging.yield(last.eps, last.state) < 0);
}

BOOST_AUTO_TEST_SUITE_END()
