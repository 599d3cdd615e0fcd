#pragma once
/// Gnuplot, the program that draws: run as a process of its own, without a shell.

#include <filesystem>
#include <string>
#include <string_view>

namespace talus::io {

/// Runs `gnuplot <script>` inside a folder; what it says goes to `<script stem>.log` there. Returns what went wrong,
/// for people; nothing where all is well. A machine without gnuplot is no error of the program.
[[nodiscard]] std::string run_gnuplot(std::filesystem::path const& folder, std::string const& script);

/// Text as a string of gnuplot's language: it can neither end the string nor start a command.
[[nodiscard]] std::string gnuplot_string(std::string_view text);

}  // namespace talus::io
