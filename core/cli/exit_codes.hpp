#pragma once
/// Exit codes of the program (docs/conventions.md).

namespace talus::cli {

enum ExitCode : int {
  done = 0,
  internal_error = 1,
  usage_error = 2,
  input_invalid = 3,
  computation_failed = 4,
  expectation_failed = 5,
  checkpoint_unusable = 6,
  file_system_error = 7,
  not_in_this_build = 8,
  stopped = 75,
};

}  // namespace talus::cli
