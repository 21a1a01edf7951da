#include "panels/math_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/text.hpp"
#include "panels/panel_context.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

struct Sign {
    char32_t code;
    std::string_view ascii;
};

constexpr auto signs = std::to_array<Sign>({
    {U'\u2212', "-"},
    {U'\u00B7', "."},
    {U'\u00D7', "x"},
    {U'\u00B1', "+-"},
    {U'\u2213', "-+"},
    {U'\u221A', "sqrt"},
    {U'\u2016', "||"},
    {U'\u2264', "<="},
    {U'\u2265', ">="},
    {U'\u2260', "!="},
    {U'\u2192', "->"},
    {U'\u2190', "<-"},
    {U'\u2081', "1"},
    {U'\u2082', "2"},
    {U'\u2014', "-"},
});

bool font_has(char32_t code) {
    const auto glyph = static_cast<ImWchar>(code);
#if IMGUI_VERSION_NUM >= 19200
    return ImGui::GetFont()->IsGlyphInFont(glyph);
#else
    return ImGui::GetFont()->FindGlyphNoFallback(glyph) != nullptr;
#endif
}

constexpr std::array<std::string_view, 10> powers = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

// What `text` begins with of a power: "⁻⁷".
struct Power {
    std::size_t length = 0;  // in bytes
    std::string ascii;       // "-7"
    bool shown = true;       // the font has all of it
};
Power power_at(std::string_view text) {
    constexpr std::string_view minus = "⁻";
    Power power;
    while (true) {
        const std::string_view rest = text.substr(power.length);
        const auto figure = std::ranges::find_if(powers, [&](std::string_view one) { return rest.starts_with(one); });
        if (figure == powers.end() && !rest.starts_with(minus)) return power;
        power.ascii += figure == powers.end() ? '-' : static_cast<char>('0' + (figure - powers.begin()));
        power.shown = power.shown && font_has(first_character(rest).code);
        power.length += figure == powers.end() ? minus.size() : figure->size();
    }
}

// "1.250" becomes "1.25".
void strip_zeros(std::string& digits) {
    if (digits.find('.') == std::string::npos) return;
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.ends_with('.')) digits.pop_back();
}

std::string with_minus(const std::string& number) { return number.starts_with('-') ? "−" + number.substr(1) : number; }

constexpr std::array<std::string_view, 6> relations = {"=", "<", ">", "\u2264", "\u2265", "\u2260"};

// Whether the space there stands beside a sign such as "=": what it compares is read together.
bool is_beside_relation(std::string_view text, std::size_t space) {
    const std::string_view before = text.substr(0, space);
    const std::string_view behind = text.substr(space + 1);
    return std::ranges::any_of(relations, [&](std::string_view one) { return before.ends_with(one) || behind.starts_with(one); });
}

// Where the first line of `text`, which does not begin with a space, ends: at the last space that the width has room for, beside a
// relation only where there is no other.
std::size_t line_end(std::string_view text, float width) {
    std::size_t end = std::min(text.find(' '), text.size());
    std::size_t best = 0;
    while (end < text.size()) {
        if (!is_beside_relation(text, end)) best = end;
        const std::size_t next = std::min(text.find(' ', end + 1), text.size());
        if (width_of(text.substr(0, next)) > width) return best > 0 ? best : end;
        end = next;
    }
    return end;
}

}  // namespace

std::string in_glyphs(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        if (const Power power = power_at(text); power.length > 0) {
            out += power.shown ? std::string(text.substr(0, power.length)) : "^" + power.ascii;
            text.remove_prefix(power.length);
            continue;
        }
        const Utf8Character first = first_character(text);
        const std::size_t length = std::max<std::size_t>(first.length, 1);
        const auto sign = std::ranges::find(signs, first.code, &Sign::code);
        out += sign != signs.end() && !font_has(first.code) ? sign->ascii : text.substr(0, length);
        text.remove_prefix(length);
    }
    return out;
}

std::string typeset(std::string_view ascii) {
    constexpr auto written = std::to_array<std::pair<std::string_view, std::string_view>>({
        {"t1", "t₁"},
        {"t2", "t₂"},
        {"^2", "²"},
        {"n.L", "n·L"},
        {"n.B", "n·B"},
        {"m.L", "m·L"},
        {"L.L", "L·L"},
        {"m.m", "m·m"},
        {" - ", " − "},
    });
    std::string out;
    while (!ascii.empty()) {
        const auto found = std::ranges::find_if(written, [&](const auto& pair) { return ascii.starts_with(pair.first); });
        const std::size_t length = found == written.end() ? 1 : found->first.size();
        out += found == written.end() ? ascii.substr(0, 1) : found->second;
        ascii.remove_prefix(length);
    }
    return out;
}

std::string number_text(double value, int digits) {
    if (std::isnan(value)) return "?";
    if (std::isinf(value)) return with_minus(value > 0.0 ? "(too large for a double)" : "-(too large for a double)");
    if (value == 0.0) return "0";
    const double size = std::fabs(value);
    if (size >= 1e-4 && size < 1e9) {
        const int before = static_cast<int>(std::floor(std::log10(size)));
        std::string text = decimal(value, std::chars_format::fixed, std::max(digits - 1 - before, 0));
        strip_zeros(text);
        return with_minus(text);
    }
    const std::string text = decimal(value, std::chars_format::scientific, digits - 1);
    const std::size_t e = text.find('e');
    std::string mantissa = text.substr(0, e);
    strip_zeros(mantissa);
    std::string exponent = text[e + 1] == '-' ? "⁻" : "";
    const std::string_view figures = std::string_view(text).substr(e + 2);
    for (const char figure : figures.substr(std::min(figures.find_first_not_of('0'), figures.size() - 1))) {
        exponent += powers[static_cast<std::size_t>(figure - '0')];
    }
    return with_minus(mantissa) + " × 10" + exponent;
}

std::string vector_text(const glm::dvec3& v, int digits) {
    return "(" + number_text(v.x, digits) + ", " + number_text(v.y, digits) + ", " + number_text(v.z, digits) + ")";
}

int digits_to_tell(double a, double b) {
    constexpr int all_digits = 17;
    int digits = digits_that_matter;
    while (a != b && digits < all_digits && number_text(a, digits) == number_text(b, digits)) ++digits;
    return digits;
}

void draw_words(std::string_view text, std::string_view on_hover) {
    const std::string shown = in_glyphs(shown_text(text));
    const float width = ImGui::GetContentRegionAvail().x;
    std::string_view rest = shown;
    ImGui::BeginGroup();
    do {
        const std::string_view line = rest.substr(0, line_end(rest, width));
        ImGui::TextUnformatted(line.data(), line.data() + line.size());
        rest.remove_prefix(line.size());
        rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    } while (!rest.empty());
    ImGui::EndGroup();
    if (!on_hover.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", in_glyphs(on_hover).c_str());
}

void draw_colored_words(std::string_view text, const ImVec4& color, std::string_view on_hover) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    draw_words(text, on_hover);
    ImGui::PopStyleColor();
}

void draw_dim_words(std::string_view text) { draw_colored_words(text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled)); }

}  // namespace sphereview
