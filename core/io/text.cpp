#include "core/io/text.hpp"

#include <array>
#include <cmath>
#include <ctime>
#include <limits>
#include <nlohmann/json.hpp>

namespace talus::io {

void set_number(nlohmann::json& object, std::string const& name, double value) {
  if (std::isfinite(value)) {
    object[name] = value;
    object.erase(name + "_status");
    return;
  }
  object[name] = nullptr;
  object[name + "_status"] = std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

double number_of(nlohmann::json const& object, std::string const& name) {
  auto const found = object.find(name);
  if (found != object.end() && found->is_number()) return found->get<double>();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  auto const status = object.value(name + "_status", "nan");
  return status == "inf" ? infinity : status == "-inf" ? -infinity : std::numeric_limits<double>::quiet_NaN();
}

std::string json_text(nlohmann::json const& document) {
  return document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string utc_now() {
  auto const seconds = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  std::array<char, 32> text{};
  auto const length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return {text.data(), length};
}

}  // namespace talus::io
