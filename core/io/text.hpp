#pragma once
/// How numbers, times and documents are written in a run's files.

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace talus::io {

/// Puts a number into a JSON object. JSON knows only finite ones: others become null, with the reason beside it, as
/// `"<name>_status": "nan"`, `"inf"` or `"-inf"`.
void set_number(nlohmann::json& object, std::string const& name, double value);

/// The number that set_number put there; NaN where there is none of that name.
[[nodiscard]] double number_of(nlohmann::json const& object, std::string const& name);

/// A document with indentation, sorted keys and a final line break; bytes that are not UTF-8 are replaced.
[[nodiscard]] std::string json_text(nlohmann::json const& document);

/// The time now, as 2024-05-31T12:00:00Z.
[[nodiscard]] std::string utc_now();

}  // namespace talus::io
