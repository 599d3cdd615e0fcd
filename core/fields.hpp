#pragma once
/// Fields are types: a policy names the particle fields it owns, a scene's store is their union.
///
/// The same tag drives storage, output, restart, the symbol table and `talus explain`.

#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "core/scalar.hpp"

namespace talus {

/// How many numbers a field has a particle: 1, D, D*D, or as many as the strain of the kinematics.
enum class Rank { scalar, vector, matrix, strain };

/// What the program knows of a field at run time, made from its type.
struct FieldInfo {
  std::string_view name, symbol, unit, meaning;
  Rank rank = Rank::scalar;
  /// Numbers a particle in D dimensions with a strain of `strain_size` entries.
  [[nodiscard]] constexpr int components(int D, int strain_size) const {
    switch (rank) {
      case Rank::scalar:
        return 1;
      case Rank::vector:
        return D;
      case Rank::matrix:
        return D * D;
      case Rank::strain:
        return strain_size;
    }
    return 0;
  }
};

struct ScalarField {
  static constexpr Rank rank = Rank::scalar;
};
struct VectorField {
  static constexpr Rank rank = Rank::vector;
};
struct MatrixField {
  static constexpr Rank rank = Rank::matrix;
};
struct StrainField {
  static constexpr Rank rank = Rank::strain;
};

template <class F>
concept Field = requires {
  { F::name } -> std::convertible_to<std::string_view>;
  { F::symbol } -> std::convertible_to<std::string_view>;
  { F::unit } -> std::convertible_to<std::string_view>;
  { F::meaning } -> std::convertible_to<std::string_view>;
  { F::rank } -> std::convertible_to<Rank>;
};

template <Field F>
constexpr FieldInfo info_of() {
  return {F::name, F::symbol, F::unit, F::meaning, F::rank};
}

/// A list of fields.
template <Field... F>
struct Fields {
  static constexpr std::size_t count = sizeof...(F);
  template <Field G>
  static constexpr bool holds = (std::same_as<F, G> || ...);
  /// Place of a field in the list.
  template <Field G>
  static constexpr std::size_t index = [] {
    static_assert(holds<G>, "the field is not in this list of fields");
    std::size_t at = 0, k = 0;
    ((std::same_as<F, G> ? (at = k, ++k) : ++k), ...);
    return at;
  }();
};

namespace detail {
template <class Done, class... Lists>
struct UniteInto {
  using Type = Done;
};
template <class... Done, class... Rest>
struct UniteInto<Fields<Done...>, Fields<>, Rest...> {
  using Type = typename UniteInto<Fields<Done...>, Rest...>::Type;
};
template <class... Done, class First, class... Others, class... Rest>
struct UniteInto<Fields<Done...>, Fields<First, Others...>, Rest...> {
  using Longer = std::conditional_t<(std::same_as<Done, First> || ...), Fields<Done...>, Fields<Done..., First>>;
  using Type = typename UniteInto<Longer, Fields<Others...>, Rest...>::Type;
};
}  // namespace detail

/// The union of lists of fields, each field once, in the order of first mention.
template <class... Lists>
using Unite = typename detail::UniteInto<Fields<>, Lists...>::Type;

/// One scalar for each field of a list: what a law carries of a particle between steps. `record[field::x]`.
template <Scalar T, class List>
struct Record;
template <Scalar T, Field... F>
struct Record<T, Fields<F...>> {
  static_assert(((F::rank == Rank::scalar) && ...), "a record holds scalar fields");
  std::array<T, sizeof...(F)> values{};
  template <Field G>
  T& operator[](G) {
    return values[Fields<F...>::template index<G>];
  }
  template <Field G>
  T const& operator[](G) const {
    return values[Fields<F...>::template index<G>];
  }
};

namespace field {
inline constexpr struct Position : VectorField {
  static constexpr std::string_view name = "position", symbol = "x_p", unit = "m", meaning = "position";
} position;
inline constexpr struct Velocity : VectorField {
  static constexpr std::string_view name = "velocity", symbol = "v_p", unit = "m/s", meaning = "velocity";
} velocity;
inline constexpr struct Mass : ScalarField {
  static constexpr std::string_view name = "mass", symbol = "m_p", unit = "kg",
                                    meaning = "mass; its volume V_p^0 is mass over the material's density";
} mass;
inline constexpr struct ElasticStrain : StrainField {
  static constexpr std::string_view name = "elastic_strain", symbol = "eps_p", unit = "1",
                                    meaning = "elastic logarithmic (Hencky) strain, tension positive";
} elastic_strain;
inline constexpr struct Identity : ScalarField {
  static constexpr std::string_view name = "id", symbol = "id", unit = "1",
                                    meaning = "number of the particle as seeded; kept for output";
} identity;
}  // namespace field

}  // namespace talus
