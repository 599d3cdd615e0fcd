#pragma once
/// The kinds of members that a table may hold.

#include <concepts>
#include <cstdint>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/config/choice.hpp"
#include "core/config/parameters.hpp"

namespace talus {

namespace detail {
template <class T>
struct Entry {};
template <class T>
struct Entry<std::vector<T>> {
  using Type = T;
};
template <>
struct Entry<Coordinates> {
  using Type = double;
};
}  // namespace detail

/// What a list is made of.
template <class T>
using EntryOf = typename detail::Entry<T>::Type;

/// A vector of anything, or coordinates.
template <class T>
concept ListMember = requires {
  typename EntryOf<T>;
};

template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

template <class T>
inline constexpr bool is_choice = false;
template <class List>
inline constexpr bool is_choice<Choice<List>> = true;

/// A choice among policies that are known by name alone (core/config/open_choice.hpp).
template <class T>
concept OpenChoiceMember = requires(T const& choice, nlohmann::json& object) {
  choice.write_parameters(object);
  T::alternatives();
};

/// A member that a "type" chooses.
template <class T>
concept ChoiceMember = is_choice<T> || OpenChoiceMember<T>;

template <class T>
concept IntegerMember = std::integral<T> && !std::same_as<T, bool>;

/// The numbers that an integer type holds and that a double holds as well: for 64 bits, the last few are left out.
template <IntegerMember T>
constexpr Range range_of_type() {
  double const low = static_cast<double>(std::numeric_limits<T>::min());
  if constexpr (sizeof(T) < sizeof(std::int64_t)) {
    return closed(low, static_cast<double>(std::numeric_limits<T>::max()));
  } else {
    constexpr int lost = std::numeric_limits<T>::digits - std::numeric_limits<double>::digits;
    return closed(low, static_cast<double>(std::numeric_limits<T>::max() >> lost << lost));
  }
}

}  // namespace talus
