#include "core/config/outline.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

namespace talus {

namespace {

bool any_must_be_given(std::vector<Outline> const& parts) {
  return std::any_of(parts.begin(), parts.end(), must_be_given);
}

}  // namespace

bool must_be_given(Outline const& outline) {
  if (outline.is_optional) return false;
  if (outline.kind == Kind::group) return outline.row.is_required || any_must_be_given(outline.parts);
  if (outline.initial == nullptr) return true;
  if (outline.kind != Kind::choice) return false;
  auto const& type = outline.initial->at("type").get_ref<std::string const&>();
  return std::any_of(outline.alternatives.begin(), outline.alternatives.end(), [&](Alternative const& alternative) {
    return alternative.name == type && any_must_be_given(alternative.parameters);
  });
}

std::string to_text(double number) {
  std::array<char, 32> digits{};
  auto const written = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  return {digits.data(), written.ptr};
}

std::string to_text(Range const& range) {
  if (range.bounded_below() && range.bounded_above()) {
    return to_text(range.low) + (range.low_is_open ? " < x" : " <= x") + (range.high_is_open ? " < " : " <= ") +
           to_text(range.high);
  }
  if (range.bounded_below()) return (range.low_is_open ? "x > " : "x >= ") + to_text(range.low);
  if (range.bounded_above()) return (range.high_is_open ? "x < " : "x <= ") + to_text(range.high);
  return "any";
}

namespace detail {

std::shared_ptr<nlohmann::json> new_json() {
  return std::make_shared<nlohmann::json>();
}

Range common_part(Range const& a, Range const& b) {
  Range part = a;
  if (b.low > a.low || (b.low == a.low && b.low_is_open)) {
    part.low = b.low;
    part.low_is_open = b.low_is_open;
  }
  if (b.high < a.high || (b.high == a.high && b.high_is_open)) {
    part.high = b.high;
    part.high_is_open = b.high_is_open;
  }
  return part;
}

}  // namespace detail

}  // namespace talus
