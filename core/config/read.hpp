#pragma once
/// Reading a document into described structs: every mistake is found, none stops the search.
///
///     Document const document = parse(text, "case.json");
///     Reader reader(document, 2);                              // in the plane: coordinates have two entries
///     Case const scene = read<Case>(document.value, reader);
///     reader.throw_if_mistaken();                              // InputError with all mistakes
///     for (Mistake const& warning : reader.warnings) ...       // outside what a model was validated for

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/config/outline.hpp"
#include "core/config/places.hpp"

namespace talus {

struct Document;

/// One thing in a document that is wrong, or suspect.
struct Mistake {
  std::string pointer;  ///< RFC 6901; of a missing member: where it should be
  Place place;          ///< in the text, of the pointer or of what should contain it; unknown for `--set`
  std::string found, expected;
  std::string advice;  ///< what to do; may be empty
  /// "document:line:column: pointer: found ...; expected: ...; advice"
  [[nodiscard]] std::string text(std::string_view document) const;
};

/// What reading needs to know, and what it found.
struct Reader {
  /// `dimension`: axes of the document's space, 2 or 3; 0 if not known yet, then coordinates may have 2 or 3 entries.
  /// Pre: the document outlives the reader.
  explicit Reader(Document const& document, int dimension = 0);

  std::string_view name;
  Places const& places;
  int dimension;
  std::vector<Mistake> mistakes, warnings;

  void refuse(std::string const& pointer, std::string found, std::string expected, std::string advice = {});
  void warn(std::string const& pointer, std::string found, std::string expected, std::string advice = {});
  /// Throws: InputError with the text of every mistake, one a line.
  void throw_if_mistaken() const;
};

/// Finds every mistake in a value, and what is outside the validated ranges. `value` is null if it was not given.
void examine(nlohmann::json const* value, Outline const& outline, Reader& reader, std::string const& pointer);

/// An integer 2 or 3 at this pointer of a document, 0 if there is none: the space, before anything else is read.
[[nodiscard]] int find_dimension(nlohmann::json const& document, std::string const& pointer);

namespace detail {

// The few things that are asked of a JSON value, compiled once. Pre: it was examined.
void take(nlohmann::json const& from, bool& into);
void take(nlohmann::json const& from, std::int64_t& into);
void take(nlohmann::json const& from, std::uint64_t& into);
void take(nlohmann::json const& from, double& into);
void take(nlohmann::json const& from, std::string& into);
void take(nlohmann::json const& from, AnyValue& into);
[[nodiscard]] nlohmann::json const* member(nlohmann::json const* object, std::string_view name);
[[nodiscard]] std::size_t entries(nlohmann::json const& list);
[[nodiscard]] nlohmann::json const& entry(nlohmann::json const& list, std::size_t index);
[[nodiscard]] std::string_view type_of(nlohmann::json const& choice);
[[nodiscard]] nlohmann::json const& root(Document const& document);

/// Fills values from JSON that has no mistakes; what is not given keeps its default, fitted to the space.
struct Filler {
  Reader& reader;

  template <class T>
  void fill(nlohmann::json const* given, T& into, std::string const& pointer) const {
    if constexpr (is_optional<T>) {
      if (given != nullptr) fill(given, into.emplace(), pointer);
    } else if constexpr (std::same_as<T, Coordinates>) {
      fill(given, into.values, pointer);
      if (reader.dimension > 0) into.values.resize(static_cast<std::size_t>(reader.dimension));
    } else if constexpr (ListMember<T>) {
      fill_list(given, into, pointer);
    } else if constexpr (is_choice<T>) {
      fill_choice(given, into, pointer);
    } else if constexpr (OpenChoiceMember<T>) {
      if (given != nullptr) into = T::read(*given, reader, pointer);
    } else if constexpr (Described<T>) {
      fill_members(given, into, pointer);
    } else if constexpr (IntegerMember<T>) {
      std::conditional_t<std::is_signed_v<T>, std::int64_t, std::uint64_t> wide = into;
      if (given != nullptr) take(*given, wide);
      into = static_cast<T>(wide);
    } else if (given != nullptr) {
      take(*given, into);
    }
  }

 private:
  template <class T>
  void fill_list(nlohmann::json const* given, std::vector<T>& into, std::string const& pointer) const {
    std::vector<T> list = given != nullptr ? std::vector<T>(entries(*given)) : into;
    for (std::size_t k = 0; k < list.size(); ++k) {
      T value = list[k];
      fill(given != nullptr ? &entry(*given, k) : nullptr, value, pointer + '/' + std::to_string(k));
      list[k] = std::move(value);
    }
    into = std::move(list);
  }

  template <class List>
  void fill_choice(nlohmann::json const* given, Choice<List>& into, std::string const& pointer) const {
    if (given == nullptr && into.is_empty()) return;
    auto const fill_policy = [&]<class Q>(std::type_identity<Q>, typename Q::Parameters parameters) {
      fill(given, parameters, pointer);
      into = Choice<List>::template of<Q>(std::move(parameters));
    };
    if (given == nullptr) {
      visit(Choice<List>(into), fill_policy);
    } else {
      for_each_type(List{}, [&]<class Q>(std::type_identity<Q> policy) {
        if (type_of(*given) == Q::name) fill_policy(policy, {});
      });
    }
  }

  template <Described P>
  void fill_members(nlohmann::json const* given, P& into, std::string const& pointer) const {
    for_each_parameter<P>([&]<class Row>(Row const& row) {
      auto& value = into.*row.member;
      fill(member(given, row.name), value, pointer + '/' + pointer_part(row.name));
      if constexpr (is_vector<typename Row::Type>) {
        if (row.size.per_axis && reader.dimension > 0) value.resize(static_cast<std::size_t>(reader.dimension));
      }
    });
    if constexpr (Checked<P>) {
      std::optional<std::string> const wrong = P::check(into);
      if (wrong) reader.refuse(pointer, *wrong, {});
    }
  }
};

}  // namespace detail

/// Reads a P from a value that stands at `pointer` of the reader's document. Mistakes and warnings are added to the
/// reader; if there are any mistakes, what is returned is only the defaults. Conditions across members (`check`) are
/// judged once the members themselves have no mistakes.
template <Described P>
[[nodiscard]] P read(nlohmann::json const& value, Reader& reader, std::string const& pointer = {}) {
  P values{};
  std::size_t const before = reader.mistakes.size();
  examine(&value, outline(values), reader, pointer);
  if (reader.mistakes.size() == before) detail::Filler{reader}.fill(&value, values, pointer);
  return values;
}

/// Reads a whole document. Throws: InputError with all mistakes. Warnings are dropped: use `read` to have them.
template <Described P>
[[nodiscard]] P read_or_throw(Document const& document, int dimension = 0) {
  Reader reader(document, dimension);
  P values = read<P>(detail::root(document), reader);
  reader.throw_if_mistaken();
  return values;
}

}  // namespace talus
