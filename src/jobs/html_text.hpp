// Text for pages of HTML.
#pragma once

#include <string>
#include <string_view>

namespace burnish {

// Safe between tags and in double-quoted attributes.
std::string escaped_html(std::string_view text);

}  // namespace burnish
