#include "core/cli/outcome.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <new>
#include <system_error>

#include "core/cli/exit_codes.hpp"
#include "core/errors.hpp"

namespace talus::cli {

void take_failed_writes_as_errors() {
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
}

int after_output(int code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  fmt::print(stderr, "talus: cannot write to standard output: {}\n", std::generic_category().message(errno));
  return code == done ? file_system_error : code;
}

int told(std::exception const& error, std::string_view program) {
  if (dynamic_cast<std::bad_alloc const*>(&error) != nullptr) {
    fmt::print(stderr, "{}: there is not enough memory; take a coarser grid or fewer particles a cell\n", program);
    return computation_failed;
  }
  fmt::print(stderr, "{}: {}\n", program, error.what());
  if (dynamic_cast<InputError const*>(&error) != nullptr) return input_invalid;
  if (dynamic_cast<RunError const*>(&error) != nullptr) return computation_failed;
  if (dynamic_cast<CheckpointError const*>(&error) != nullptr) return checkpoint_unusable;
  if (dynamic_cast<FileError const*>(&error) != nullptr) return file_system_error;
  if (dynamic_cast<std::system_error const*>(&error) != nullptr) return file_system_error;
  fmt::print(stderr, "This is a mistake in Talus; please report it with the command and the document.\n");
  return internal_error;
}

}  // namespace talus::cli
