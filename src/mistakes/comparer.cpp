#include "mistakes/comparer.hpp"

#include <cstdlib>
#include <utility>

#include "exact/visible.hpp"

namespace sphereview {

namespace {

Color scaled(const Color& color, ColorScale scale) {
    const auto channel = [&](std::uint8_t value) {
        if (scale == ColorScale::clamped) return static_cast<std::uint8_t>(value > 0 ? color_max : 0);
        if (scale == ColorScale::divided) return static_cast<std::uint8_t>(value / color_max);
        return value;
    };
    return {channel(color.r), channel(color.g), channel(color.b)};
}

}  // namespace

Comparer::Comparer(const Image& picture, const Scene& scene, const Background& background)
    : picture_(picture), scene_(scene), background_(background) {
    for (std::size_t k = 0; k < scene.spheres.size(); ++k) {
        const Sphere& sphere = scene.spheres[k];
        if (!sphere.hidden) sphere_of_color_.emplace(packed_color(sphere.color), static_cast<std::int32_t>(k));
    }
}

std::optional<std::int32_t> Comparer::number_of(const Color& color, const std::optional<Color>& background_found) const {
    if (color == background_found.value_or(background_.color)) return visible_background;
    const auto sphere = sphere_of_color_.find(packed_color(color));
    return sphere == sphere_of_color_.end() ? std::nullopt : std::optional(sphere->second);
}

Color Comparer::found(std::size_t i) const {
    const std::uint8_t* bytes = picture_.bytes().data() + i * static_cast<std::size_t>(picture_.channels());
    return alpha(i) == 0 ? background_.color : Color{bytes[0], bytes[1], bytes[2]};
}

Color Comparer::right(std::int32_t number) const {
    return number == visible_background ? background_.color : scene_.spheres[static_cast<std::size_t>(number)].color;
}

bool Comparer::shows(std::size_t i, std::int32_t number, const Palette& palette) const {
    if (const auto covered = alpha(i)) {
        if (number == visible_background) return covered == 0;
        if (covered != color_max) return false;
    }
    Color color = number == visible_background && palette.background ? *palette.background : right(number);
    if (palette.red_and_blue_swapped) std::swap(color.r, color.b);
    color = scaled(color, palette.scale);
    const Color is = found(i);
    if (is == color) return true;
    const auto near = [](int a, int b) { return std::abs(a - b) <= Palette::most_off; };
    return palette.inexact && near(is.r, color.r) && near(is.g, color.g) && near(is.b, color.b);
}

DifferingPixel Comparer::difference(std::size_t i, std::int32_t number, const std::optional<Color>& background_found) const {
    DifferingPixel here{pixel(i), found(i)};
    here.alpha = alpha(i);
    here.found_number = number_of(here.found, background_found);
    here.expected = right(number);
    here.expected_number = number;
    return here;
}

}  // namespace sphereview
