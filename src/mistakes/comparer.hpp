// Compares a picture of somebody's own ray tracer pixel by pixel with the right one.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "base/parallel.hpp"
#include "image/image.hpp"
#include "scene/scene.hpp"

namespace sphereview {

inline std::uint32_t packed_color(const Color& color) {
    return static_cast<std::uint32_t>(color.r) << 16 | static_cast<std::uint32_t>(color.g) << 8 | color.b;
}

// Mistakes with colours from 0 to 1: clamped to that, or divided by 255 and not multiplied again.
enum class ColorScale { right, clamped, divided };

// How a program may show the right sphere in a wrong colour.
struct Palette {
    bool red_and_blue_swapped = false;
    ColorScale scale = ColorScale::right;
    bool inexact = false;               // off by at most most_off: the colour is meant
    std::optional<Color> background{};  // instead of the right one

    static constexpr int most_off = 4;  // of 255

    bool operator==(const Palette&) const = default;
};

// One of the differing pixels.
struct DifferingPixel {
    Pixel pixel;
    Color found;
    std::optional<std::uint8_t> alpha{};  // the found alpha, where alpha counts; the background's is 0, else 255
    // The first sphere of that colour, or visible_background; nothing if the scene has no such colour.
    std::optional<std::int32_t> found_number{};
    Color expected{};
    std::int32_t expected_number = 0;
    std::size_t share = 0;  // in Diagnosis::shares
};

// Pixels are numbered row by row. The picture and the scene must outlive this object.
class Comparer {
public:
    Comparer(const Image& picture, const Scene& scene, const Background& background);

    // Whether a shown sphere has that colour.
    bool is_of_sphere(std::uint32_t packed) const { return sphere_of_color_.contains(packed); }

    // The number that has that colour: visible_background, or the first shown sphere of that colour; nothing for an unknown colour.
    // background_found: the picture's colour instead of the right background.
    std::optional<std::int32_t> number_of(const Color& color, const std::optional<Color>& background_found) const;

    // The alpha of pixel i; nothing, as alpha does not count, unless the background is transparent and the picture has alpha.
    std::optional<std::uint8_t> alpha(std::size_t i) const {
        if (!background_.transparent || picture_.channels() != 4) return std::nullopt;
        return picture_.bytes()[4 * i + 3];
    }

    Color found(std::size_t i) const;

    Color right(std::int32_t number) const;

    // Whether pixel i shows that number in that palette.
    bool shows(std::size_t i, std::int32_t number, const Palette& palette) const;

    // The difference of pixel i, which should show that number, without its share.
    DifferingPixel difference(std::size_t i, std::int32_t number, const std::optional<Color>& background_found) const;

    // The number of pixels for which is(i) holds.
    template <typename Is>
    std::int64_t count(const Is& is) const {
        std::atomic<std::int64_t> all = 0;
        constexpr std::size_t piece = 1 << 16;
        parallel_pieces(pixels(), piece, [&](std::size_t begin, std::size_t end) {
            std::int64_t some = 0;
            for (std::size_t i = begin; i < end; ++i) some += is(i) ? 1 : 0;
            all += some;
        });
        return all;
    }

    std::int64_t showing(const std::vector<std::int32_t>& numbers, const Palette& palette) const {
        return count([&](std::size_t i) { return shows(i, numbers[i], palette); });
    }

    std::size_t pixels() const { return static_cast<std::size_t>(picture_.width()) * static_cast<std::size_t>(picture_.height()); }
    Pixel pixel(std::size_t i) const {
        const auto width = static_cast<std::size_t>(picture_.width());
        return {static_cast<int>(i % width), static_cast<int>(i / width)};
    }

private:
    const Image& picture_;
    const Scene& scene_;
    Background background_;
    std::unordered_map<std::uint32_t, std::int32_t> sphere_of_color_{};  // the first in the file
};

}  // namespace sphereview
