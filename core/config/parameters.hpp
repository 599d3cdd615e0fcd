#pragma once
/// A parameter is declared once: member, name, symbol, unit, meaning, range.
///
/// Reading, checks, nearest-name hints, JSON Schema, the manual's tables and the echo of the resolved input all derive
/// from the table. This half knows no JSON, so that laws and other policies stay light.
///
///     struct Parameters {
///       double E = 1e6;                                        // the initialiser is the default
///       double nu = 0.3;
///       static constexpr auto table() {
///         return std::tuple{
///             parameter(&Parameters::E, "young_modulus", "E", "Pa", "Young's modulus", positive).validated(1e4, 1e9,
///             "..."), parameter(&Parameters::nu, "poisson_ratio", "nu", "1", "Poisson's ratio", open(-1,
///             0.5)).required()};
///       }
///       static std::optional<std::string> check(Parameters const& p);   // if there is a condition across members
///     };

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace talus {

/// An interval of numbers, each end within it or not. An infinite end is never within.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_is_open = true;
  bool high_is_open = true;

  [[nodiscard]] constexpr bool contains(double x) const {
    return (low_is_open ? low < x : low <= x) && (high_is_open ? x < high : x <= high);
  }
  [[nodiscard]] constexpr bool bounded_below() const { return low > -std::numeric_limits<double>::infinity(); }
  [[nodiscard]] constexpr bool bounded_above() const { return high < std::numeric_limits<double>::infinity(); }
};

/// Every finite number.
inline constexpr Range any_number{};
/// x > 0
inline constexpr Range positive{.low = 0};
/// x >= 0
inline constexpr Range non_negative{.low = 0, .low_is_open = false};
/// a < x < b
constexpr Range open(double a, double b) {
  return {a, b, true, true};
}
/// a <= x <= b
constexpr Range closed(double a, double b) {
  return {a, b, false, false};
}
/// a < x <= b
constexpr Range left_open(double a, double b) {
  return {a, b, true, false};
}
/// a <= x < b
constexpr Range right_open(double a, double b) {
  return {a, b, false, true};
}
/// a <= x
constexpr Range at_least(double a) {
  return {.low = a, .low_is_open = false};
}

/// How many entries a list may have.
struct Size {
  std::size_t least = 0;
  std::size_t most = std::numeric_limits<std::size_t>::max();
  bool per_axis = false;  ///< exactly one for each axis of the document's space
};

/// What a row of a table says, without the type of its member.
///
/// `range` is what is possible at all; outside it is a mistake. It holds for a number and for each number of a list.
/// `tried` is where the model was compared with something, by `source`, or where values usually lie, without a source;
/// outside it is a warning.
struct Description {
  std::string_view name = {}, symbol = {}, unit = {}, meaning = {};
  Range range = {};
  bool is_required = false;
  Range tried = {};
  std::string_view source = {};
  Size size = {};
};

/// One row of a table: what is said of a member, and the member.
template <class Owner, class Member>
struct Parameter : Description {
  using Type = Member;
  Member Owner::*member;

  /// The document must give it; the initialiser is then only a placeholder.
  [[nodiscard]] constexpr Parameter required() const {
    Parameter copy = *this;
    copy.is_required = true;
    return copy;
  }
  /// low <= x <= high was validated by `where` (author, year, doi).
  [[nodiscard]] constexpr Parameter validated(double low, double high, std::string_view where) const {
    Parameter copy = *this;
    copy.tried = closed(low, high);
    copy.source = where;
    return copy;
  }
  /// low <= x <= high in real materials; what lies outside is often in another unit.
  [[nodiscard]] constexpr Parameter usual(double low, double high) const {
    Parameter copy = *this;
    copy.tried = closed(low, high);
    return copy;
  }
  /// A list of `least` to `most` entries.
  [[nodiscard]] constexpr Parameter sized(std::size_t least, std::size_t most = Size{}.most) const {
    Parameter copy = *this;
    copy.size = {.least = least, .most = most};
    return copy;
  }
  /// A list with one entry for each axis of the document's space.
  [[nodiscard]] constexpr Parameter per_axis() const {
    Parameter copy = *this;
    copy.size = {.least = 2, .most = 3, .per_axis = true};
    return copy;
  }
};

/// A parameter with a unit ("1" if it has no dimension): a number, a list of numbers, coordinates.
template <class Owner, class Member>
[[nodiscard]] constexpr Parameter<Owner, Member> parameter(Member Owner::*member, std::string_view name,
                                                           std::string_view symbol, std::string_view unit,
                                                           std::string_view meaning, Range range = any_number) {
  return {{name, symbol, unit, meaning, range, false, any_number, {}, {}}, member};
}

/// A parameter that is no quantity: a name, a switch, a group, a choice, a list of those.
template <class Owner, class Member>
[[nodiscard]] constexpr Parameter<Owner, Member> parameter(Member Owner::*member, std::string_view name,
                                                           std::string_view meaning) {
  return {{name, {}, {}, meaning, any_number, false, any_number, {}, {}}, member};
}

/// One number for each axis of the document's space: a point [m], a direction, a velocity.
///
/// A default shorter than the space is filled with zeros, a longer one is cut.
struct Coordinates {
  std::vector<double> values;
  Coordinates() = default;
  Coordinates(std::initializer_list<double> numbers) : values(numbers) {}
  explicit Coordinates(std::vector<double> numbers) : values(std::move(numbers)) {}
  [[nodiscard]] std::size_t size() const { return values.size(); }
  [[nodiscard]] double operator[](std::size_t axis) const { return values[axis]; }
  bool operator==(Coordinates const&) const = default;
};

namespace detail {
template <class T>
inline constexpr bool is_table = false;
template <class... Owner, class... Member>
inline constexpr bool is_table<std::tuple<Parameter<Owner, Member>...>> = true;
}  // namespace detail

/// A struct that has a table of its parameters.
template <class P>
concept Described = std::default_initializable<P> && requires {
  requires detail::is_table<decltype(P::table())>;
};

/// A struct with a condition across its members: `check` says what is wrong, or nothing.
template <class P>
concept Checked = requires(P const& values) {
  { P::check(values) } -> std::same_as<std::optional<std::string>>;
};

/// Calls f(row) for every row of the table, in order.
template <Described P, class F>
constexpr void for_each_parameter(F&& f) {
  std::apply([&](auto const&... row) { (f(row), ...); }, P::table());
}

}  // namespace talus
