#pragma once
/// Where a result comes from: program, build, libraries, machine, command and inputs.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/io/text.hpp"

namespace talus::io {

/// An input and the SHA-256 of its bytes.
struct InputFile {
  std::string name, sha256;
};

/// What only the caller knows of a run; the rest is asked of the build and the machine.
struct Provenance {
  std::vector<std::string> command_line;
  int threads = 1;
  std::uint64_t seed = 0;
  std::vector<InputFile> inputs;
  /// UTC (utc_now()); no end while the run goes on.
  std::string start, end;
};

/// This build in one line: version, commit, compiler, type and instruction set.
[[nodiscard]] std::string build_line();

/// The document provenance.json. The machine's name and the user's are left out.
[[nodiscard]] nlohmann::json provenance_document(Provenance const& run);

}  // namespace talus::io
