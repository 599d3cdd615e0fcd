#pragma once
/// Results for machines.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "benchmarks/report/result.hpp"

namespace talus::bench {

/// The document results.json: provenance, and of every benchmark its tables.
[[nodiscard]] nlohmann::json document_of(std::vector<Measured> const&, nlohmann::json const& provenance);

/// Adds a column to every table that an earlier document has too: by how much each value differs from what it was.
/// Throws InputError where `earlier` is no such document.
void compare(std::vector<Measured>&, nlohmann::json const& earlier);

}  // namespace talus::bench
