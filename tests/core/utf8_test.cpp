// Text of old systems.
#include "core/utf8.hpp"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(Utf8, TellsCharactersFromOtherBytes) {
    for (const char* text : {"", "plain", "K\xC3\xB6per", "\xE2\x82\xAC", "\xF0\x9F\xA7\xB5"})
        EXPECT_TRUE(is_utf8(text)) << text;
    for (const char* text : {"K\xF6per", "\xC3", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80",
                             "\xF4\x90\x80\x80", "\xFF", "a\x80"})
        EXPECT_FALSE(is_utf8(text)) << text;
}

TEST(Utf8, OtherTextIsReadAsWindows1252) {
    EXPECT_EQ(as_utf8("Mein K\xF6per"), "Mein K\xC3\xB6per");
    // The quotation marks, the dash and the euro of Windows-1252, which Latin-1 has not.
    EXPECT_EQ(as_utf8("\x93K\xF6per\x94 \x96 5 \x80"),
              "\xE2\x80\x9CK\xC3\xB6per\xE2\x80\x9D \xE2\x80\x93 5 \xE2\x82\xAC");
    EXPECT_EQ(as_utf8("\xFF\x81"), "\xC3\xBF\xEF\xBF\xBD");
    EXPECT_EQ(as_utf8("K\xC3\xB6per"), "K\xC3\xB6per") << "UTF-8 stays as it is";
    for (int byte = 1; byte < 256; ++byte) {
        const std::string text = as_utf8(std::string("\xFF") + static_cast<char>(byte));
        EXPECT_TRUE(is_utf8(text)) << byte;
    }
}

}  // namespace
}  // namespace burnish
