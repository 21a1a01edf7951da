#include "base/ascii.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.hpp"

namespace sphereview {

namespace {

// For U+00C0 up to U+017F, the letters of Latin scripts, in their order.
constexpr std::string_view latin_in_ascii =
    "A A A A A A AE C E E E E I I I I D N O O O O O ? O U U U U Y Th ss a a a a a a ae c e e e e i i i i "
    "d n o o o o o ? o u u u u y th y A a A a A a C c C c C c C c D d D d E e E e E e E e E e G g G g G g "
    "G g H h H h I i I i I i I i I i IJ ij J j K k ? L l L l L l L l L l N n N n N n n ? ? O o O o O o OE "
    "oe R r R r R r S s S s S s S s T t T t ? ? U u U u U u U u U u U u W w Y y Y Z z Z z Z z s";
constexpr char32_t first_latin = 0xC0;
constexpr char32_t behind_latin = 0x180;

constexpr auto signs_in_ascii = std::to_array<std::pair<char32_t, std::string_view>>({
    {0xA0, " "},     {0xB0, "deg"},    {0xB1, "+-"},     {0xB2, "2"},        {0xB3, "3"},      {0xB5, "u"},      {0xB7, "."},
    {0xB9, "1"},     {0xD7, "x"},      {0xF7, "/"},      {0x391, "A"},       {0x394, "Delta"}, {0x3A9, "Omega"}, {0x3B1, "alpha"},
    {0x3B2, "beta"}, {0x3B3, "gamma"}, {0x3B4, "delta"}, {0x3B5, "epsilon"}, {0x3B8, "theta"}, {0x3BA, "kappa"}, {0x3BB, "lambda"},
    {0x3BC, "u"},    {0x3BD, "nu"},    {0x3C0, "pi"},    {0x3C1, "rho"},     {0x3C3, "sigma"}, {0x3C4, "tau"},   {0x3C6, "phi"},
    {0x3C7, "chi"},  {0x3C8, "psi"},   {0x3C9, "omega"}, {0x2010, "-"},      {0x2011, "-"},    {0x2012, "-"},    {0x2013, "-"},
    {0x2014, "-"},   {0x2018, "'"},    {0x2019, "'"},    {0x201C, "\""},     {0x201D, "\""},   {0x2026, "..."},  {0x2032, "'"},
    {0x207B, "-"},   {0x2212, "-"},    {0x212B, "A"},
});

std::string_view ascii_of(char32_t code) {
    const auto sign = std::ranges::find(signs_in_ascii, code, &std::pair<char32_t, std::string_view>::first);
    if (sign != signs_in_ascii.end()) return sign->second;
    if (code < first_latin || code >= behind_latin) return "?";
    std::string_view rest = latin_in_ascii;
    for (char32_t skipped = first_latin; skipped < code; ++skipped) rest.remove_prefix(rest.find(' ') + 1);
    return rest.substr(0, rest.find(' '));
}

}  // namespace

std::string in_ascii(std::string_view text) {
    const std::string whole = composed(text);
    std::string_view rest = whole;
    std::string found;
    while (!rest.empty()) {
        const Utf8Character next = first_character(rest);
        const std::size_t length = std::max<std::size_t>(next.length, 1);
        constexpr char32_t behind_ascii = 0x80;
        if (next.length == 0) {
            found += '?';
        } else if (next.code >= behind_ascii) {
            found += ascii_of(next.code);
        } else if (next.code >= ' ' && next.code <= '~') {
            found += rest.front();
        }
        rest.remove_prefix(length);
    }
    return found;
}

}  // namespace sphereview
