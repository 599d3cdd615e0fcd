#pragma once
/// How the program ends: what failed becomes an exit code and a word.

#include <exception>
#include <string_view>

namespace talus::cli {

/// A write beyond a limit or into a closed pipe becomes an error that is told, in place of a signal that kills.
void take_failed_writes_as_errors();

/// The exit code once all that was printed has arrived.
[[nodiscard]] int after_output(int code);

/// The exit code of what a verb threw; the message goes to standard error, behind the name of the program.
[[nodiscard]] int told(std::exception const& error, std::string_view program = "talus");

}  // namespace talus::cli
