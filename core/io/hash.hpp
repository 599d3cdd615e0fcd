#pragma once
/// SHA-256 (FIPS 180-4) of bytes and of the state of the particles, by libmd.

#include <memory>
#include <string>
#include <string_view>

#include "core/io/snapshot.hpp"

namespace talus::io {

/// A SHA-256 that is fed in parts.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  void add(void const* data, std::size_t size);
  void add(std::string_view bytes) { add(bytes.data(), bytes.size()); }
  /// The digest of all that was added, 64 hexadecimal digits. Ends the use of the object.
  [[nodiscard]] std::string digest();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

/// SHA-256 of some bytes, 64 hexadecimal digits.
[[nodiscard]] std::string sha256(std::string_view bytes);

/// SHA-256 over time, step, dimension and the raw bits of every column; the particles in the order of their column
/// "id", the columns in the order of their names. So it does not depend on how particles are stored, and it tells apart
/// any two states that differ by one bit (0 and -0 too).
/// Throws std::logic_error where there is no column "id" of one component, or two particles bear the same id.
[[nodiscard]] std::string state_hash(Snapshot const& snapshot);

}  // namespace talus::io
