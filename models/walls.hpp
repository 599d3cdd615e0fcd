#pragma once
/// The walls of documents.

#include <memory>

#include "core/wall.hpp"
#include "models/case.hpp"

namespace talus {

/// What the wall of an entry does to what touches it.
[[nodiscard]] ContactRule contact_of(WallEntry const& entry);

/// The wall of an entry, for D = 2 and 3; none where its shape is not for so many dimensions. Throws InputError, with the
/// wall's name, where a part refuses its parameters.
template <int D>
[[nodiscard]] std::unique_ptr<Wall<D>> wall_of(WallEntry const& entry);

}  // namespace talus
