#include "base/text.hpp"

#include "base/ascii.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <locale>
#include <string>
#include <string_view>
#include <vector>

#include "base/nesting.hpp"
#include "base/number.hpp"

namespace sphereview {

namespace {

using Limits = std::numeric_limits<double>;

std::string place(std::string_view text, std::size_t offset, TextPosition origin = {}) {
    const TextPosition position = position_at(text, offset, origin);
    return std::to_string(position.line) + ":" + std::to_string(position.column);
}

}  // namespace

TEST(PositionAt, CountsLinesAndCharactersFromOne) {
    EXPECT_EQ(place("", 0), "1:1");
    EXPECT_EQ(place("abc", 2), "1:3");
    EXPECT_EQ(place("a\nbc", 3), "2:2");
    EXPECT_EQ(place("a\n\n", 3), "3:1");
    // Every kind of line end is one.
    EXPECT_EQ(place("a\r\nb", 3), "2:1");
    EXPECT_EQ(place("a\rb", 2), "2:1");
    EXPECT_EQ(place("a\r", 2), "2:1");
    EXPECT_EQ(place("a\r\r\n\nb", 5), "4:1");
    EXPECT_EQ(place("a\n\rb", 3), "3:1");
    // Characters, not bytes: U+00E9; U+1F310, U+20AC.
    EXPECT_EQ(place("\xC3\xA9x", 2), "1:2");
    EXPECT_EQ(place("\xF0\x9F\x8C\x90\xE2\x82\xACx", 7), "1:3");
    EXPECT_EQ(place("ab", 100), "1:3");  // the end of the text
    // Where the text stands in its file.
    EXPECT_EQ(place("abc", 1, {4, 12}), "4:13");
    EXPECT_EQ(place("a\nbc", 3, {4, 12}), "5:2");
}

TEST(TakeLine, TakesLinesWithEveryKindOfEnd) {
    std::string_view text = "a\nb\r\n\rlast";
    for (const std::string_view line : {"a", "b", "", "last", ""}) EXPECT_EQ(take_line(text), line);
    EXPECT_EQ(text, "");
}

TEST(Trimmed, TakesWhiteSpaceAwayAtBothEnds) {
    EXPECT_EQ(trimmed(" \t a b\r\n"), "a b");
    EXPECT_EQ(trimmed("\t a ", " "), "\t a");
    EXPECT_EQ(trimmed(" \n"), "");
}

TEST(FoundExpected, MakesAMessageAboutAPlace) {
    EXPECT_EQ(place_in("a.txt", {2, 30}) + found_expected("x\n", "a number"), "a.txt:2:30: found 'x\\x0a', expected a number");
}

TEST(InQuotes, EscapesWhatATerminalWouldActAndCutsLongTexts) {
    EXPECT_EQ(in_quotes("a ~'\""), "'a ~'\"'");
    EXPECT_EQ(in_quotes(std::string_view("\0\x1b[2J\n\x7F", 7)), R"('\x00\x1b[2J\x0a\x7f')");
    EXPECT_EQ(in_quotes("\xC3\xA9"), R"('\xc3\xa9')");
    EXPECT_EQ(in_quotes(std::string(40, 'x')), "'" + std::string(40, 'x') + "'");
    EXPECT_EQ(in_quotes(std::string(41, 'x')), "'" + std::string(40, 'x') + "...'");
}

TEST(UnknownKey, IsFoundAtTheTopLevelWithoutParsing) {
    const std::vector<std::string> known = {"camera", "sphere", "names"};
    const auto found = [&](std::string_view text) -> std::string {
        const auto key = find_unknown_key(text, known);
        return key ? std::to_string(key->offset) + " " + std::string(key->key) : "";
    };
    for (const std::string_view text :
         {"", "# a = 1", "camera.x = 1\nnames = {b = 1}\n", "[camera]\na = 1\n[[ sphere ]]\n\"b\" = [\n1]\n[names.c]\nd=1",
          "names = [\na = 1\n]", "names = \"\"\"\na = 1\n\"\"\" # b = 1", "names = 1 # [\n'sphere'=2", "hello\na = 1", "= 1", "[",
          "\"a", "a", "\"\\u0063amera\" = 1"}) {
        EXPECT_EQ(found(text), "") << text;
    }
    EXPECT_EQ(found("a=[{b.c=1},"), "0 a");
    EXPECT_EQ(found("names = {x = [\n1] }\r\n 'a b'.c = 1"), "22 a b");
    EXPECT_EQ(found("[camera]\nx = 1\n[[\ta.camera]]"), "18 a");
}

TEST(OnOneLine, EscapesWhatSteersATerminalAndKeepsOtherCharacters) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"a \\'K\xC3\xBCgel' \xE7\x90\x83 \xF0\x9F\x8C\x90", "a \\'K\xC3\xBCgel' \xE7\x90\x83 \xF0\x9F\x8C\x90"},
        {"\x1b[2J\r\n\x7f", R"(\x1b[2J\x0d\x0a\x7f)"},
        {"\xC2\x9B[", R"(\xc2\x9b[)"},                                // U+009B begins what ESC [ begins
        {"\xE2\x80\xAE\xE2\x80\xA8", R"(\xe2\x80\xae\xe2\x80\xa8)"},  // from right to left; the end of a line
        {"\xD8\x9C", R"(\xd8\x9c)"},                                  // the Arabic letter mark turns the order, too
        {"\xFF\xC3", R"(\xff\xc3)"},
        // Longer forms than needed, a surrogate, beyond Unicode.
        {"\xC0\x9B\xE0\x82\x9B\xED\xA0\x80\xF4\x90\x80\x80", R"(\xc0\x9b\xe0\x82\x9b\xed\xa0\x80\xf4\x90\x80\x80)"},
    };
    for (const auto& [text, safe] : cases) EXPECT_EQ(on_one_line(text), safe);
    EXPECT_EQ(on_lines("a\n\r\tb\n"), "a\n\\x0d\\x09b\n");
    EXPECT_EQ(on_one_line("\xC3\xA9\xC3\xA9\xC3\xA9", 2), "\xC3\xA9\xC3\xA9...");
    EXPECT_EQ(on_one_line("ab", 2), "ab");
}

