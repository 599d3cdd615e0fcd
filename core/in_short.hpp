#pragma once

#include <sstream>
#include <string>

namespace talus {

/// A number in six digits, for messages.
inline std::string in_short(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

}  // namespace talus
