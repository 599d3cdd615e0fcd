#pragma once
/// Gnuplot, the program that draws: run as a process of its own, without a shell.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace talus::io {

/// Runs `gnuplot <script>` inside a folder; what it says goes to `<script stem>.log` there. The script draws each picture
/// into `<name>.tmp`; they get their names once all are complete. Returns what went wrong, for people; nothing where all
/// is well. A machine without gnuplot is no error of the program. Throws FileError where a picture cannot be put in place.
[[nodiscard]] std::string run_gnuplot(std::filesystem::path const& folder, std::string const& script,
                                      std::vector<std::string> const& pictures = {});

/// Text as a string of gnuplot's language: it can neither end the string nor start a command.
[[nodiscard]] std::string gnuplot_string(std::string_view text);

}  // namespace talus::io
