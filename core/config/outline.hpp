#pragma once
/// What a document may hold, as data: made once from the tables, and all that judges or explains a document works on
/// it.

#include <algorithm>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/config/choice.hpp"
#include "core/config/kinds.hpp"
#include "core/config/parameters.hpp"
#include "core/config/write.hpp"

namespace talus {

/// The kinds of values. A `list` has entries of one kind, a `group` has named parameters, a `choice` has a "type".
enum class Kind { number, integer, boolean, text, any, list, group, choice };

struct Outline;

/// One of the policies of a choice.
struct Alternative {
  std::string_view name, title, source;
  std::vector<Outline> parameters;
};

/// A parameter, or a whole document, with all that is below it.
struct Outline {
  Description row;
  Kind kind = Kind::group;
  Range possible;                         ///< number, integer: the range of the table within that of the C++ type
  bool is_optional = false;               ///< may be left out, and then is not there at all
  std::vector<Outline> parts;             ///< group: its parameters; list: one, what an entry is
  std::vector<Alternative> alternatives;  ///< choice
  std::shared_ptr<nlohmann::json const> initial;  ///< the default; none if the document must give the value
};

/// Whether a document without this parameter is mistaken: it or something within it is required.
[[nodiscard]] bool must_be_given(Outline const& outline);

/// A range in words of mathematics: "-1 < x < 0.5", "x > 0"; "any" if it has no ends.
[[nodiscard]] std::string to_text(Range const& range);
/// The shortest decimal that gives the same double.
[[nodiscard]] std::string to_text(double number);

namespace detail {

[[nodiscard]] std::shared_ptr<nlohmann::json> new_json();
[[nodiscard]] Range common_part(Range const& a, Range const& b);

template <Described P>
constexpr bool names_are_distinct() {
  bool distinct = true;
  std::apply(
      [&](auto const&... row) {
        std::string_view const names[] = {row.name..., ""};
        for (std::size_t i = 0; i < sizeof...(row); ++i) {
          for (std::size_t j = 0; j < i; ++j) distinct = distinct && names[i] != names[j];
        }
      },
      P::table());
  return distinct;
}

template <class T>
Outline outline_of(T const& initial, Description const& row);

template <Described P>
std::vector<Outline> outline_of_members(P const& initial) {
  static_assert(names_are_distinct<P>(), "two parameters of one table have the same name");
  std::vector<Outline> parts;
  for_each_parameter<P>([&](auto const& row) { parts.push_back(outline_of(initial.*row.member, row)); });
  return parts;
}

template <class P>
Alternative outline_of_policy() {
  return {P::name, P::title, source_of<P>(), outline_of_members(typename P::Parameters{})};
}

template <class... P>
std::vector<Alternative> outline_of_policies(TypeList<P...>) {
  return {outline_of_policy<P>()...};
}

/// An entry of a list: what the list says of its numbers holds for each of them.
inline Description row_of_entry(Description const& list) {
  return {.unit = list.unit, .range = list.range, .tried = list.tried, .source = list.source};
}

/// Fills in the kind of T and what is below it.
template <class T>
void outline_kind(T const& initial, Outline& outline) {
  Description const& row = outline.row;
  if constexpr (ListMember<T>) {
    outline.kind = Kind::list;
    outline.parts.push_back(outline_of(EntryOf<T>{}, row_of_entry(row)));
    outline.parts.back().initial = nullptr;
  } else if constexpr (is_choice<T>) {
    outline.kind = Kind::choice;
    outline.alternatives = outline_of_policies(typename T::Policies{});
  } else if constexpr (OpenChoiceMember<T>) {
    outline.kind = Kind::choice;
    outline.alternatives = T::alternatives();
  } else if constexpr (Described<T>) {
    outline.kind = Kind::group;
    outline.parts = outline_of_members(initial);
  } else if constexpr (IntegerMember<T>) {
    outline.kind = Kind::integer;
    outline.possible = common_part(row.range, range_of_type<T>());
  } else if constexpr (std::same_as<T, double>) {
    outline.kind = Kind::number;
    outline.possible = row.range;
  } else if constexpr (std::same_as<T, AnyValue>) {
    outline.kind = Kind::any;
  } else if constexpr (std::same_as<T, bool>) {
    outline.kind = Kind::boolean;
  } else {
    static_assert(std::same_as<T, std::string>, "a table cannot hold a member of this type");
    outline.kind = Kind::text;
  }
}

/// Whether an initialiser is a value for a document. A group has none of its own: its members have.
template <class T>
bool is_default(T const& initial) {
  if constexpr (ChoiceMember<T>) return !initial.is_empty();
  return !Described<T>;
}

/// A default as documents of the plane have it: coordinates have at least two entries.
template <class T>
T fit_to_plane(T initial) {
  if constexpr (std::same_as<T, Coordinates>) initial.values.resize(std::max(initial.size(), std::size_t{2}));
  return initial;
}

template <class T>
Outline outline_of(T const& initial, Description const& row) {
  if constexpr (is_optional<T>) {
    Outline outline = outline_of(typename T::value_type{}, row);
    outline.is_optional = !row.is_required;
    outline.initial = nullptr;
    return outline;
  } else {
    Outline outline;
    outline.row = row;
    if constexpr (std::same_as<T, Coordinates>) outline.row.size = {.least = 2, .most = 3, .per_axis = true};
    outline_kind(initial, outline);
    if (!row.is_required && is_default(initial)) {
      auto const value = new_json();
      write(fit_to_plane(initial), *value);
      outline.initial = value;
    }
    return outline;
  }
}

}  // namespace detail

/// What a document that fills a P may hold.
template <Described P>
[[nodiscard]] Outline outline(P const& initial = {}) {
  return detail::outline_of(initial, {});
}

}  // namespace talus
