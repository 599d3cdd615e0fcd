/// The contracts of plastic flow, and the claims that a law may make, tested on laws that are wrong on purpose.

#include <boost/test/unit_test.hpp>

#include "models/laws/cam_clay_hardening_flow.hpp"
#include "models/laws/cam_clay_mu_i.hpp"
#include "models/laws/cam_clay_mu_i_consistent.hpp"
#include "models/laws/cam_clay_viscous.hpp"
#include "models/laws/drucker_prager_softening.hpp"
#include "models/laws/modified_cam_clay.hpp"
#include "models/laws/von_mises_softening.hpp"
#include "tests/contracts/law_flow.hpp"

BOOST_AUTO_TEST_SUITE(law_mutants_flow)

using namespace talus;
using namespace talus::contract_of;

namespace {

/// Claims that its flow is normal to the ellipse, and flows along the hardening.
struct SkewedFlow : law::ModifiedCamClay<law::ExponentialHardening, law::CamClayRateIndependent,
                                         law::TwoStage<law::HardeningFlowMap>> {
  static constexpr bool associated = true;
  using ModifiedCamClay::ModifiedCamClay;
};
/// Claims that volume and shear follow one rate.
struct TwoStagesAsOne : law::CamClayMuI {
  static constexpr bool associated = true;
  using CamClayMuI::CamClayMuI;
};

/// Makes its steps with twice the time.
template <class L>
struct HastySteps : L {
  using L::L;
  template <class T, class Shape>
  Symmetric<T, Shape> project(Symmetric<T, Shape> const& trial, Record<T, typename L::State>& state, T dt) const {
    return L::project(trial, state, T(2.0) * dt);
  }
};
/// Tells of no rate at all.
struct SilentRate : law::CamClayMuI {
  using CamClayMuI::CamClayMuI;
  template <class T, class Shape>
  auto derive(Symmetric<T, Shape> const& eps, Record<T, State> const& state) const {
    auto derived = CamClayMuI::derive(eps, state);
    derived[field::shear_rate] = T(0.0);
    return derived;
  }
};

/// Freezes its strength during a step and does not say so.
struct SecretlyExplicit : law::CamClayExplicit {
  static constexpr bool hardens_explicitly = false;
  using CamClayExplicit::CamClayExplicit;
};
/// Says that it freezes its strength, and does not.
struct BoastfullyExplicit : law::CamClay {
  static constexpr bool hardens_explicitly = true;
  using CamClay::CamClay;
};
/// Drops its stress and does not say so.
struct SecretlyBrittle : law::VonMisesSoftening {
  static constexpr bool brittle = false;
  using VonMisesSoftening::VonMisesSoftening;
};

/// Forgets the gap instead of closing it.
struct ForgottenGap : law::DruckerPragerVolumeCorrected {
  using DruckerPragerVolumeCorrected::DruckerPragerVolumeCorrected;
  template <class T, class Shape>
  void recover(Symmetric<T, Shape>& /*trial*/, Record<T, State>& state) const {
    state[field::plastic_volumetric_strain] = T(0.0);
  }
};
/// Closes the gap by half.
struct HalfAGap : law::DruckerPragerVolumeCorrected {
  using DruckerPragerVolumeCorrected::DruckerPragerVolumeCorrected;
  template <class T, class Shape>
  void recover(Symmetric<T, Shape>& trial, Record<T, State>& state) const {
    T const half = T(0.5) * state[field::plastic_volumetric_strain];
    trial = trial + isotropic<Shape>(T(half * T(1.0 / Shape::normals)));
    state[field::plastic_volumetric_strain] = half;
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(flow_off_the_normal_is_refused) {
  BOOST_TEST(!flow_is_normal_to_the_potential<SkewedFlow>().empty());
  BOOST_TEST(!flow_is_normal_to_the_potential<TwoStagesAsOne>().empty());
}

BOOST_AUTO_TEST_CASE(a_rate_that_the_state_does_not_tell_of_is_refused) {
  BOOST_TEST(!viscous_flow_law_is_satisfied<HastySteps<law::CamClayMuI>>().empty());
  BOOST_TEST(!viscous_flow_law_is_satisfied<HastySteps<law::CamClayMuIConsistent>>().empty());
  BOOST_TEST(!viscous_flow_law_is_satisfied<HastySteps<law::CamClayDuvautLions>>().empty());
  BOOST_TEST(!viscous_flow_law_is_satisfied<HastySteps<law::VonMisesPerzyna>>().empty());
  BOOST_TEST(!viscous_flow_law_is_satisfied<SilentRate>().empty());
}

BOOST_AUTO_TEST_CASE(a_wrong_claim_about_the_hardening_is_refused) {
  BOOST_TEST(!projection_is_admissible<SecretlyExplicit>().empty());
  BOOST_TEST(!kuhn_tucker_conditions_hold<BoastfullyExplicit>().empty());
}

BOOST_AUTO_TEST_CASE(stress_dropped_without_saying_so_is_refused) {
  BOOST_TEST(!kuhn_tucker_conditions_hold<SecretlyBrittle>().empty());
}

BOOST_AUTO_TEST_CASE(a_gap_that_is_lost_or_closed_in_part_is_refused) {
  BOOST_TEST(!recovery_is_part_of_the_projection<ForgottenGap>().empty());
  BOOST_TEST(!recovery_is_part_of_the_projection<HalfAGap>().empty());
}

BOOST_AUTO_TEST_SUITE_END()
