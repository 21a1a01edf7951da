#include "image/compare.hpp"

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

Rgba rgba(const std::uint8_t* bytes, int channels) { return {bytes[0], bytes[1], bytes[2], channels == 4 ? bytes[3] : 255}; }

void set_pixel(Image& picture, int x, int y, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
    std::uint8_t* at = picture.at(x, y);
    at[0] = r;
    at[1] = g;
    at[2] = b;
}

// Compares the rows that it is given with those of a picture of the same size.
class RowComparer {
public:
    // `difference` may be null.
    RowComparer(const Image& actual, std::array<int, 2> expected_size, int expected_channels, Image* difference)
        : actual_(actual), channels_(expected_channels), difference_(difference) {
        comparison_.size = {actual.width(), actual.height()};
        comparison_.expected_size = expected_size;
    }

    const Comparison& comparison() const { return comparison_; }

    void take(const PngRow& row) {
        if (row.y >= actual_.height()) return;
        const auto count = static_cast<int>(row.bytes.size() / static_cast<std::size_t>(channels_));
        const bool as_stored = channels_ == actual_.channels() && row.step == 1 && count == actual_.width();
        if (as_stored && difference_ == nullptr && std::equal(row.bytes.begin(), row.bytes.end(), actual_.at(0, row.y))) return;
        for (int i = 0, x = row.first_x; i < count && x < actual_.width(); ++i, x += row.step) {
            const Rgba a = rgba(actual_.at(x, row.y), actual_.channels());
            const Rgba b = rgba(&row.bytes[static_cast<std::size_t>(i) * static_cast<std::size_t>(channels_)], channels_);
            if (difference_ != nullptr) {
                const auto dimmed = [&](std::size_t c) { return a == b ? static_cast<std::uint8_t>(a[c] / 4) : std::uint8_t{255}; };
                set_pixel(*difference_, x, row.y, dimmed(0), dimmed(1), dimmed(2));
            }
            if (a != b && comparison_.same_size()) note(x, row.y, a, b);
        }
    }

private:
    void note(int x, int y, const Rgba& a, const Rgba& b) {
        Comparison& c = comparison_;
        if (c.different_pixels == 0 || std::tie(y, x) < std::tie(c.first_y, c.first_x)) {
            std::tie(c.first_y, c.first_x) = {y, x};
            c.first = a;
            c.first_expected = b;
        }
        ++c.different_pixels;
        for (std::size_t i = 0; i < a.size(); ++i) c.largest[i] = std::max(c.largest[i], std::abs(a[i] - b[i]));
    }

    const Image& actual_;
    int channels_;
    Image* difference_;
    Comparison comparison_;
};

std::string in_words(const std::array<int, 2>& size) { return std::to_string(size[0]) + "x" + std::to_string(size[1]); }

// A picture as large as both, magenta where only one of them reaches.
Image empty_difference(const Image& actual, const PngReader& expected) {
    const int width = std::max(actual.width(), expected.width());
    const int height = std::max(actual.height(), expected.height());
    const std::int64_t pixels = static_cast<std::int64_t>(width) * height;
    const std::string what = expected.name() + ": the picture of the difference, of " + in_words({width, height}) + " pixels,";
    if (pixels > most_pixels) throw InputError(what + " is too large: expected at most " + in_groups(most_pixels) + " pixels");
    constexpr int channels = 3;
    require_memory(static_cast<std::uint64_t>(pixels) * channels, what + " needs");
    Image picture(width, height, channels);
    const int both_wide = std::min(actual.width(), expected.width());
    const int both_high = std::min(actual.height(), expected.height());
    for (int y = 0; y < height; ++y) {
        for (int x = y < both_high ? both_wide : 0; x < width; ++x) set_pixel(picture, x, y, 255, 0, 255);
    }
    return picture;
}

}  // namespace

Comparison compare(const Image& actual, const Image& expected) {
    RowComparer comparer(actual, {expected.width(), expected.height()}, expected.channels(), nullptr);
    if (!comparer.comparison().same_size()) return comparer.comparison();
    const std::size_t row_bytes = expected.bytes().size() / static_cast<std::size_t>(expected.height());
    for (int y = 0; y < expected.height(); ++y) comparer.take({y, 0, 1, {expected.at(0, y), row_bytes}});
    return comparer.comparison();
}

Comparison compare(const Image& actual, PngReader& expected, Image* difference) {
    RowComparer comparer(actual, {expected.width(), expected.height()}, expected.channels(), difference);
    if (difference != nullptr) *difference = empty_difference(actual, expected);
    if (comparer.comparison().same_size() || difference != nullptr) expected.read([&](const PngRow& row) { comparer.take(row); });
    return comparer.comparison();
}

std::string describe(const Comparison& comparison) {
    const auto& [width, height] = comparison.size;
    if (!comparison.same_size())
        return "the picture is " + in_words(comparison.size) + ", expected " + in_words(comparison.expected_size);
    if (comparison.equal()) return "the pictures are equal";
    const auto pixels = static_cast<std::int64_t>(width) * height;
    std::string text = std::to_string(comparison.different_pixels) + " of " + std::to_string(pixels) + " pixels differ, by at most";
    constexpr std::array<const char*, 4> channels = {" R ", " G ", " B ", " A "};
    for (std::size_t c = 0; c < 4; ++c) {
        if (c == 3 && comparison.largest[c] == 0) break;  // alpha concerns few
        text += channels[c] + std::to_string(comparison.largest[c]);
    }
    const auto color = [&](const Rgba& c) {
        std::string value = "(";
        for (std::size_t i = 0; i < (comparison.largest[3] == 0 ? 3U : 4U); ++i) {
            value += (i == 0 ? "" : ", ") + std::to_string(c[i]);
        }
        return value + ")";
    };
    return text + "; the first at pixel " + std::to_string(comparison.first_x) + "," + std::to_string(comparison.first_y) +
           ": found " + color(comparison.first) + ", expected " + color(comparison.first_expected);
}

}  // namespace sphereview
