#pragma once
/// How volume and shear of a viscous Cam-Clay step hang together: one after the other, or in one solve.

#include "models/laws/parts/cam_clay_map.hpp"
#include "models/laws/parts/consistent_map.hpp"

namespace talus::law {

/// As published: the volume as if there were no viscosity, then the shear stress.
///
///   stage 1  (p_tr, q_tr) -> (p, q_y)                                Map, rate-independent
///   stage 2  q_y -> q, q_y <= q <= q_tr                              Rate, at the p and p_c of stage 1
///
/// With a rate that acts on shear alone, the volume follows the whole overstress: the way to critical state depends on
/// dt, critical state itself does not, and where the material dilates, a step so short that hardly any shear slip is
/// left does negative plastic work. A rate that shares the flow scales what both stages did.
template <template <class> class Map>
struct TwoStage {
  template <class Rate>
  static constexpr bool dissipative = !Rate::rate_dependent || Rate::shares_flow;
  template <class Hardening, class Rate>
  static constexpr bool associated = !Rate::rate_dependent && Map<Hardening>::associated;

  template <class Hardening, class Rate, Scalar T, class Condition>
  [[nodiscard]] static FlowedStress<T> flow(Ellipse const& surface, Hardening const& hardening, Rate const& rate,
                                            Modulus const& m, CamClayTrial<T> const& trial, T dt, Condition plastic) {
    auto const mapped = Map<Hardening>{surface, hardening, m.K, m.G}(trial.p, trial.q, trial.eps_V, trial.p_c, plastic);
    T const q = min(trial.q, rate.relax(trial.q, mapped.at, m.G, dt));
    return {rate.share(trial.p, mapped.at.p, dt), rate.share(trial.q, q, dt)};
  }
};

/// Both at once: ConsistentMap has the equations.
struct Consistent {
  template <class Rate>
  static constexpr bool dissipative = true;
  template <class Hardening, class Rate>
  static constexpr bool associated = true;

  template <class Hardening, class Rate, Scalar T, class Condition>
  [[nodiscard]] static FlowedStress<T> flow(Ellipse const& surface, Hardening const& hardening, Rate const& rate,
                                            Modulus const& m, CamClayTrial<T> const& trial, T dt, Condition plastic) {
    return ConsistentMap<Hardening, Rate>{surface, hardening, rate, m}(trial, dt, plastic);
  }
};

}  // namespace talus::law
