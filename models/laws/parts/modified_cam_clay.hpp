#pragma once

#include <limits>
#include <tuple>

#include "core/law.hpp"
#include "models/laws/parts/coupling.hpp"
#include "models/laws/parts/fields.hpp"
#include "models/laws/parts/hardening.hpp"
#include "models/laws/parts/hencky.hpp"
#include "models/laws/parts/mu_i.hpp"
#include "models/laws/parts/rate_independent.hpp"
#include "models/laws/parts/slope.hpp"

namespace talus::law {

/// Modified Cam-Clay with cohesion: a hardening law times a rate law on the yield ellipse.
///
///   y(p, q) = q^2 - M^2 (p_c - p)(p + beta p_c) <= 0                      without viscosity                  (1)
///   (p_tr, q_tr) -> (p, q),   eps_V^P += (p - p_tr)/K                     Coupling of volume and shear       (2)
///
/// p, q [Pa]: pressure and shear stress of the Kirchhoff stress; p_c(eps_V^P) [Pa]: compressive strength, by Hardening.
/// Source: Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643.
template <class Hardening, class Rate, class Coupling = TwoStage<CamClayMap>>
struct ModifiedCamClay : HenckyElasticity {
  static constexpr bool rate_dependent = Rate::rate_dependent, dissipative = Coupling::template dissipative<Rate>;
  static constexpr bool associated = Coupling::template associated<Hardening, Rate>;
  static constexpr bool hardens_explicitly = is_explicit<Hardening>;
  using State = Fields<field::PlasticVolumetricStrain>;
  using Derived = Unite<Fields<field::CompressiveStrength>, typename Rate::Derived>;

  struct Parameters : HenckyElasticity::Parameters, Hardening::Parameters, Rate::Parameters {
    double beta = 0;
    static constexpr auto table() {
      return std::tuple_cat(
          HenckyElasticity::Parameters::table(), Hardening::Parameters::table(),
          std::tuple{parameter(&Parameters::beta, "beta", "beta", "1", "cohesion: tensile over compressive strength",
                               right_open(0, 1))
                         .validated(0, 0.3, "Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643, collapses")},
          Rate::Parameters::table());
    }
  };

  Hardening hardening;
  Rate rate;
  Ellipse surface;

  explicit ModifiedCamClay(Parameters const& p)
      : HenckyElasticity(p), hardening(p), rate(p), surface{rate.slope(), p.beta} {}

  template <class Shape>
  [[nodiscard]] Record<double, State> initial() const {
    return {};
  }

  template <Scalar T, class Shape>
  [[nodiscard]] Symmetric<T, Shape> project(Symmetric<T, Shape> const& trial, Record<T, State>& state, T dt) const {
    double const K = bulk<Shape>();
    T& eps_V = state[field::plastic_volumetric_strain];
    auto const [p_tr, q_tr, dev] = split(trial);
    T const p_c = hardening.strength(eps_V, K);
    auto const plastic = surface.excess(p_tr, q_tr, p_c) > T(0.0) && p_c < T(hardening.ceiling(K));  // (1)
    if (!any(plastic)) return trial;

    auto const& hardens = during_step(hardening, eps_V, p_c, K);
    auto const [p, q] = Coupling::flow(surface, hardens, rate, Modulus{K, G}, CamClayTrial<T>{p_tr, q_tr, eps_V, p_c},
                                       dt, plastic);  // (2)

    eps_V = select<T>(plastic, eps_V + T(1 / K) * (p - p_tr), eps_V);
    auto const admissible = strain(p, T(q / max(q_tr, T(least_stress))), dev);
    Symmetric<T, Shape> eps = trial;
    for (int k = 0; k < eps.size; ++k) eps[k] = select<T>(plastic, admissible[k], trial[k]);
    return eps;
  }

  template <Scalar T, class Shape>
  [[nodiscard]] T yield(Symmetric<T, Shape> const& eps, Record<T, State> const& state) const {
    auto const [p, q, dev] = split(eps);
    T const p_c = strength<Shape>(state);
    return select<T>(p_c < T(hardening.ceiling(bulk<Shape>())), surface.distance(p, q, p_c), -p_c);
  }

  template <Scalar T, class Shape>
  [[nodiscard]] Record<T, Derived> derive(Symmetric<T, Shape> const& eps, Record<T, State> const& state) const {
    auto const [p, q, dev] = split(eps);
    T const p_c = strength<Shape>(state);
    Record<T, Derived> derived;
    derived[field::compressive_strength] = p_c;
    rate.derive(q, reference(eps, state, p, p_c), G, derived);
    return derived;
  }

  /// What associated viscous flow is normal to [1]: q/S, of which a level set is a dynamic ellipse.
  template <Scalar T, class Shape>
  [[nodiscard]] T potential(Symmetric<T, Shape> const& eps, Record<T, State> const& state) const {
    if constexpr (!rate_dependent) return yield(eps, state);
    auto const [p, q, dev] = split(eps);
    return q / (surface.at(p, strength<Shape>(state)).S + T(least_stress));
  }
  /// Whether anything is viscous with these parameters.
  [[nodiscard]] bool viscous() const requires rate_dependent { return rate.viscous(); }

  /// Friction coefficient, for walls that take it from the material.
  template <Scalar T, class Shape>
  [[nodiscard]] T friction(Symmetric<T, Shape> const& eps, Record<T, State> const& state) const {
    auto const [p, q, dev] = split(eps);
    return rate.friction(q, surface.at(p, strength<Shape>(state)));
  }

  template <Scalar T, class Shape>
  [[nodiscard]] T volume_ratio(Symmetric<T, Shape> const& eps, Record<T, State> const& state) const {
    return exp(T(trace(eps) + state[field::plastic_volumetric_strain]));
  }

  /// p_c [Pa].
  template <class Shape, Scalar T>
  [[nodiscard]] T strength(Record<T, State> const& state) const {
    return hardening.strength(state[field::plastic_volumetric_strain], bulk<Shape>());
  }

 private:
  /// The point of the ellipse that the flow law speaks of: at this pressure, or where flow without end would lead.
  template <Scalar T, class Shape>
  [[nodiscard]] EllipsePoint<T> reference(Symmetric<T, Shape> const& eps, Record<T, State> const& state, T p,
                                          T p_c) const {
    if constexpr (!Rate::shares_flow) return surface.at(p, p_c);
    Record<T, State> rested = state;
    auto const [p_bar, q_bar, dev] = split(project(eps, rested, T(std::numeric_limits<double>::max())));
    EllipsePoint<T> at = surface.at(p_bar, strength<Shape>(rested));
    at.S = q_bar * T(1 / rate.slope());
    return at;
  }
};

}  // namespace talus::law
