/// The contracts are tested on laws that are wrong on purpose: each must be refused by the contract that is meant for
/// it.

#include <boost/test/unit_test.hpp>

#include "models/laws/cam_clay_mu_i.hpp"
#include "models/laws/drucker_prager.hpp"
#include "models/laws/hencky.hpp"
#include "models/laws/modified_cam_clay.hpp"
#include "tests/contracts/law_contracts.hpp"

BOOST_AUTO_TEST_SUITE(law_mutants)

using namespace talus;

namespace {

/// Half the shear modulus in the stress, all of it in the energy.
template <class L>
struct HalvedShear : L {
  using L::L;
  template <class T, class Shape>
  Symmetric<T, Shape> stress(Symmetric<T, Shape> const& eps) const {
    return T(this->G) * eps + isotropic<Shape>(T(this->lambda * trace(eps)));
  }
};

/// A law whose projection is changed by `Mutation::after`.
template <class L, class Mutation>
struct Mutated : L {
  using L::L;
  template <class T, class Shape>
  Symmetric<T, Shape> project(Symmetric<T, Shape> const& trial, Record<T, typename L::State>& state, T dt) const {
    auto const before = state;
    return Mutation::after(static_cast<L const&>(*this), trial, L::project(trial, state, dt), before, state);
  }
};

/// Lanes that a projection changed.
template <class T, class Shape>
auto changed(Symmetric<T, Shape> const& trial, Symmetric<T, Shape> const& result) {
  auto differs = trial[0] != result[0];
  for (int k = 1; k < trial.size; ++k) differs = differs || trial[k] != result[k];
  return differs;
}
template <class T, class Shape, class Condition>
Symmetric<T, Shape> choose(Condition condition, Symmetric<T, Shape> a, Symmetric<T, Shape> const& b) {
  for (int k = 0; k < a.size; ++k) a[k] = select<T>(condition, a[k], b[k]);
  return a;
}

/// The deviator goes on to 0.9 of what it should be: admissible, and idempotent.
struct OverProjection {
  template <class L, class T, class Shape, class State>
  static auto after(L const&, Symmetric<T, Shape> const& trial, Symmetric<T, Shape> const& result, State const&,
                    State&) {
    auto const less = isotropic<Shape>(T(trace(result) * T(1.0 / Shape::normals))) + T(0.9) * deviator(result);
    return choose(changed(trial, result), less, result);
  }
};

/// The deviator stops at 1.1 of what it should be.
struct UnderProjection {
  template <class L, class T, class Shape, class State>
  static auto after(L const&, Symmetric<T, Shape> const& trial, Symmetric<T, Shape> const& result, State const&,
                    State&) {
    auto const more = result + T(0.1) * deviator(result);
    return choose(changed(trial, result), more, result);
  }
};

/// The tip of the cone on the wrong side: p = +c/M.
struct TipOnTheWrongSide {
  template <class L, class T, class Shape, class State>
  static auto after(L const& law, Symmetric<T, Shape> const& trial, Symmetric<T, Shape> const& result,
                    State const& before, State& state) {
    auto const torn = law.split(trial).p < T(-law.c / law.M);
    auto const mirrored = isotropic<Shape>(T(-law.c / law.M / law.template volumetric_modulus<Shape>()));
    auto const right = choose(torn, mirrored, result);
    state[field::plastic_volumetric_strain] =
        before[field::plastic_volumetric_strain] + trace(trial) - trace(right);  // else the volume would tell
    return right;
  }
};

/// The plastic volume is not kept.
struct ForgottenState {
  template <class L, class T, class Shape, class State>
  static auto after(L const&, Symmetric<T, Shape> const&, Symmetric<T, Shape> const& result, State const& before,
                    State& state) {
    state = before;
    return result;
  }
};

/// The entry xx is favoured.
struct PreferredAxis {
  template <class L, class T, class Shape, class State>
  static auto after(L const&, Symmetric<T, Shape> const& trial, Symmetric<T, Shape> const& result, State const&,
                    State&) {
    auto bent = result;
    bent[0] = bent[0] + T(1e-6) * (trial[0] - result[0]);
    bent[1] = bent[1] - T(1e-6) * (trial[0] - result[0]);
    return bent;
  }
};

/// A lane follows the first one.
struct NosyLane {
  template <class L, class T, class Shape, class State>
  static auto after(L const&, Symmetric<T, Shape> const&, Symmetric<T, Shape> result, State const&, State&) {
    if constexpr (std::same_as<T, Lanes>) result[0] = result[0] * (T(1.0) + T(1e-13 * (result[0][0] > 0 ? 1 : 0)));
    return result;
  }
};

/// The flow runs backwards: more elastic strain than the trial had, on the surface of nothing.
struct BackwardFlow {
  template <class L, class T, class Shape, class State>
  static auto after(L const&, Symmetric<T, Shape> const& trial, Symmetric<T, Shape> const& result, State const&,
                    State&) {
    return trial + (trial - result);
  }
};

/// The viscous stress undershoots the yield stress by as much as it should stay above.
struct Undershoot {
  template <class L, class T, class Shape, class State>
  static auto after(L const& law, Symmetric<T, Shape> const& trial, Symmetric<T, Shape> const& result, State const&,
                    State& state) {
    T const overstress = max(T(0.0), law.yield(result, state));
    T const q = law.split(result).q;
    T const keep = T(1.0) - T(2.0) * overstress / max(q, T(1e-300));
    auto const below = isotropic<Shape>(T(trace(result) * T(1.0 / Shape::normals))) + keep * deviator(result);
    return choose(changed(trial, result), below, result);
  }
};

/// What is no number is taken for rest, at least beside others that flow.
template <bool alone>
struct Hiding {
  template <class L, class T, class Shape, class State>
  static auto after(L const&, Symmetric<T, Shape> const& trial, Symmetric<T, Shape> const& result, State const& before,
                    State& state) {
    if (!alone && std::same_as<T, double>) return result;
    auto const lost = trial[0] != trial[0];
    for (std::size_t k = 0; k < state.values.size(); ++k)
      state.values[k] = select<T>(lost, before.values[k], state.values[k]);
    return choose(lost, Symmetric<T, Shape>{}, result);
  }
};

template <class L>
using Overprojecting = Mutated<L, OverProjection>;
template <class L>
using Underprojecting = Mutated<L, UnderProjection>;
template <class L>
using Forgetting = Mutated<L, ForgottenState>;
template <class L>
using Nosy = Mutated<L, NosyLane>;
template <class L>
using Backward = Mutated<L, BackwardFlow>;
template <class L>
using Undershooting = Mutated<L, Undershoot>;

}  // namespace

