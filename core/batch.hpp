#pragma once
/// What a kernel sees of the particles: a run of chunks that lie in one grid block and are of one material.

#include <array>

#include "core/layout.hpp"
#include "core/tensor.hpp"

namespace talus {

/// Edge of a grid block in cells.
inline constexpr int block_edge = 4;

/// Places of the fields that every scene may have, in packs from a chunk's start; -1 where not stored.
struct FieldOffsets {
  int position = -1, velocity = -1, mass = -1, strain = -1, affine = -1, identity = -1;
};

/// Chunks of one block and one material. The lanes beyond `particles` in the last chunk are empty: mass 0, all else
/// finite.
template <int D>
struct Batch {
  Lanes* chunks = nullptr;
  Lanes const* ahead = nullptr;  ///< chunks of the batch that usually comes next
  int count = 0;                 ///< chunks
  int particles = 0;             ///< particles, at most count * lanes
  int stride = 0;                ///< packs from one chunk to the next
  int used = 0;                  ///< packs of a chunk that a step reads or writes, from its start on
  FieldOffsets at;
  double spacing = 0;           ///< h [m]
  std::array<double, D> first;  ///< the arena's first node, in units of h

  [[nodiscard]] Lanes* chunk(int c) const { return chunks + static_cast<std::ptrdiff_t>(c) * stride; }
  /// Asks memory for the chunk that is two behind chunk c, in this batch or the next: far enough ahead for memory, near
  /// enough to stay in the nearest cache. Inlined at once: g++ takes a function that does nothing else for one without
  /// effect, and drops its calls.
  [[gnu::always_inline]] void prefetch(int c) const {
    int const there = c + 2;
    Lanes const* wanted = there < count ? chunk(there) : ahead + static_cast<std::ptrdiff_t>(there - count) * stride;
    for (Lanes const* const end = wanted + used; wanted < end; wanted += 4) {
      __builtin_prefetch(wanted);
      __builtin_prefetch(wanted + 1);
      __builtin_prefetch(wanted + 2);
      __builtin_prefetch(wanted + 3);  // the last ones may lie behind what is used
    }
  }
  /// Lanes of chunk c that hold a particle.
  [[nodiscard]] int filled(int c) const { return std::min(lanes, particles - c * lanes); }
};

/// What a block learns of its particles while they move; merged over blocks by `unite`, which does not depend on order.
struct Motion {
  double speed = 0;     ///< largest |v_k| of the velocity that moves particles [m/s]
  double gradient = 0;  ///< largest norm of the velocity gradient [1/s]
  long failed = -1;     ///< id of a particle whose state is not finite or whose element inverted; -1: none
  enum class Cause { none, not_finite, inverted } cause = Cause::none;

  void fail(long id, Cause why) {
    if (failed >= 0 && failed <= id) return;
    failed = id;
    cause = why;
  }
  void unite(Motion const& other) {
    speed = std::max(speed, other.speed);
    gradient = std::max(gradient, other.gradient);
    if (other.failed >= 0) fail(other.failed, other.cause);
  }
};

}  // namespace talus
