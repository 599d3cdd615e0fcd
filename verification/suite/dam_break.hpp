#pragma once
/// The shipped granular dam break on 22 degrees, coarser or finer, varied, and what it measures at a time.

#include <string>
#include <vector>

#include "core/cli/program.hpp"
#include "verification/suite/findings.hpp"

namespace talus::verification {

inline constexpr double heap_height = 0.14;  ///< [m]

/// The shipped study with n cells in the height of the heap and per_axis^2 particles a cell, on a lattice.
[[nodiscard]] Document dam_break(int n, int per_axis);

/// A run that ended where it should.
struct Ran {
  std::vector<double> values;  ///< of the measures, in the words of the series
  std::vector<Balance> balances;
};

/// Runs a case to `end` [s]. Throws RunError where it fails.
[[nodiscard]] Ran run_to(Document const& document, double end, std::vector<std::string> const& measures, Cost& cost);

}  // namespace talus::verification
