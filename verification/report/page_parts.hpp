#pragma once
/// The page's template, style and script (verification/report/page/), put into the program when it is built.

#include <string_view>

namespace talus::verification {

extern std::string_view const page_template, page_style, page_script;

}  // namespace talus::verification