namespace {

std::string repeated(int times, const std::string& part) {
    std::string text;
    for (int i = 0; i < times; ++i) text += part;
    return text;
}

}  // namespace

TEST(FindTooDeep, SeesKeysAndBracketsOutsideStringsAndComments) {
    const std::string dots = "a" + repeated(40, ".a");
    const std::string brackets = repeated(40, "[");
    const std::string basic = R"(""")";
    for (const std::string& harmless : {
             "a" + repeated(most_nested - 1, ".a") + "=1",
             repeated(most_nested, "["),
             "a = [" + repeated(100, "1.5, ") + "]\n" + repeated(100, "b.c = 1\n") + repeated(100, "[[d]]\n"),
             "# " + dots + "\n'" + dots + "' = \"" + brackets + "\\\"" + dots + "\"",
             "a = '''" + brackets + "\n" + dots + "''''\nb = " + basic + dots + "\"\" \\" + basic + dots + basic + "\"\"",
             std::string("a = 'no end\n\"nor here"),
         }) {
        EXPECT_FALSE(find_too_deep(harmless)) << harmless;
    }
    const std::vector<std::pair<std::string, std::size_t>> deep = {
        {dots, 2 * most_nested - 1},
        {"[[" + dots, 2 * most_nested + 1},
        {"x = ''''''\n" + dots, 11 + 2 * most_nested - 1},
        {"x = ''\n" + dots, 7 + 2 * most_nested - 1},
        {repeated(40, "'a' . "), 6 * most_nested - 2},
        {brackets, most_nested},
        {repeated(40, "{a=["), 2 * most_nested},
        {R"({"a\"":)" + brackets, 7 + most_nested - 1},
    };
    for (const auto& [text, offset] : deep) {
        const auto found = find_too_deep(text);
        ASSERT_TRUE(found) << text;
        EXPECT_EQ(found->offset, offset) << text;
    }
}

TEST(Nesting, CommentsStandOutsideStrings) {
    for (const char* text : {"# a", "a = 1 # b", "a = '#'\n#", "\"\"\"\n#\n\"\"\"\n # b"}) EXPECT_TRUE(has_comment(text)) << text;
    for (const char* text : {"", "a = '#'", "a = \"\\\"#\"", "'''\n#\n'''", "a = \"#102030\"\nb = 1\n"}) {
        EXPECT_FALSE(has_comment(text)) << text;
    }
}

