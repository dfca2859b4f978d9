// Text in UTF-8, and text of old systems that is not.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace burnish {

// Bytes of the UTF-8 character at the start of `text`; 0 where there is none. Overlong forms,
// surrogates and codes above U+10FFFF are no characters.
std::size_t utf8_length(std::string_view text);

bool is_utf8(std::string_view text);

// The text, read as Windows-1252 where it is not UTF-8: the encoding of old programs. The five bytes
// without a character there become U+FFFD.
std::string as_utf8(std::string text);

}  // namespace burnish
