// Self-contained pages of HTML: the one style sheet is inside, there are no scripts, and nothing is
// loaded from elsewhere.
#pragma once

#include <string>
#include <string_view>

namespace burnish {

// Safe between tags and in double-quoted attributes.
std::string escaped_html(std::string_view text);

// A whole document. `title` is text, `body` is HTML.
std::string html_page(std::string_view title, std::string_view body);

// `<a href="FILE"><img ...></a>`: the picture in the page, and by itself when it is clicked. `file`
// is relative to the page. width_px 0: as wide as the picture is, at most the page.
std::string html_picture(std::string_view file, std::string_view alt, int width_px = 0);

}  // namespace burnish
