#pragma once
/// The column of elastic/geostatic: soft, under its own weight.

#include "verification/reference/hencky_column.hpp"
#include "verification/suite/refinement.hpp"
#include "verification/suite/scheme.hpp"

namespace talus::verification {

inline constexpr reference::HenckyColumn column_on_foot{1e5, 1500, 9.81, 10};

/// What the column stands on: a slip wall at a node, one that mirrors, or its own twin that is pulled the other way.
enum class Foot { wall, mirror, twin };

/// Brings the column to rest, N cells in its unloaded height, n particles a cell. Gives the errors of place over the height and of stress over that at the
/// foot, root mean square over particles.
[[nodiscard]] Measured solved_column(Scheme const& scheme, int N, int n, Foot foot);

}  // namespace talus::verification
