#pragma once
/// A file that claims to be a whole checkpoint.

#include <string>

#include "core/io/hash.hpp"

namespace talus::support {

/// A true header before contents that need not be ours.
inline std::string with_header(std::string const& contents) {
  auto header = "talus checkpoint, format 4\nHDF5 from byte 512 on\nbytes " + std::to_string(contents.size()) +
                "\nsha256 " + io::sha256(contents) + "\n";
  header.resize(512, '\n');
  return header + contents;
}

}  // namespace talus::support
