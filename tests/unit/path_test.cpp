#include "base/path.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace sphereview {

TEST(Path, IsItsText) {
    for (const char* text : {"", "a/b.txt",
                             "gr\xC3\xB6\xC3\x9F"
                             "e\xE2\x86\x92\xE7\x90\x83.txt"}) {
        EXPECT_EQ(text_from(path_from(text)), text);
    }
}

TEST(Path, OfUnitsThatAreNoUtf16ComesBackUnchanged) {
    const std::vector<std::pair<std::u16string, std::string>> cases = {
        {u"", ""},
        {u"a\u007F\u0080\u07FF\u0800\uFFFF", "a\x7F\xC2\x80\xDF\xBF\xE0\xA0\x80\xEF\xBF\xBF"},
        {u"\U00010000\U0010FFFF", "\xF0\x90\x80\x80\xF4\x8F\xBF\xBF"},
        {{u'a', char16_t{0xD800}}, "a\xED\xA0\x80"},
        {{char16_t{0xDFFF}, u'a'},
         "\xED\xBF\xBF"
         "a"},
        {{char16_t{0xDC00}, char16_t{0xD800}}, "\xED\xB0\x80\xED\xA0\x80"},  // the wrong way round
        {{char16_t{0xD83C}, char16_t{0xD83C}, char16_t{0xDF10}}, "\xED\xA0\xBC\xF0\x9F\x8C\x90"},
    };
    for (const auto& [units, text] : cases) {
        EXPECT_EQ(utf8_from(units), text);
        EXPECT_TRUE(utf16_from(text) == units) << text;
    }
}

TEST(Path, OfBytesThatAreNoTextHasReplacements) {
    EXPECT_TRUE(utf16_from("a\xFF"
                           "b\xC3") == u"a\uFFFDb\uFFFD");
    EXPECT_TRUE(utf16_from("\xED\xA0") == u"\uFFFD\uFFFD");
    EXPECT_TRUE(utf16_from("\xED\xA0"
                           "a") == u"\uFFFD\uFFFDa");
}

}  // namespace sphereview