TEST(DidYouMean, NamesTheClosestCandidateThatIsNear) {
    const std::vector<std::string> names = {"render", "convert", "doctor"};
    EXPECT_EQ(did_you_mean("DOCTOR", names), "; did you mean 'doctor'?");
    EXPECT_EQ(did_you_mean("convrt", names), "; did you mean 'convert'?");
    EXPECT_EQ(did_you_mean("scene", names), "");
    EXPECT_EQ(did_you_mean("wiev", std::vector<std::string>{"view"}), "; did you mean 'view'?");
    EXPECT_EQ(did_you_mean("Temp", std::vector<std::string>{"charge", "temperature"}), "; did you mean 'temperature'?");
    EXPECT_EQ(did_you_mean("Temp", std::vector<std::string>{"temporary", "temperature"}), "");
    EXPECT_EQ(did_you_mean("q", std::vector<std::string>{"x"}), "");
    EXPECT_EQ(did_you_mean("", names), "");
    EXPECT_EQ(did_you_mean(std::string(65, 'r'), names), "");  // not worth the time
    EXPECT_EQ(did_you_mean("render", {}), "");
    EXPECT_EQ(did_you_mean("2", std::vector<std::string>{"1", "4", "16"}), "");
    // Short words are allowed one mistake.
    EXPECT_EQ(did_you_mean("ul", std::vector<std::string>{"up"}), "; did you mean 'up'?");
    EXPECT_EQ(did_you_mean("xy", std::vector<std::string>{"up"}), "");
}

TEST(Fixed, WritesTheDecimalPlacesAsked) {
    EXPECT_EQ(fixed(1.0, 2), "1.00");
    EXPECT_EQ(fixed(-0.126, 2), "-0.13");
    EXPECT_EQ(fixed(2.5, 0), "2");  // to even
    EXPECT_EQ(fixed(1e300, 9).size(), 311U);
    EXPECT_EQ(fixed(std::numeric_limits<double>::infinity(), 3), "inf");
}

TEST(WithoutByteOrderMark, TakesOneMarkAwayFromTheFront) {
    EXPECT_EQ(without_byte_order_mark("\xEF\xBB\xBFx"), "x");
    EXPECT_EQ(without_byte_order_mark("\xEF\xBB\xBF\xEF\xBB\xBF"), "\xEF\xBB\xBF");
    EXPECT_EQ(without_byte_order_mark("\xEF\xBB"), "\xEF\xBB");
}

TEST(Shortest, WritesTheShortestTextThatReadsBack) {
    const std::vector<std::pair<double, const char*>> cases = {
        {0.0, "0"},
        {-0.0, "-0"},
        {0.1, "0.1"},
        {1e22, "1e+22"},
        {Limits::denorm_min(), "5e-324"},
        {-12.5, "-12.5"},
        {1.0 / 3, "0.3333333333333333"},
        {Limits::max(), "1.7976931348623157e+308"},
        {Limits::infinity(), "inf"},
    };
    for (const auto& [value, expected] : cases) EXPECT_EQ(shortest(value), expected);
}

TEST(LowerCase, ChangesAsciiLettersOnly) { EXPECT_EQ(lower_case("AZ@[az\xC3\x89"), "az@[az\xC3\x89"); }

TEST(WordsListed, AreThoseThatCanBeTypedAsTheyStand) {
    using Words = std::vector<std::string>;
    EXPECT_EQ(words_listed("auto, egl, 2d or #rrggbb"), (Words{"auto", "egl", "2d"}));
    EXPECT_EQ(words_listed("text or toml"), (Words{"text", "toml"}));
    EXPECT_EQ(words_listed("one"), Words{"one"});
    EXPECT_EQ(words_listed("a number above 0, at most 3600"), Words{});
    EXPECT_EQ(words_listed(""), Words{});
}

TEST(FirstOf, NamesTheFirstOfMany) {
    using Words = std::vector<std::string>;
    EXPECT_EQ(first_of({"a", "b"}, 2), (Words{"a", "b"}));
    EXPECT_EQ(first_of({"a", "b", "c", "d"}, 2), (Words{"a", "b", "2 more"}));
    EXPECT_EQ(first_of(Words(1003, "a"), 1), (Words{"a", "1,002 more"}));
}

