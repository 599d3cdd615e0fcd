#pragma once
/// Small snapshots for the tests of files and pictures.

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/io/snapshot.hpp"

namespace talus::support {

/// Two particles in the plane, whose numbers are the ones that careless files lose: -0, NaN, infinities, the smallest
/// and the largest double, and one that needs 17 digits.
inline Snapshot awkward_snapshot() {
  using Limits = std::numeric_limits<double>;
  return {0.1 + 0.2,
          123456789012,
          2,
          {{"position", "x_p", "m", "position", 2, {-0.0, 1.0 / 3, Limits::max(), -Limits::denorm_min()}},
           {"velocity", "v_p", "m/s", "velocity", 2, {1, -2, 3e-300, 4e300}},
           {"elastic_strain", "eps_p", "1", "strain <trace & \"shear\">", 3, {1e-16, -1, 2, 3, -0.0, 5}},
           {"pressure", "p", "Pa", "may be anything", 1, {Limits::quiet_NaN(), -Limits::infinity()}},
           {"id", "id", "1", "number", 1, {7, 3}}}};
}

/// Bits, so that NaN equals NaN and 0 differs from -0.
inline bool same_bits(std::vector<double> const& a, std::vector<double> const& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (__builtin_memcmp(&a[k], &b[k], sizeof(double)) != 0) return false;
  return true;
}

inline bool same_bits(NamedColumn const& a, NamedColumn const& b) {
  return a.name == b.name && a.symbol == b.symbol && a.unit == b.unit && a.meaning == b.meaning &&
         a.components == b.components && same_bits(a.values, b.values);
}

inline bool same_bits(Snapshot const& a, Snapshot const& b) {
  bool same = same_bits(std::vector{a.time}, std::vector{b.time}) && a.step == b.step && a.dimension == b.dimension &&
              a.columns.size() == b.columns.size();
  for (std::size_t k = 0; same && k < a.columns.size(); ++k) same = same_bits(a.columns[k], b.columns[k]);
  return same;
}

/// A rectangular heap of `across` particles along x, half as many along y, and, in three dimensions, a quarter along z:
/// at `time` [s] stretched along x and flattened along y without change of volume, as a collapsing column is.
inline Snapshot collapsing_heap(int dimension, int across, double time) {
  Snapshot heap{time, std::lround(1000 * time), dimension, {}};
  NamedColumn position{"position", "x_p", "m", "position", dimension, {}};
  NamedColumn velocity{"velocity", "v_p", "m/s", "velocity", dimension, {}}, id{"id", "id", "1", "number", 1, {}};
  double const h = 0.2 / across, stretch = 1 + time * time, rate = 2 * time;
  for (int k = 0; k < (dimension == 3 ? across / 4 : 1); ++k)
    for (int j = 0; j < across / 2; ++j)
      for (int i = 0; i < across; ++i) {
        double const x = (i + 0.5) * h, y = (j + 0.5) * h;
        position.values.insert(position.values.end(), {x * stretch, y / stretch});
        velocity.values.insert(velocity.values.end(), {x * rate, -y * rate / (stretch * stretch)});
        if (dimension == 3) position.values.push_back((k + 0.5) * h);
        if (dimension == 3) velocity.values.push_back(0);
        id.values.push_back(static_cast<double>(id.values.size()));
      }
  heap.columns = {std::move(position), std::move(velocity), std::move(id)};
  return heap;
}

}  // namespace talus::support
