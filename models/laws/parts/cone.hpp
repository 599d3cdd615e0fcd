#pragma once

#include <limits>
#include <tuple>

#include "core/law.hpp"
#include "models/laws/parts/fields.hpp"
#include "models/laws/parts/hencky.hpp"
#include "models/laws/parts/radial_return.hpp"
#include "models/laws/parts/slope.hpp"
#include "models/laws/parts/softening.hpp"

namespace talus::law {

/// What the tip opened stays open: closing material bears load at once.
struct OpenGap {
  static constexpr bool recovers = false;
};
/// What the tip opened has to close before the material bears load again.
struct ClosingGap {
  static constexpr bool recovers = true;
};

/// Drucker–Prager as a product: cohesion times gap times rate law, without plastic dilation but at the tip.
///
///   q_y = M S,   S = P = p - p_tip,   p_tip = -c(e)/M                                                    (1)
///   shear   p = p_tr,   q = relax(q_tr, S),   e = e_n + (q_tr - q)/(sqrt(2) G)                           (2)
///   tip     p = p_tip,  q = 0,   eps_V^P += (p - p_tr)/K,   e = e_n + q_tr/(sqrt(2) G),
///           where p_tr lies below the p_tip of that e                                                    (3)
///   gap     before all, eps_V^P is given back to the elastic strain: p_tr <- p_tr - K eps_V^P,
///           eps_V^P <- 0                                                     with ClosingGap            (4)
///
/// The cohesion is that of the end of the step in (2) and (3). With mu(I), M is mu_1 and the whole of (1) uses the same
/// P, where the peer mixes p_tr and P.
///
/// (4) is the volume correction of Pradhana, written with the one strain that the tip makes: v = eps_V^P, p_shift = -K v.
/// It is 0 when the particle is right of the tip, and what is taken from it goes into the elastic strain, so that the
/// volume is known; the peer shifts the yield test alone. In a cohesive material a gap that closes takes the work
/// c/M eps_V^P with it: the plastic work that is never negative is that of (2) and (3).
///
/// p, q, c [Pa]; e = eps_dev^P [1]; eps_V^P [1].
/// Source: Drucker & Prager (1952), doi:10.1090/qam/48291; (4): Tampubolon et al. (2017), doi:10.1145/3072959.3073651
/// (not re-read); softening: larsblatny/matter; maps derived here.
template <class Cohesion, class Gap, class Rate>
struct Cone : HenckyElasticity {
  static constexpr bool rate_dependent = Rate::rate_dependent, dissipative = true;
  using State = Unite<Fields<field::PlasticVolumetricStrain>, typename Cohesion::State>;
  using Derived = typename Rate::Derived;

  struct Parameters : HenckyElasticity::Parameters, Cohesion::Parameters, Rate::Parameters {
    static constexpr auto table() {
      return std::tuple_cat(HenckyElasticity::Parameters::table(), Cohesion::Parameters::table(),
                            Rate::Parameters::table());
    }
  };

  Cohesion cohesion;
  Rate rate;
  double M;
  explicit Cone(Parameters const& p) : HenckyElasticity(p), cohesion(p), rate(p), M(rate.slope()) {}

  template <class Shape>
  [[nodiscard]] Record<double, State> initial() const {
    return {};
  }

  template <Scalar T, class Shape>
  [[nodiscard]] Symmetric<T, Shape> project(Symmetric<T, Shape> trial, Record<T, State>& state, T dt) const {
    if constexpr (Gap::recovers) recover(trial, state);  // (4)
    auto const [p_tr, q_tr, dev] = split(trial);
    T const e_n = softening(state);
    auto const plastic = q_tr > T(M) * p_tr + cohesion.cohesion(e_n);
    if (!any(plastic)) return trial;

    T const flowed = shear_stress(p_tr, q_tr, e_n, dt, plastic);  // (2)
    T const sheared = T(1 / (std::sqrt(2.0) * G)) * q_tr;         // (3): all of it
    T const p_tip = T(-1 / M) * cohesion.cohesion(T(e_n + sheared));
    auto const tip = p_tr <= p_tip;
    T const p = rate.share(p_tr, select<T>(tip, p_tip, p_tr), dt);
    T const q = min(q_tr, rate.share(q_tr, select<T>(tip, 0.0, flowed), dt));

    state[field::plastic_volumetric_strain] += select<T>(plastic && tip, T(1 / bulk<Shape>()) * (p - p_tr), 0.0);
    if constexpr (Cohesion::softens)
      state[field::plastic_shear_strain] += select<T>(plastic, T(1 / (std::sqrt(2.0) * G)) * (q_tr - q), 0.0);
    auto const admissible = strain(p, T(q / max(q_tr, T(least_stress))), dev);
    Symmetric<T, Shape> eps = trial;
    for (int k = 0; k < eps.size; ++k) eps[k] = select<T>(plastic, admissible[k], trial[k]);
    return eps;
  }