TEST(InGroups, SetsACommaBeforeEachThreeDigits) {
    EXPECT_EQ(in_groups(0), "0");
    EXPECT_EQ(in_groups(999), "999");
    EXPECT_EQ(in_groups(1000), "1,000");
    EXPECT_EQ(in_groups(2'000'000'000), "2,000,000,000");
}

TEST(ParseDouble, ReadsTheNearestDouble) {
    const std::vector<std::pair<const char*, double>> cases = {
        {"0", 0.0},
        {"-0", -0.0},
        {"+1", 1.0},
        {"1.", 1.0},
        {".5", 0.5},
        {"-1.5E+2", -150.0},
        {"007", 7.0},
        {"0.1", 0x1.999999999999ap-4},
        // Halfway between 1 and the next double: to even. A digit far behind decides.
        {"1.00000000000000011102230246251565404236316680908203125", 1.0},
        {"1.000000000000000111022302462515654042363166809082031250000000001", 0x1.0000000000001p0},
        {"1.7976931348623157e308", Limits::max()},
        {"1.7976931348623158e308", Limits::max()},
        {"2.2250738585072011e-308", 0x0.fffffffffffffp-1022},  // the largest subnormal
        // Too small.
        {"5e-324", Limits::denorm_min()},
        {"2.4703282292062329e-324", Limits::denorm_min()},  // just above half of it
        {"2.4703282292062327e-324", 0.0},
        {"1e-400", 0.0},
        {"-1e-400", -0.0},
        {"1.5e-99999999999999999999", 0.0},
    };
    for (const auto& [text, expected] : cases) {
        SCOPED_TRACE(text);
        double value = 12.0;
        EXPECT_EQ(parse_double(text, value), NumberFault::none);
        EXPECT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected));
    }
}

TEST(ParseDouble, SaysWhatIsWrongAndLeavesTheValueAlone) {
    const std::vector<std::pair<NumberFault, std::vector<std::string>>> cases = {
        {NumberFault::not_a_number,
         {"", "+", "-", ".", "+-1", "-+1", "++1", "--1", "1e", "1e+", "1,5", "1.5x", "0x10", "1_000", " 1", "1 ", "one",
          std::string("1\0", 2)}},
        {NumberFault::not_finite, {"nan", "NaN", "inf", "-inf", "+inf", "Infinity"}},
        {NumberFault::too_large, {"1e400", "-1e400", "1.8e308", "1e99999999999999999999", "1.7976931348623159e308"}},
    };
    for (const auto& [expected, texts] : cases) {
        for (const std::string& text : texts) {
            SCOPED_TRACE(text);
            double value = 12.0;
            EXPECT_EQ(parse_double(text, value), expected);
            EXPECT_EQ(value, 12.0);
        }
    }
}

// As in much of Europe.
struct DecimalComma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
};

TEST(ParseDouble, DoesNotHeedTheLocale) {
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
    double value = 12.0;
    EXPECT_EQ(parse_double("1.5", value), NumberFault::none);
    EXPECT_EQ(value, 1.5);
    EXPECT_EQ(parse_double("1.5e-400", value), NumberFault::none);
    EXPECT_EQ(value, 0.0);
    EXPECT_EQ(parse_double("1.5e400", value), NumberFault::too_large);
    std::locale::global(before);
}

TEST(Text, LettersAndAccentsAreOneCharacter) {
    EXPECT_EQ(composed("caf\u0065\u0301.xyz"), "caf\u00e9.xyz");
    EXPECT_EQ(composed("A\u030Angstro\u0308m, c\u030Ca\u0301p"), "\u00C5ngstr\u00F6m, \u010D\u00E1p");
    for (const char* as_it_is : {"", "plain", "\u00e9", "\u0301e", "x\u0301", "\xff\x80", "e\xcc"}) {
        EXPECT_EQ(composed(as_it_is), as_it_is);
    }
    EXPECT_EQ(composed("e\u0300\u0301"), "\u00e8\u0301") << "one accent alone";
}

TEST(Ascii, HasLettersWithoutAccentsSignsInWordsAndAQuestionMarkForTheRest) {
    EXPECT_EQ(in_ascii("charge [e]"), "charge [e]");
    EXPECT_EQ(in_ascii("Größe à Kraków, Øst, œuf, Ñ"), "Grosse a Krakow, Ost, oeuf, N");
    EXPECT_EQ(in_ascii("e\xCC\x81"), "e") << "an accent of its own";
    EXPECT_EQ(in_ascii("\xC5\xBE\xC4\x80\xC3\x80"), "zAA") << "both ends of the table";
    EXPECT_EQ(in_ascii("5 µm ± 2° α−β"), "5 um +- 2deg alpha-beta");
    EXPECT_EQ(in_ascii("電荷 q"), "?? q") << "a sign for each letter, not for each byte";
    EXPECT_EQ(in_ascii("a\x01\x7F\xFF"), "a?");
}

}  // namespace sphereview
