#pragma once
/// What somebody may have meant: the known name that is nearest to a mistyped one.

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace talus {

/// How many characters must be changed, added, left out or swapped with their neighbour to turn a into b.
/// Source: Damerau (1964), doi:10.1145/363958.363994; Levenshtein (1966); the restricted form, each place changed once.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name nearest to `word`; none if not even two thirds of the longer one agree. Of equally near ones the first.
[[nodiscard]] std::optional<std::string_view> nearest(std::string_view word,
                                                      std::vector<std::string_view> const& names);

}  // namespace talus
