#pragma once
/// Which cases a command line means.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "verification/suite/case.hpp"

namespace talus::verification {

/// The tier up to which cases run where none is named.
inline constexpr int everyday_tier = 1;

/// The cases of these names, in the order of `all`: a name is an id, a folder of ids ("manufactured"), or a pattern of
/// the shell ("*/bar"). All cases where no name is given. With a tier only cases up to it; without, named cases whatever
/// their tier, else those up to the everyday one. Throws CLI::ValidationError for a name of no case, with the nearest,
/// and where no case is left: nothing is no success.
[[nodiscard]] std::vector<Case const*> chosen(std::span<Case const* const> all, std::vector<std::string> const& names,
                                              std::optional<int> tier);

}  // namespace talus::verification
