#pragma once
/// The echo: described values as JSON, all defaults filled in. Reading it gives the same bits.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/config/any_value.hpp"
#include "core/config/choice.hpp"
#include "core/config/kinds.hpp"
#include "core/config/parameters.hpp"

namespace talus {

namespace detail {
// The few things that are done to a JSON value, compiled once: users of this page need not read the JSON library.
void put(nlohmann::json& into, bool value);
void put(nlohmann::json& into, std::int64_t value);
void put(nlohmann::json& into, std::uint64_t value);
/// Throws: InputError for a number that is not finite.
void put(nlohmann::json& into, double value);
void put(nlohmann::json& into, std::string const& value);
void put(nlohmann::json& into, AnyValue const& value);
void put_empty_object(nlohmann::json& into);
void put_empty_list(nlohmann::json& into);
/// A new member, still null.
[[nodiscard]] nlohmann::json& new_member(nlohmann::json& object, std::string_view name);
/// A new last entry, still null.
[[nodiscard]] nlohmann::json& new_entry(nlohmann::json& list);
}  // namespace detail

/// Writes a value of any kind that a table may hold. Within an object, an optional that is empty is left out.
/// Throws: InputError for a choice that is empty and for a number that is not finite.
template <class T>
void write(T const& value, nlohmann::json& into);

namespace detail {

template <Described P>
void write_members(P const& values, nlohmann::json& object) {
  for_each_parameter<P>([&]<class Row>(Row const& row) {
    if constexpr (is_optional<typename Row::Type>) {
      if (!(values.*row.member).has_value()) return;
    }
    if constexpr (ChoiceMember<typename Row::Type>) {
      if ((values.*row.member).is_empty()) return;
    }
    write(values.*row.member, new_member(object, row.name));
  });
}

}  // namespace detail

template <class T>
void write(T const& value, nlohmann::json& into) {
  if constexpr (is_optional<T>) {
    if (value) write(*value, into);
  } else if constexpr (std::same_as<T, Coordinates>) {
    write(value.values, into);
  } else if constexpr (ListMember<T>) {
    detail::put_empty_list(into);
    for (EntryOf<T> const& entry : value) write<EntryOf<T>>(entry, detail::new_entry(into));
  } else if constexpr (ChoiceMember<T>) {
    detail::put_empty_object(into);
    detail::put(detail::new_member(into, "type"), std::string(value.name()));
    if constexpr (OpenChoiceMember<T>)
      value.write_parameters(into);
    else
      visit(value, [&](auto, auto const& parameters) { detail::write_members(parameters, into); });
  } else if constexpr (Described<T>) {
    detail::put_empty_object(into);
    detail::write_members(value, into);
  } else if constexpr (IntegerMember<T>) {
    detail::put(into, static_cast<std::conditional_t<std::is_signed_v<T>, std::int64_t, std::uint64_t>>(value));
  } else {
    detail::put(into, value);
  }
}

}  // namespace talus
