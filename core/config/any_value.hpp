#pragma once
/// A number, a text, or true or false: a value whose kind the table does not know, as an axis of a study takes them.

#include <string>

namespace talus {

/// The value as JSON text, in its shortest form.
struct AnyValue {
  std::string text = "0";
  bool operator==(AnyValue const&) const = default;
};

}  // namespace talus
