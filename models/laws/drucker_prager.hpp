#pragma once

#include <string_view>
#include <tuple>

#include "core/law.hpp"
#include "models/laws/parts/fields.hpp"
#include "models/laws/parts/hencky.hpp"

namespace talus::law {

/// Drucker–Prager, perfectly plastic, no plastic dilation but at the tip.
///
///   y(p, q) = q - (M p + c) <= 0                                           (1)
///   shear   p_tr >= -c/M:  p = p_tr,   q = M p_tr + c                      (2)
///   tip     p_tr < -c/M:   p = -c/M,   q = 0,   eps_V^P += (p - p_tr)/K    (3)
///
/// p, q, c [Pa]: pressure, shear stress, shear strength at p = 0. What the tip opens is kept in eps_V^P, so that the
/// volume is known; it does not shift the pressure when the material closes again.
/// Source: Drucker & Prager (1952), doi:10.1090/qam/48291; non-associated map derived here.
struct DruckerPrager : HenckyElasticity {
  static constexpr std::string_view name = "drucker_prager",
                                    title = "Drucker–Prager, perfectly plastic, without plastic dilation",
                                    source = "Drucker & Prager (1952), doi:10.1090/qam/48291";
  static constexpr bool rate_dependent = false, dissipative = true;
  using State = Fields<field::PlasticVolumetricStrain>;
  using Derived = Fields<field::Friction>;

  struct Parameters : HenckyElasticity::Parameters {
    double M = 0.57735, c = 0;  // tan 30 deg
    static constexpr auto table() {
      return std::tuple_cat(
          HenckyElasticity::Parameters::table(),
          std::tuple{
              parameter(&Parameters::M, "M", "M", "1", "slope of the yield line", positive),
              parameter(&Parameters::c, "cohesion", "c", "Pa", "shear strength at p = 0", non_negative),
          });
    }
  };

  double M, c;
  explicit DruckerPrager(Parameters const& p) : HenckyElasticity(p), M(p.M), c(p.c) {}

  template <class Shape>
  [[nodiscard]] Record<double, State> initial() const {
    return {};
  }

  template <Scalar T, class Shape>
  [[nodiscard]] Symmetric<T, Shape> project(Symmetric<T, Shape> const& trial, Record<T, State>& state, T /*dt*/) const {
    auto const [p_tr, q_tr, dev] = split(trial);
    T const q_y = T(M) * p_tr + T(c);  // (1)
    auto const tip = q_y <= T(0.0);
    auto const plastic = q_tr > q_y;
    if (!any(plastic)) return trial;

    T const keep = select<T>(tip, 0.0, select<T>(plastic, q_y / max(q_tr, T(least_stress)), 1.0));  // (2)
    T const p = select<T>(tip, -c / M, p_tr);                                                       // (3)
    state[field::plastic_volumetric_strain] += T(1 / bulk<Shape>()) * (p - p_tr);
    auto const admissible = strain(p, keep, dev);
    Symmetric<T, Shape> eps = trial;
    for (int k = 0; k < eps.size; ++k) eps[k] = select<T>(plastic, admissible[k], trial[k]);
    return eps;
  }

  template <Scalar T, class Shape>
  [[nodiscard]] T yield(Symmetric<T, Shape> const& eps, Record<T, State> const& /*state*/) const {
    auto const [p, q, dev] = split(eps);
    return q - (T(M) * p + T(c));
  }

  /// Friction coefficient, for walls that take it from the material.
  template <Scalar T, class Shape>
  [[nodiscard]] T friction(Symmetric<T, Shape> const& /*eps*/, Record<T, State> const& /*state*/) const {
    return T(M);
  }
  template <Scalar T, class Shape>
  [[nodiscard]] Record<T, Derived> derive(Symmetric<T, Shape> const& eps, Record<T, State> const& state) const {
    return {{friction(eps, state)}};
  }
  template <Scalar T, class Shape>
  [[nodiscard]] T volume_ratio(Symmetric<T, Shape> const& eps, Record<T, State> const& state) const {
    return exp(T(trace(eps) + state[field::plastic_volumetric_strain]));
  }
};
static_assert(Law<DruckerPrager>);

}  // namespace talus::law
