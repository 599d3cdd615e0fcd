#pragma once
/// The ways in which a run can go wrong, each with its own exit code (docs/conventions.md).

#include <stdexcept>

namespace talus {

/// What was asked for cannot be: the message says where, what was found, what is allowed. Exit code 3.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The computation failed: the message names the particle, its state, the likely cause. Exit code 4.
struct RunError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A checkpoint cannot be used: damaged, or of another program, dimension or composition. Exit code 6.
struct CheckpointError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file or folder cannot be read or written, or must not be overwritten. Exit code 7.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace talus
