#include <algorithm>
#include <cctype>
#include <vector>

#include "core/config/json.hpp"
#include "core/errors.hpp"

namespace talus {

namespace {

using nlohmann::json;

struct Assignment {
  std::string pointer;
  json value;
};

bool is_bare_word(std::string_view text) {
  auto const is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  auto const may_follow = [&](char c) {
    return is_letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '.' || c == '/';
  };
  return !text.empty() && is_letter(text.front()) && std::all_of(text.begin(), text.end(), may_follow);
}

Assignment read_assignment(std::string_view text) {
  std::string const name = "--set " + std::string(text.substr(0, text.find('=')));
  std::size_t const equals = text.find('=');
  if (equals == text.npos || text.front() != '/') {
    throw InputError(name + ": write it as /pointer=value, for example /time/end=2.5");
  }
  std::string_view const value = text.substr(equals + 1);
  try {
    return {std::string(text.substr(0, equals)), parse(value, name).value};
  } catch (InputError const&) {
    if (is_bare_word(value)) return {std::string(text.substr(0, equals)), value};
    throw;
  }
}

/// The parts of a pointer, unescaped. Pre: it begins with "/".
std::vector<std::string> parts_of(std::string_view pointer) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at < pointer.size(); ++at) {
    if (pointer[at] == '/') {
      parts.emplace_back();
    } else if (pointer[at] == '~' && at + 1 < pointer.size() && (pointer[at + 1] == '0' || pointer[at + 1] == '1')) {
      parts.back() += pointer[++at] == '0' ? '~' : '/';
    } else {
      parts.back() += pointer[at];
    }
  }
  return parts;
}

json& part_of(json& whole, std::string const& part, std::string const& where) {
  if (whole.is_null()) whole = json::object();
  if (whole.is_object()) return whole[part];
  if (!whole.is_array()) {
    throw InputError("--set " + where + ": there is nothing below " + whole.dump().substr(0, 40) +
                     ", which is no object");
  }
  bool const is_index = !part.empty() && part.size() < 10 && part.find_first_not_of("0123456789") == part.npos &&
                        (part == "0" || part.front() != '0');
  if (!is_index || std::stoul(part) >= whole.size()) {
    throw InputError("--set " + where + ": no entry \"" + part + "\" in this list of " + std::to_string(whole.size()) +
                     "; entries are numbered from 0");
  }
  return whole[std::stoul(part)];
}

std::string assign(json& document, std::string_view text) {
  Assignment assignment = read_assignment(text);
  json changed = document;
  json* at = &changed;
  std::string where;
  for (std::string const& part : parts_of(assignment.pointer)) {
    where += '/' + pointer_part(part);
    at = &part_of(*at, part, where);
  }
  *at = std::move(assignment.value);
  document = std::move(changed);
  return assignment.pointer;
}

}  // namespace

void set_value(json& document, std::string_view assignment) {
  assign(document, assignment);
}

void set_value(Document& document, std::string_view assignment) {
  document.places.forget(assign(document.value, assignment));
}

}  // namespace talus
