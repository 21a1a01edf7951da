#include "scene/scene.hpp"

#include <array>
#include <charconv>
#include <cstdio>

namespace sphereview {

namespace {

constexpr Color black{0, 0, 0};
constexpr Color white{255, 255, 255};

}  // namespace

bool parse_background(std::string_view text, Background& background) {
    if (text == "black") {
        background = {black, false};
    } else if (text == "white") {
        background = {white, false};
    } else if (text == "transparent") {
        background = {black, true};
    } else if (text.size() == 7 && text[0] == '#') {
        std::array<std::uint8_t, 3> channels{};
        for (std::size_t i = 0; i < 3; ++i) {
            const char* first = text.data() + 1 + 2 * i;
            const auto result = std::from_chars(first, first + 2, channels[i], 16);
            if (result.ec != std::errc{} || result.ptr != first + 2) return false;
        }
        background = {{channels[0], channels[1], channels[2]}, false};
    } else {
        return false;
    }
    return true;
}

std::string to_string(const Background& background) {
    if (background.transparent) return "transparent";
    if (background.color == black) return "black";
    if (background.color == white) return "white";
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", background.color.r, background.color.g, background.color.b);
    return text.data();
}

}  // namespace sphereview
