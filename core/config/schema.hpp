#pragma once
/// JSON Schema (draft-07) of what a document may hold.

#include <nlohmann/json.hpp>
#include <string_view>

#include "core/config/outline.hpp"

namespace talus {

/// The schema of a document. It refuses what the reader refuses, except what a schema cannot say: conditions across
/// members, names given twice, and the number of coordinates (2 or 3) for the space at hand.
///
/// A choice is an `enum` of types and, for each, if/then with all its parameters: one message for one mistake, where
/// `oneOf` gives one for every alternative. Units and symbols are in "x-unit" and "x-symbol".
[[nodiscard]] nlohmann::json schema(Outline const& document, std::string_view title);

}  // namespace talus
