#include "core/law.hpp"

#include <boost/test/unit_test.hpp>
#include <string_view>
#include <tuple>

BOOST_AUTO_TEST_SUITE(law)

using namespace talus;

namespace {

/// As little as a law can be.
struct Stone {
  static constexpr std::string_view name = "stone", title = "Stone", source = "none";
  static constexpr bool rate_dependent = false, dissipative = true;
  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };
  using State = Fields<>;
  using Derived = Fields<>;
  explicit Stone(Parameters const&) {}
  template <Scalar T, class Shape>
  Symmetric<T, Shape> stress(Symmetric<T, Shape> const& eps) const {
    return eps;
  }
  template <Scalar T, class Shape>
  T energy(Symmetric<T, Shape> const& eps) const {
    return T(0.5) * contract(eps, eps);
  }
  template <Scalar T, class Shape>
  Symmetric<T, Shape> project(Symmetric<T, Shape> const& trial, Record<T, State>&, T) const {
    return trial;
  }
  template <Scalar T, class Shape>
  T yield(Symmetric<T, Shape> const&, Record<T, State> const&) const {
    return T(-1.0);
  }
  template <Scalar T, class Shape>
  Record<T, Derived> derive(Symmetric<T, Shape> const&, Record<T, State> const&) const {
    return {};
  }
  template <Scalar T, class Shape>
  T volume_ratio(Symmetric<T, Shape> const& eps, Record<T, State> const&) const {
    return exp(trace(eps));
  }
  template <class Shape>
  double volumetric_modulus() const {
    return 1;
  }
  double stiffest_modulus(int) const { return 1; }
  double wave_modulus() const { return 1; }
  template <class Shape>
  Record<double, State> initial() const {
    return {};
  }
};

struct Nameless : Stone {
  using Stone::Stone;
  static constexpr int name = 0;
};
struct WithoutParameters : Stone {
  using Stone::Stone;
  using Parameters = void;
};
struct WithoutStatement : Stone {
  using Stone::Stone;
  static constexpr std::tuple<> dissipative{};
};
struct ForPlainNumbersOnly : Stone {
  using Stone::Stone;
  Symmetric<double, shape::Solid> stress(Symmetric<double, shape::Solid> const& eps) const { return eps; }
};
struct OfMixedShape : Stone {
  using Stone::Stone;
  template <Scalar T, class Shape>
  Symmetric<T, shape::Solid> project(Symmetric<T, Shape> const&, Record<T, State>&, T) const {
    return {};
  }
};
struct ThatForgetsItsState : Stone {
  using Stone::Stone;
  template <class Shape>
  double initial() const {
    return 0;
  }
};

static_assert(Law<Stone>);
static_assert(!Law<Nameless>);
static_assert(!Law<WithoutParameters>);
static_assert(!Law<WithoutStatement>);
static_assert(!Law<ForPlainNumbersOnly>);
static_assert(!Law<OfMixedShape>);
static_assert(!Law<ThatForgetsItsState>);
static_assert(!Law<int>);

}  // namespace

BOOST_AUTO_TEST_CASE(invariants_are_those_of_the_stress_that_the_law_gives) {
  Stone const stone(Stone::Parameters{});
  Symmetric<double, shape::Solid> eps{{-3, -1, -2, 0, 0, 0}};
  auto const [p, q] = invariants(stone, eps);
  BOOST_TEST(p == 2);
  BOOST_TEST(q == 1);  // deviator (-1, 1, 0), half its square is 1
}

BOOST_AUTO_TEST_SUITE_END()
