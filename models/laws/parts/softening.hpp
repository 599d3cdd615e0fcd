#pragma once
/// How the strengths of von Mises and Drucker–Prager fall with the plastic shear strain e = eps_dev^P.

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>

#include "core/config/parameters.hpp"
#include "core/scalar.hpp"
#include "models/laws/parts/fields.hpp"

namespace talus::law {

/// q_y = q_min + (q_max - q_min) exp(-xi e).
///
/// q_y [Pa]: shear strength; xi [1]: softening factor. Source: the form that larsblatny/matter documents (VMVisc); its
/// map is explicit in e, ours is not.
struct ShearSoftening {
  struct Parameters {
    double q_max = 1000, q_min = 500, xi = 10;
    static constexpr auto table() {
      return std::tuple{
          parameter(&Parameters::q_max, "peak_strength", "q_max", "Pa", "shear strength at first", positive),
          parameter(&Parameters::q_min, "residual_strength", "q_min", "Pa", "shear strength in the end, at most q_max",
                    non_negative),
          parameter(&Parameters::xi, "xi", "xi", "1", "softening factor; 0: the strength stays as it is", non_negative),
      };
    }
    static std::optional<std::string> check(Parameters const& p) {
      if (p.q_min <= p.q_max) return {};
      return "residual_strength must be at most peak_strength: the material softens";
    }
  };

  double q_max, q_min, xi;
  explicit ShearSoftening(Parameters const& p) : q_max(p.q_max), q_min(p.q_min), xi(p.xi) {}

  template <Scalar T>
  [[nodiscard]] T strength(T e) const {
    return T(q_min) + T(q_max - q_min) * exp(T(-xi * e));
  }
};

/// A cohesion c that stays.
struct ConstantCohesion {
  static constexpr bool softens = false;
  using State = Fields<>;
  struct Parameters {
    double c = 0;
    static constexpr auto table() {
      return std::tuple{parameter(&Parameters::c, "cohesion", "c", "Pa", "shear strength at p = 0", non_negative)};
    }
  };

  double c;
  explicit ConstantCohesion(Parameters const& p) : c(p.c) {}

  template <Scalar T>
  [[nodiscard]] T cohesion(T /*e*/) const {
    return T(c);
  }
};

/// A cohesion c exp(-xi e): the tip of the cone moves to p = 0 as the material is sheared.
struct SofteningCohesion {
  static constexpr bool softens = true;
  using State = Fields<field::PlasticShearStrain>;
  struct Parameters {
    double c = 100, xi = 10;
    static constexpr auto table() {
      return std::tuple{
          parameter(&Parameters::c, "cohesion", "c", "Pa", "shear strength at p = 0, at first", non_negative),
          parameter(&Parameters::xi, "xi", "xi", "1", "softening factor; 0: the cohesion stays", non_negative),
      };
    }
  };

  double c, xi;
  explicit SofteningCohesion(Parameters const& p) : c(p.c), xi(p.xi) {}

  template <Scalar T>
  [[nodiscard]] T cohesion(T e) const {
    return T(c) * exp(T(-xi * e));
  }
};

}  // namespace talus::law
