#pragma once
/// The particles at one instant as named columns of doubles: what frames, checkpoints, hashes and pictures are made of.

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace talus {

/// One field of all particles. `values[p * components + c]` is component c of particle p, in `unit`.
struct NamedColumn {
  std::string name, symbol, unit, meaning;
  int components = 1;
  std::vector<double> values;

  friend bool operator==(NamedColumn const&, NamedColumn const&) = default;
};

/// The particles at the time `time` [s], after `step` steps. All columns hold the same particles in the same order.
struct Snapshot {
  double time = 0;
  std::int64_t step = 0;
  int dimension = 2;
  std::vector<NamedColumn> columns;

  /// The column of that name, or nullptr.
  [[nodiscard]] NamedColumn const* find(std::string_view name) const {
    for (auto const& column : columns)
      if (column.name == name) return &column;
    return nullptr;
  }

  /// Number of particles. Throws std::logic_error where the columns disagree about it: a mistake of the program.
  [[nodiscard]] std::size_t particles() const {
    std::size_t count = 0;
    for (auto const& column : columns) {
      auto const width = static_cast<std::size_t>(column.components);
      if (column.components < 1 || column.values.size() % width != 0)
        throw std::logic_error("column '" + column.name + "' does not hold a whole number of particles");
      if (&column != &columns.front() && column.values.size() / width != count)
        throw std::logic_error("column '" + column.name + "' holds another number of particles than the first column");
      count = column.values.size() / width;
    }
    return count;
  }

  friend bool operator==(Snapshot const&, Snapshot const&) = default;
};

}  // namespace talus
