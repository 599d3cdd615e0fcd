#pragma once
/// Numbers and tables for people, as plain text.

#include <string>
#include <string_view>
#include <vector>

namespace talus::io {

/// A number in about four digits: "0.123", "12.35", "1.234e-05".
[[nodiscard]] std::string in_four_digits(double value);

/// Lines of a table: two blanks before each column, which is as wide as it must be; columns that are empty below the
/// first row are left out, and so are cells beyond those of the first row. `sides` holds 'r' for each column whose cells
/// are put to the right; it may be shorter.
[[nodiscard]] std::string columns(std::vector<std::vector<std::string>> const& rows, std::string_view sides);

}  // namespace talus::io
