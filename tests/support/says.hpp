#pragma once
/// Whether an error's message holds some words, as BOOST_CHECK_EXCEPTION asks.

#include <exception>
#include <string>

namespace talus::support {

inline auto says(std::string const& words) {
  return [words](std::exception const& error) { return std::string(error.what()).find(words) != std::string::npos; };
}

}  // namespace talus::support
