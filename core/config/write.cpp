#include "core/config/write.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/errors.hpp"

namespace talus::detail {

using nlohmann::json;

void put(json& into, bool value) {
  into = value;
}
void put(json& into, std::int64_t value) {
  into = value;
}
void put(json& into, std::uint64_t value) {
  into = value;
}
void put(json& into, double value) {
  if (!std::isfinite(value)) throw InputError("a parameter that is not finite cannot be written as JSON");
  into = value;
}
void put(json& into, std::string const& value) {
  into = value;
}
void put(json& into, AnyValue const& value) {
  into = json::parse(value.text);
}
void put_empty_object(json& into) {
  into = json::object();
}
void put_empty_list(json& into) {
  into = json::array();
}
json& new_member(json& object, std::string_view name) {
  return object[std::string(name)];
}
json& new_entry(json& list) {
  return list.emplace_back();
}

}  // namespace talus::detail
