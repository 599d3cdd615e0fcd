#pragma once
/// Strict reading of JSON text (RFC 8259), and changes to a document from the command line.

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/config/places.hpp"

namespace talus {

/// Objects and lists may be nested this deep.
inline constexpr std::size_t deepest_nesting = 200;

/// A JSON document: its values, where they stand in its text, and the name of the text for messages.
struct Document {
  std::string name;
  nlohmann::json value;
  Places places;
};

/// Reads a text. A byte order mark and any line ends are accepted.
///
/// Throws: InputError, with line, column and what to do, for an empty text, a comment, a comma too many, a name given
/// twice, NaN or infinity, a number beyond double, bytes that are not UTF-8, and nesting beyond `deepest_nesting`.
[[nodiscard]] Document parse(std::string_view text, std::string name);

/// The same of what a program wrote: what is no JSON `is_discarded()`, and nobody is told why. Compiled once, as every
/// unit that names nlohmann's parser compiles it anew.
[[nodiscard]] nlohmann::json json_of(std::string_view text);

/// Changes one value of a document: "/pointer=value", as in `--set /time/end=2.5`.
///
/// The value is JSON by the same strict rules; what is not JSON but a bare word (a letter, then letters, digits and
/// `_ - . /`) is a string, so that no quotes have to be saved from the shell. Members that are missing on the way are
/// made; entries of lists must exist.
/// Throws: InputError if the pointer or the value cannot be understood, or leads through something without parts.
void set_value(nlohmann::json& document, std::string_view assignment);

/// The same, and forgets the place in the text: messages about this value name no line.
void set_value(Document& document, std::string_view assignment);

}  // namespace talus