BOOST_AUTO_TEST_CASE(half_a_shear_modulus_is_refused) {
  BOOST_TEST(!contract_of::stress_is_the_gradient_of_the_energy<HalvedShear<law::Hencky>>().empty());
  BOOST_TEST(!contract_of::stress_is_the_gradient_of_the_energy<HalvedShear<law::CamClay>>().empty());
}

BOOST_AUTO_TEST_CASE(projection_beyond_the_surface_is_refused) {
  BOOST_TEST(!contract_of::kuhn_tucker_conditions_hold<Overprojecting<law::DruckerPrager>>().empty());
  BOOST_TEST(!contract_of::kuhn_tucker_conditions_hold<Overprojecting<law::CamClay>>().empty());
}

BOOST_AUTO_TEST_CASE(projection_short_of_the_surface_is_refused) {
  BOOST_TEST(!contract_of::projection_is_admissible<Underprojecting<law::DruckerPrager>>().empty());
  BOOST_TEST(!contract_of::projection_is_admissible<Underprojecting<law::CamClay>>().empty());
  BOOST_TEST(!contract_of::projection_is_idempotent<Underprojecting<law::CamClay>>().empty());
}

BOOST_AUTO_TEST_CASE(a_tip_with_the_wrong_sign_is_refused) {
  // admissible, idempotent, and no fault at all without cohesion, which is the default
  using Mutant = Mutated<law::DruckerPrager, TipOnTheWrongSide>;
  BOOST_TEST(contract_of::projection_is_admissible<Mutant>().empty());
  BOOST_TEST(contract_of::projection_keeps_the_volume<Mutant>().empty());
  BOOST_TEST(!contract_of::kuhn_tucker_conditions_hold<Mutant>().empty());
}

BOOST_AUTO_TEST_CASE(a_forgotten_plastic_volume_is_refused) {
  BOOST_TEST(!contract_of::projection_keeps_the_volume<Forgetting<law::CamClay>>().empty());
  BOOST_TEST(!contract_of::projection_keeps_the_volume<Forgetting<law::DruckerPrager>>().empty());
}

BOOST_AUTO_TEST_CASE(hiding_what_is_no_number_is_refused) {
  using Mutant = Mutated<law::CamClay, Hiding<true>>;
  using InPacksOnly = Mutated<law::CamClay, Hiding<false>>;
  BOOST_TEST(contract_of::kuhn_tucker_conditions_hold<Mutant>().empty());
  BOOST_TEST(!contract_of::projection_does_not_hide_what_is_no_number<Mutant>().empty());
  BOOST_TEST(!contract_of::projection_does_not_hide_what_is_no_number<InPacksOnly>().empty());
}

BOOST_AUTO_TEST_CASE(a_preferred_axis_is_refused) {
  using Mutant = Mutated<law::CamClay, PreferredAxis>;
  BOOST_TEST(!contract_of::result_does_not_depend_on_the_order_of_the_axes<Mutant>().empty());
  BOOST_TEST(!contract_of::projection_is_objective<Mutant>().empty());
}

BOOST_AUTO_TEST_CASE(a_lane_that_looks_at_another_is_refused) {
  BOOST_TEST(!contract_of::a_pack_gives_the_same_as_its_lanes<Nosy<law::CamClay>>().empty());
}

BOOST_AUTO_TEST_CASE(flow_that_runs_backwards_is_refused) {
  BOOST_TEST(!contract_of::plastic_work_is_never_negative<Backward<law::DruckerPrager>>().empty());
  BOOST_TEST(!contract_of::plastic_work_is_never_negative<Backward<law::CamClayMuI>>().empty());
}

BOOST_AUTO_TEST_CASE(a_viscous_stress_below_the_yield_stress_is_refused) {
  BOOST_TEST(!contract_of::kuhn_tucker_conditions_hold<Undershooting<law::CamClayMuI>>().empty());
}

BOOST_AUTO_TEST_SUITE_END()
