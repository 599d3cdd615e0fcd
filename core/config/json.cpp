#include "core/config/json.hpp"

#include <cctype>
#include <optional>

#include "core/errors.hpp"

namespace talus {

namespace {

using nlohmann::json;

constexpr std::string_view blanks = " \t\r\n";

/// Listens to a parser only for the first thing that is wrong.
struct Syntax {
  struct Fault {
    std::size_t last;   ///< the byte, from 1, at which the parser stopped
    std::string token;  ///< what it had read of a token
    std::string detail;
    bool overflows;  ///< not an error of syntax: a number beyond double
    [[nodiscard]] bool mentions(std::string_view words) const { return detail.find(words) != detail.npos; }
  };
  std::optional<Fault> fault;

  bool null() { return true; }
  bool boolean(bool) { return true; }
  bool number_integer(json::number_integer_t) { return true; }
  bool number_unsigned(json::number_unsigned_t) { return true; }
  bool number_float(json::number_float_t, std::string const&) { return true; }
  bool string(std::string&) { return true; }
  bool binary(json::binary_t&) { return true; }
  bool start_object(std::size_t) { return true; }
  bool key(std::string&) { return true; }
  bool end_object() { return true; }
  bool start_array(std::size_t) { return true; }
  bool end_array() { return true; }
  bool parse_error(std::size_t last, std::string const& token, json::exception const& what) {
    std::string_view const text = what.what();
    std::size_t const first = text.find("syntax error");  // what comes before is a place, counted in another way
    std::size_t const end = text.find("; last read");     // what comes after may be half a character
    bool const overflows = first == text.npos;
    fault = Fault{last, token, std::string(overflows ? text : text.substr(first, end - first)), overflows};
    return false;
  }
};

[[noreturn]] void refuse(std::string const& name, std::string_view text, std::size_t byte, std::string const& what) {
  Place const place = place_in(text, byte);
  throw InputError(name + ':' + std::to_string(place.line) + ':' + std::to_string(place.column) + ": " + what);
}

/// The byte at which objects and lists are nested too deep, if there is one.
std::optional<std::size_t> too_deep(std::string_view text) {
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    char const c = text[at];
    if (c == '"') in_string = !in_string;
    if (in_string && c == '\\') ++at;
    if (in_string) continue;
    if ((c == '{' || c == '[') && ++depth > deepest_nesting) return at;
    if ((c == '}' || c == ']') && depth > 0) --depth;
  }
  return {};
}

/// Whether a number, true, false, null or a bare word goes on with this character.
bool goes_on(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '+' || c == '-';
}

/// The first byte of the token at whose byte `last` the parser stopped.
std::size_t begin_of_token(Syntax::Fault const& fault, std::string_view text, std::size_t last) {
  std::size_t const length = fault.token.size();
  bool const is_string = text[last] == '"' && length > 1 && length <= last + 1 && fault.token.front() == '"';
  if (is_string && text.substr(last + 1 - length, length) == fault.token) return last + 1 - length;
  if (fault.mentions("invalid string")) return last;
  std::size_t first = last;
  if (fault.mentions("invalid number") && !goes_on(text[first])) --first;
  if (goes_on(text[first])) {
    while (first > 0 && goes_on(text[first - 1])) --first;
  }
  return first;
}

/// What is wrong with the token that begins with `rest`, in words; empty if only the parser can tell.
/// `before` is the last character before it that is no blank, NUL if there is none.
std::string advice(Syntax::Fault const& fault, std::string_view rest, char before) {
  char const c = rest.front();
  if (fault.overflows) return "the number is too large for a double (at most about 1.8e308)";
  if (fault.mentions("UTF-8")) return "bytes that are not UTF-8; save the file as UTF-8";
  if (fault.mentions("control character"))
    return "a text may not hold a line break or a tab; write \\n or \\t, or close it";
  if (fault.mentions("invalid string")) return {};
  if (c == '/' || c == '#') return "comments are not allowed; remove it";
  if (fault.mentions("expected end of input")) return "there is more after the end of the document; remove it";
  if (c == '\'') return "names and texts stand in double quotes (\")";
  if ((c == '}' || c == ']') && before == ',') return "the comma before this bracket is one too many; remove it";
  if (c == ',' || c == '}' || c == ']') return {};
  if (fault.mentions("expected ':'")) return "a colon is missing before this";
  if (fault.mentions("while parsing object key")) return "a name in double quotes (\") is needed here";
  if (fault.mentions("expected ','") || goes_on(before) || before == '"' || before == '}' || before == ']') {
    return "a comma is missing before this";
  }
  std::string_view const word = rest.substr(0, rest.find_first_of(" \t\r\n,:{}[]\""));
  if (word.find_first_of("Nn") != word.npos && word.find_first_of("0123456789") == word.npos && word != "null") {
    return "no value of JSON (NaN and infinity are not allowed); write a finite number";
  }
  if (c == '.' || c == '+' || c == '-' || std::isdigit(static_cast<unsigned char>(c)) != 0) {
    return "no number of JSON; write it like 0.5, -2 or 1e-3";
  }
  return "a text needs double quotes (\"); true, false and null are in lower case";
}

[[noreturn]] void refuse_syntax(Syntax::Fault const& fault, std::string_view text, std::string const& name) {
  std::size_t const last = fault.last > 0 ? fault.last - 1 : 0;
  if (last >= text.size()) {
    refuse(name, text, text.size(), "the text ends too early; a bracket or quote is not closed");
  }
  std::size_t const first = begin_of_token(fault, text, last);
  std::size_t const previous = first == 0 ? text.npos : text.find_last_not_of(blanks, first - 1);
  std::string const hint = advice(fault, text.substr(first), previous == text.npos ? '\0' : text[previous]);
  refuse(name, text, first, hint.empty() ? fault.detail : hint);
}

json parse_value(std::string_view text, std::string const& name) {
  if (text.find_first_not_of(blanks) == text.npos) {
    throw InputError(name + ": is empty; a JSON document is needed, at least {}");
  }
  if (auto const at = too_deep(text)) {
    refuse(name, text, *at, "nested deeper than " + std::to_string(deepest_nesting) + " levels; is a bracket missing?");
  }
  if (auto const at = text.find('\0'); at != text.npos) {
    refuse(name, text, at, "a NUL character; save the file as plain UTF-8 text");
  }
  Syntax syntax;
  json::sax_parse(text, &syntax);
  if (syntax.fault) refuse_syntax(*syntax.fault, text, name);
  return json_of(text);
}

void refuse_duplicates(Places const& places, std::string const& name) {
  std::string all;
  for (auto const& duplicate : places.duplicates()) {
    if (!all.empty()) all += '\n';
    std::string const pointer = json(duplicate.pointer).dump();  // a terminal obeys no control character in it
    all += name + ':' + std::to_string(duplicate.second.line) + ':' + std::to_string(duplicate.second.column) + ": " +
           pointer.substr(1, pointer.size() - 2) + ": given twice, first in line " +
           std::to_string(duplicate.first.line) + "; remove one of them";
  }
  if (!all.empty()) throw InputError(all);
}

}  // namespace

json json_of(std::string_view text) {
  return json::parse(text, nullptr, false);
}

Document parse(std::string_view text, std::string name) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.substr(0, 3) == byte_order_mark) text.remove_prefix(3);
  json value = parse_value(text, name);
  Places places(text);
  refuse_duplicates(places, name);
  return {std::move(name), std::move(value), std::move(places)};
}

}  // namespace talus
