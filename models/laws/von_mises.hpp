#pragma once

#include <string_view>
#include <tuple>

#include "core/law.hpp"
#include "models/laws/parts/hencky.hpp"

namespace talus::law {

/// Von Mises, perfectly plastic.
///
///   y(q) = q - q_y <= 0                          (1)
///   p = p_tr,   q = min(q_tr, q_y)               (2)
///
/// q, q_y [Pa]: shear stress and shear strength in simple shear; the uniaxial strength in three dimensions is sqrt(3)
/// q_y. The plastic flow keeps the volume. Source: von Mises (1913), Nachr. Ges. Wiss. Göttingen, 582-592; radial
/// return: Wilkins (1964) (not re-read).
struct VonMises : HenckyElasticity {
  static constexpr std::string_view name = "von_mises", title = "Von Mises, perfectly plastic",
                                    source = "von Mises (1913); Wilkins (1964)";
  static constexpr bool rate_dependent = false, dissipative = true, associated = true;
  using State = Fields<>;
  using Derived = Fields<>;

  struct Parameters : HenckyElasticity::Parameters {
    double q_y = 1e3;
    static constexpr auto table() {
      return std::tuple_cat(
          HenckyElasticity::Parameters::table(),
          std::tuple{parameter(&Parameters::q_y, "shear_strength", "q_y", "Pa", "shear strength", positive)});
    }
  };

  double q_y;
  explicit VonMises(Parameters const& p) : HenckyElasticity(p), q_y(p.q_y) {}

  template <class Shape>
  [[nodiscard]] Record<double, State> initial() const {
    return {};
  }

  template <Scalar T, class Shape>
  [[nodiscard]] Symmetric<T, Shape> project(Symmetric<T, Shape> const& trial, Record<T, State>& /*state*/,
                                            T /*dt*/) const {
    auto const [p_tr, q_tr, dev] = split(trial);
    auto const plastic = q_tr > T(q_y);  // (1)
    T const keep = select<T>(plastic, q_y / max(q_tr, T(least_stress)), 1.0);
    auto const admissible = strain(p_tr, keep, dev);  // (2)
    Symmetric<T, Shape> eps = trial;
    for (int k = 0; k < eps.size; ++k) eps[k] = select<T>(plastic, admissible[k], trial[k]);
    return eps;
  }

  template <Scalar T, class Shape>
  [[nodiscard]] T yield(Symmetric<T, Shape> const& eps, Record<T, State> const& /*state*/) const {
    auto const [p, q, dev] = split(eps);
    return q - T(q_y);
  }

  template <Scalar T, class Shape>
  [[nodiscard]] Record<T, Derived> derive(Symmetric<T, Shape> const& /*eps*/, Record<T, State> const& /*state*/) const {
    return {};
  }
  template <Scalar T, class Shape>
  [[nodiscard]] T volume_ratio(Symmetric<T, Shape> const& eps, Record<T, State> const& /*state*/) const {
    return exp(trace(eps));
  }
};
static_assert(Law<VonMises>);

}  // namespace talus::law
