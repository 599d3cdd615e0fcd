#include "core/config/read.hpp"

#include "core/config/json.hpp"
#include "core/errors.hpp"

namespace talus {

using nlohmann::json;

namespace {

/// What the user wrote, without what a terminal would obey: control characters become \u00XX.
std::string printable(std::string_view text) {
  static constexpr std::string_view digits = "0123456789abcdef";
  std::string shown;
  for (char const c : text) {
    auto const byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7f)
      shown += c;
    else
      shown.append("\\u00").append({digits[byte >> 4U], digits[byte & 15U]});
  }
  return shown;
}

}  // namespace

std::string Mistake::text(std::string_view document) const {
  std::string all(document);
  if (place.is_known()) all += ':' + std::to_string(place.line) + ':' + std::to_string(place.column);
  all += ": " + (pointer.empty() ? "the document" : pointer) + ": ";
  all += expected.empty() ? found : "found " + found + "; expected: " + expected;
  if (!advice.empty()) all += "; " + advice;
  return printable(all);
}

Reader::Reader(Document const& document, int space) : name(document.name), places(document.places), dimension(space) {}

void Reader::refuse(std::string const& pointer, std::string found, std::string expected, std::string advice) {
  mistakes.push_back({pointer, places.near(pointer), std::move(found), std::move(expected), std::move(advice)});
}

void Reader::warn(std::string const& pointer, std::string found, std::string expected, std::string advice) {
  warnings.push_back({pointer, places.near(pointer), std::move(found), std::move(expected), std::move(advice)});
}

void Reader::throw_if_mistaken() const {
  if (mistakes.empty()) return;
  std::string all;
  for (Mistake const& mistake : mistakes) {
    if (!all.empty()) all += '\n';
    all += mistake.text(name);
  }
  throw InputError(all);
}

int find_dimension(json const& document, std::string const& pointer) {
  json::json_pointer const at(pointer);
  if (!document.contains(at)) return 0;
  json const& value = document.at(at);
  return value == 2 ? 2 : value == 3 ? 3 : 0;
}

namespace detail {

void take(json const& from, bool& into) {
  into = from.get<bool>();
}
void take(json const& from, std::int64_t& into) {
  into = from.is_number_float() ? static_cast<std::int64_t>(from.get<double>()) : from.get<std::int64_t>();
}
void take(json const& from, std::uint64_t& into) {
  into = from.is_number_float() ? static_cast<std::uint64_t>(from.get<double>()) : from.get<std::uint64_t>();
}
void take(json const& from, double& into) {
  into = from.get<double>();
}
void take(json const& from, std::string& into) {
  into = from.get<std::string>();
}
void take(json const& from, AnyValue& into) {
  into.text = from.dump();
}

json const* member(json const* object, std::string_view name) {
  if (object == nullptr) return nullptr;
  auto const found = object->find(std::string(name));
  return found == object->end() ? nullptr : &*found;
}
std::size_t entries(json const& list) {
  return list.size();
}
json const& entry(json const& list, std::size_t index) {
  return list[index];
}
std::string_view type_of(json const& choice) {
  return choice.at("type").get_ref<std::string const&>();
}
json const& root(Document const& document) {
  return document.value;
}

}  // namespace detail

}  // namespace talus
