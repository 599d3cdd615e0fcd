#pragma once
/// Reading documents: the tables' judgement, and what the tables cannot say.

#include "core/config/json.hpp"
#include "models/point.hpp"

namespace talus {

// Mistakes are added to the reader; if there are any, what is returned means nothing.
[[nodiscard]] Case read_case(Document const& document, Reader& reader);
[[nodiscard]] Study read_study(Document const& document, Reader& reader);
[[nodiscard]] PointCase read_point(Document const& document, Reader& reader);

/// The point at rest. Pre: the document has no mistakes.
[[nodiscard]] std::unique_ptr<PointExperiment> compose(PointCase const& document);
/// Its path. Pre: the document has no mistakes.
[[nodiscard]] std::vector<Segment> path_of(PointCase const& document);

}  // namespace talus
