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

/// Failure in tension that leaves no stress.
///
///   p_tr < -p_t exp(-xi_t eps_V^P):   eps <- 0,   eps_V^P += tr(eps_tr)
///
/// p_t [Pa]: tensile strength, which falls as the material opens. Source: larsblatny/matter (VMVisc).
struct TensionCutOff {
  struct Parameters {
    double p_t = 1000, xi_t = 0;
    static constexpr auto table() {
      return std::tuple{
          parameter(&Parameters::p_t, "tensile_strength", "p_t", "Pa", "tension at which the material fails",
                    non_negative),
          parameter(&Parameters::xi_t, "tensile_softening", "xi_t", "1", "loss of tensile strength with plastic volume",
                    non_negative),
      };
    }
  };

  double p_t, xi_t;
  explicit TensionCutOff(Parameters const& p) : p_t(p.p_t), xi_t(p.xi_t) {}

  /// Strength in tension [Pa], at most p_t: material that was packed is not stronger.
  template <Scalar T>
  [[nodiscard]] T strength(T eps_V) const {
    return T(p_t) * exp(min(T(0.0), T(-xi_t * eps_V)));
  }
};

/// Von Mises with softening and a tension cut-off, times a rate law.
///
///   y(q) = q - q_y(e) <= 0                                                       q_y by ShearSoftening   (1)
///   p = p_tr,   q = relax(q_tr, q_y(e)),   e = e_n + (q_tr - q)/(sqrt(2) G)      q_y at the end          (2)
///   eps = 0,   eps_V^P += tr(eps_tr),   e = e_n + q_tr/(sqrt(2) G)               TensionCutOff, at once   (3)
///
/// What opened in (3) does not have to close again. The cut-off knows no viscosity.
///
/// p, q, q_y [Pa]: pressure, shear stress, shear strength in simple shear; e = eps_dev^P [1].
/// Source: von Mises (1913), Nachr. Ges. Wiss. Göttingen, 582-592; (1), (3): larsblatny/matter (VMVisc).
template <class Rate>
struct Cylinder : HenckyElasticity {
  static constexpr bool rate_dependent = Rate::rate_dependent, dissipative = true, brittle = true;
  using State = Fields<field::PlasticVolumetricStrain, field::PlasticShearStrain>;
  using Derived = typename Rate::Derived;

  struct Parameters : HenckyElasticity::Parameters,
                      ShearSoftening::Parameters,
                      TensionCutOff::Parameters,
                      Rate::Parameters {
    static constexpr auto table() {
      return std::tuple_cat(HenckyElasticity::Parameters::table(), ShearSoftening::Parameters::table(),
                            TensionCutOff::Parameters::table(), Rate::Parameters::table());
    }
    static std::optional<std::string> check(Parameters const& p) { return ShearSoftening::Parameters::check(p); }
  };

  ShearSoftening softening;
  TensionCutOff cut_off;
  Rate rate;
  explicit Cylinder(Parameters const& p) : HenckyElasticity(p), softening(p), cut_off(p), rate(p) {}

  template <class Shape>
  [[nodiscard]] Record<double, State> initial() const {
    return {};
  }

  template <Scalar T, class Shape>
  [[nodiscard]] Symmetric<T, Shape> project(Symmetric<T, Shape> const& trial, Record<T, State>& state, T dt) const {
    auto const [p_tr, q_tr, dev] = split(trial);
    T& eps_V = state[field::plastic_volumetric_strain];
    T& e = state[field::plastic_shear_strain];
    auto const torn = p_tr < -cut_off.strength(eps_V);
    auto const plastic = q_tr > softening.strength(e);
    if (!any(torn || plastic)) return trial;

    T const e_n = e;
    auto const surface = [&, p = p_tr](auto e_end) { return point(decltype(e_end)(p), e_end); };
    T const flowed = rate.share(q_tr, radial_return(rate, q_tr, e_n, G, dt, surface, plastic), dt);  // (2)
    T const q = select<T>(torn, 0.0, select<T>(plastic, min(q_tr, flowed), q_tr));                   // (3)
    e += T(1 / (std::sqrt(2.0) * G)) * (q_tr - q);
    eps_V += select<T>(torn, trace(trial), 0.0);
    auto const sheared = strain(p_tr, T(q / max(q_tr, T(least_stress))), dev);
    Symmetric<T, Shape> eps = trial;
    for (int k = 0; k < eps.size; ++k) eps[k] = select<T>(torn, 0.0, select<T>(plastic, sheared[k], trial[k]));
    return eps;
  }

  template <Scalar T, class Shape>
  [[nodiscard]] T yield(Symmetric<T, Shape> const& eps, Record<T, State> const& state) const {
    auto const [p, q, dev] = split(eps);
    T const in_tension = -p - cut_off.strength(state[field::plastic_volumetric_strain]);
    return max(in_tension, T(q - softening.strength(state[field::plastic_shear_strain])));
  }
  [[nodiscard]] bool viscous() const requires rate_dependent { return rate.viscous(); }

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
  /// The surface at e: S is the shear strength.
  template <Scalar T>
  [[nodiscard]] EllipsePoint<T> point(T p, T e) const {
    return {p, T(0.0), T(0.0), softening.strength(e)};
  }
  /// The point of the surface that the flow law speaks of: of this strength, or where flow without end would lead.
  template <Scalar T, class Shape>
  [[nodiscard]] EllipsePoint<T> reference(Symmetric<T, Shape> const& eps, Record<T, State> const& state) const {
    Record<T, State> rested = state;
    if constexpr (Rate::shares_flow) (void)project(eps, rested, T(std::numeric_limits<double>::max()));
    return point(split(eps).p, rested[field::plastic_shear_strain]);
  }
};

}  // namespace talus::law
