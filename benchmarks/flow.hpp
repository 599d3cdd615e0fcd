#pragma once
/// The cost of plastic flow.

#include "benchmarks/registry.hpp"

namespace talus::bench {

/// Rate of Cam-Clay mu(I) in plastic flow over that of elastic Hencky, and the share of particles that yield.
[[nodiscard]] Table flow(Options const&);

}  // namespace talus::bench
