#include "mistakes/picture_style.hpp"

#include <algorithm>
#include <array>

#include "exact/visible.hpp"

namespace sphereview {

namespace {

// Looks at the pixels of a picture that differ.
class StyleFinder {
public:
    StyleFinder(const Comparer& comparer, const std::vector<std::int32_t>& numbers, PictureSize size)
        : comparer_(comparer), numbers_(numbers), size_(size) {}

    // Several samples a pixel mix what is seen around its centre, and leave the rest as it is.
    bool is_smoothed() const {
        const std::int64_t different = comparer_.count([&](std::size_t i) { return differs(i); });
        const std::int64_t mixed = comparer_.count([&](std::size_t i) { return differs(i) && is_mixed(i); });
        // Two spheres' colours may mix to a third one's; a flat picture has no other colours.
        const std::int64_t colored = comparer_.count([&](std::size_t i) { return differs(i) && is_new_color(i); });
        return static_cast<double>(mixed) >= nearly_all * static_cast<double>(different) && 2 * colored >= different;
    }

    // Away from outlines, where several samples may mix colours, spheres have new colours, many a sphere, and the background its
    // own.
    bool is_shaded() const {
        const auto is_inner = [&](std::size_t i, bool background) {
            return (numbers_[i] == visible_background) == background && !is_at_outline(i);
        };
        const std::int64_t background = comparer_.count([&](std::size_t i) { return is_inner(i, true); });
        const std::int64_t wrong_background = comparer_.count([&](std::size_t i) { return is_inner(i, true) && differs(i); });
        if (static_cast<double>(wrong_background) > (1.0 - nearly_all) * static_cast<double>(background)) return false;
        const std::int64_t different = comparer_.count([&](std::size_t i) { return is_inner(i, false) && differs(i); });
        const std::int64_t colored =
            comparer_.count([&](std::size_t i) { return is_inner(i, false) && differs(i) && is_new_color(i); });
        // A shadow or another sphere's colour may be met by chance.
        constexpr double most = 0.8;
        return static_cast<double>(colored) >= most * static_cast<double>(different) && spheres_have_many_colors();
    }

private:
    // A few spheres smaller than a pixel, or samples that miss what is in a pixel's centre, do not matter.
    static constexpr double nearly_all = 0.95;

    bool differs(std::size_t i) const { return !comparer_.shows(i, numbers_[i], {}); }

    bool is_new_color(std::size_t i) const {
        const auto alpha = comparer_.alpha(i);
        return (alpha && *alpha != 0 && *alpha != color_max) || !comparer_.number_of(comparer_.found(i), std::nullopt);
    }

    // what(k) for the pixels around i, and i itself.
    template <typename What>
    void around(std::size_t i, const What& what) const {
        const Pixel at = comparer_.pixel(i);
        for (int y = std::max(at.y - 1, 0); y <= std::min(at.y + 1, size_.height - 1); ++y) {
            for (int x = std::max(at.x - 1, 0); x <= std::min(at.x + 1, size_.width - 1); ++x) {
                what(static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) + static_cast<std::size_t>(x));
            }
        }
    }

    bool is_at_outline(std::size_t i) const {
        bool is = false;
        around(i, [&](std::size_t k) { is = is || numbers_[k] != numbers_[i]; });
        return is;
    }

    // Whether its colour is between those that should be around it.
    bool is_mixed(std::size_t i) const {
        std::array<int, 3> least = {color_max, color_max, color_max};
        std::array<int, 3> most{};
        bool outline = false;
        around(i, [&](std::size_t k) {
            outline = outline || numbers_[k] != numbers_[i];
            const Color color = comparer_.right(numbers_[k]);
            const std::array<int, 3> channels = {color.r, color.g, color.b};
            for (std::size_t c = 0; c < 3; ++c) {
                least[c] = std::min(least[c], channels[c]);
                most[c] = std::max(most[c], channels[c]);
            }
        });
        const Color found = comparer_.found(i);
        const std::array<int, 3> is = {found.r, found.g, found.b};
        for (std::size_t c = 0; c < 3; ++c) outline = outline && least[c] - 1 <= is[c] && is[c] <= most[c] + 1;  // rounded
        return outline;
    }

    // A program that only writes colours in a wrong way has one for each sphere.
    bool spheres_have_many_colors() const {
        constexpr std::size_t most_looked_at = std::size_t{1} << 20;
        constexpr std::size_t many = 4;
        constexpr std::size_t fewest = 16;  // one sphere of four wrong colours is not shaded
        const std::size_t step = numbers_.size() / most_looked_at + 1;
        std::vector<std::uint64_t> colors;  // with the number before them
        for (std::size_t i = 0; i < numbers_.size(); i += step) {
            if (numbers_[i] == visible_background || is_at_outline(i) || !differs(i)) continue;
            colors.push_back(static_cast<std::uint64_t>(numbers_[i]) << 32 | packed_color(comparer_.found(i)));
        }
        std::ranges::sort(colors);
        colors.erase(std::unique(colors.begin(), colors.end()), colors.end());
        std::size_t spheres = 0;
        for (std::size_t i = 0; i < colors.size(); ++i) spheres += i == 0 || colors[i] >> 32 != colors[i - 1] >> 32 ? 1 : 0;
        return colors.size() >= std::max(fewest, many * spheres);
    }

    const Comparer& comparer_;
    const std::vector<std::int32_t>& numbers_;
    PictureSize size_;
};

}  // namespace

PictureStyleWords words_of(PictureStyle style) {
    switch (style) {
        case PictureStyle::flat: break;
        case PictureStyle::shaded:
            return {"shaded",
                    "the picture looks shaded: it has many more colours than the scene, and the same outlines; compare wants flat "
                    "pictures of one sample (--shade flat --samples 1)"};
        case PictureStyle::smoothed:
            return {"smoothed",
                    "the picture looks smoothed: only at outlines colours are mixed, and the others are right; compare wants flat "
                    "pictures of one sample (--shade flat --samples 1)"};
    }
    return {"", ""};
}

PictureStyle style_of(const Comparer& comparer, const std::vector<std::int32_t>& numbers, PictureSize size) {
    const StyleFinder finder(comparer, numbers, size);
    if (finder.is_smoothed()) return PictureStyle::smoothed;
    return finder.is_shaded() ? PictureStyle::shaded : PictureStyle::flat;
}

}  // namespace sphereview
