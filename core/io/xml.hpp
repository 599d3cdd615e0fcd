#pragma once
/// The little XML that the files of VTK need: text in attributes, there and back.

#include <optional>
#include <string>
#include <string_view>

namespace talus::io::xml {

/// Text as it may stand between the quotes of an attribute.
[[nodiscard]] std::string escape(std::string_view text);

/// The value of an attribute of one tag (`<DataArray type="Float64" ...>`), or nothing.
[[nodiscard]] std::optional<std::string> attribute(std::string_view tag, std::string_view name);

/// The next tag `<name ...>` at or after `at`, which is moved behind it; empty where there is none.
[[nodiscard]] std::string_view next_tag(std::string_view document, std::string_view name, std::size_t& at);

}  // namespace talus::io::xml