  /// (4).
  template <Scalar T, class Shape>
  void recover(Symmetric<T, Shape>& trial, Record<T, State>& state) const requires(Gap::recovers) {
    T& eps_V = state[field::plastic_volumetric_strain];
    trial = trial + isotropic<Shape>(T(eps_V * T(1.0 / Shape::normals)));
    eps_V = T(0.0);
  }

  template <Scalar T, class Shape>
  [[nodiscard]] T yield(Symmetric<T, Shape> const& eps, Record<T, State> const& state) const {
    auto const [p, q, dev] = split(eps);
    return q - (T(M) * p + cohesion.cohesion(softening(state)));
  }
  [[nodiscard]] bool viscous() const requires rate_dependent { return rate.viscous(); }

  /// Friction coefficient, for walls that take it from the material.
  template <Scalar T, class Shape>
  [[nodiscard]] T friction(Symmetric<T, Shape> const& eps, Record<T, State> const& state) const {
    auto const [p, q, dev] = split(eps);
    return rate.friction(q, surface(p, softening(state)));
  }
  template <Scalar T, class Shape>
  [[nodiscard]] Record<T, Derived> derive(Symmetric<T, Shape> const& eps, Record<T, State> const& state) const {
    auto const [p, q, dev] = split(eps);
    Record<T, Derived> derived;
    rate.derive(q, reference(eps, state), G, derived);
    return derived;
  }
  template <Scalar T, class Shape>
  [[nodiscard]] T volume_ratio(Symmetric<T, Shape> const& eps, Record<T, State> const& state) const {
    return exp(T(trace(eps) + state[field::plastic_volumetric_strain]));
  }

 private:
  /// (1); `p_c` means nothing here.
  template <Scalar T>
  [[nodiscard]] EllipsePoint<T> surface(T p, T e) const {
    T const P = max(T(0.0), T(p + T(1 / M) * cohesion.cohesion(e)));
    return {p, T(0.0), P, P};
  }
  template <Scalar T>
  [[nodiscard]] T softening(Record<T, State> const& state) const {
    if constexpr (Cohesion::softens)
      return state[field::plastic_shear_strain];
    else
      return T(0.0);
  }
  /// (2).
  template <Scalar T, class Condition>
  [[nodiscard]] T shear_stress(T p, T q_tr, T e_n, T dt, Condition plastic) const {
    if constexpr (Cohesion::softens)
      return radial_return(
          rate, q_tr, e_n, G, dt, [&](auto e) { return surface(decltype(e)(p), e); }, plastic);
    else
      return rate.relax(q_tr, surface(p, e_n), G, dt);
  }
  /// The point of the surface that the flow law speaks of: at this pressure, or where flow without end would lead.
  template <Scalar T, class Shape>
  [[nodiscard]] EllipsePoint<T> reference(Symmetric<T, Shape> const& eps, Record<T, State> const& state) const {
    Record<T, State> rested = state;
    if constexpr (!Rate::shares_flow) return surface(split(eps).p, softening(state));
    auto const [p_bar, q_bar, dev] = split(project(eps, rested, T(std::numeric_limits<double>::max())));
    EllipsePoint<T> at = surface(p_bar, softening(rested));
    at.S = at.P = min(at.S, T(q_bar * T(1 / M)));
    return at;
  }
};

}  // namespace talus::law
