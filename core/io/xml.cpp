#include "core/io/xml.hpp"

#include <array>
#include <utility>

namespace talus::io::xml {

namespace {
constexpr std::array<std::pair<char, std::string_view>, 5> entities{
    {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\n', "&#10;"}}};

std::string unescape(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    char read = text.front();
    std::size_t length = 1;
    for (auto const& [character, entity] : entities)
      if (text.starts_with(entity)) read = character, length = entity.size();
    result += read;
    text.remove_prefix(length);
  }
  return result;
}
}  // namespace

std::string escape(std::string_view text) {
  std::string result;
  for (char const c : text) {
    std::string_view written(&c, 1);
    for (auto const& [character, entity] : entities)
      if (c == character) written = entity;
    result += written;
  }
  return result;
}

std::optional<std::string> attribute(std::string_view tag, std::string_view name) {
  auto const start = tag.find(std::string(1, ' ').append(name).append("=\""));
  if (start == tag.npos) return {};
  auto const value = start + name.size() + 3;
  auto const end = tag.find('"', value);
  if (end == tag.npos) return {};
  return unescape(tag.substr(value, end - value));
}

std::string_view next_tag(std::string_view document, std::string_view name, std::size_t& at) {
  auto const start = document.find(std::string(1, '<').append(name).append(" "), at);
  if (start == document.npos) return {};
  auto const end = document.find('>', start);
  if (end == document.npos) return {};
  at = end + 1;
  return document.substr(start, at - start);
}

}  // namespace talus::io::xml
