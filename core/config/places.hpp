#pragma once
/// Where in a text the parts of a JSON document stand, by JSON pointer (RFC 6901).

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace talus {

/// Line and column of a character, both from 1; the column counts characters, not bytes. Line 0: not in the text.
struct Place {
  std::size_t line = 0, column = 0;
  [[nodiscard]] bool is_known() const { return line > 0; }
  bool operator==(Place const&) const = default;
};

/// The place of a byte of a text. Pre: the text is UTF-8.
[[nodiscard]] Place place_in(std::string_view text, std::size_t byte);

/// A name as one part of a JSON pointer: "~" and "/" escaped.
[[nodiscard]] std::string pointer_part(std::string_view name);

/// The places of all parts of a document: of a member its name, of an entry of a list its first character.
class Places {
 public:
  Places() = default;
  /// Pre: the text is valid JSON without a byte order mark. A name that is given twice in one object is kept in
  /// `duplicates()`.
  explicit Places(std::string_view text);

  /// The place of a part, unknown if it has none.
  [[nodiscard]] Place at(std::string const& pointer) const;
  /// The place of a part, or of the smallest part that has a place and would contain it.
  [[nodiscard]] Place near(std::string pointer) const;
  /// From now on a part, and all within it, does not come from the text: its place is unknown.
  void forget(std::string const& pointer);

  struct Duplicate {
    std::string pointer;
    Place first, second;
  };
  [[nodiscard]] std::vector<Duplicate> const& duplicates() const { return duplicates_; }

 private:
  friend class Scan;
  std::unordered_map<std::string, Place> places_;
  std::vector<Duplicate> duplicates_;
};

}  // namespace talus
