// The outlines of selected and hovered spheres.
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <numeric>

#include "gl/contexts.hpp"
#include "gl/live.hpp"

namespace sphereview::test {
namespace {

constexpr Rgba amber{255, 166, 0, 255};
constexpr Rgba white{255, 255, 255, 255};

// A pixel's own sphere, and those within the distance of its centre to theirs.
bool near_sphere(const std::vector<std::int32_t>& numbers, PictureSize size, int x, int y, std::int32_t number, double distance) {
    const int reach = static_cast<int>(distance);
    for (int j = std::max(0, y - reach); j <= std::min(size.height - 1, y + reach); ++j) {
        for (int i = std::max(0, x - reach); i <= std::min(size.width - 1, x + reach); ++i) {
            const bool is_near = (i - x) * (i - x) + (j - y) * (j - y) < distance * distance;
            if (is_near && numbers[static_cast<std::size_t>(j * size.width + i)] == number) return true;
        }
    }
    return false;
}

// What each pixel of a window without outlines shows, of spheres whose red is 10 (number + 1). Not from pick(): a window shows
// guesses.
std::vector<std::int32_t> numbers_in(const Image& plain) {
    std::vector<std::int32_t> numbers;
    for (int y = 0; y < plain.height(); ++y) {
        for (int x = 0; x < plain.width(); ++x) numbers.push_back(at(plain, x, y)[0] / 10 - 1);
    }
    return numbers;
}

class OutlineTest : public InContext {
protected:
    LivePicture picture_;
};

TEST_P(OutlineTest, IsBesideThePixelsOfItsSphereAndNowhereElse) {
    Scene scene = two_spheres();
    scene.spheres.push_back({{-70, 0, 200}, 1.0, red, false});   // a speck
    scene.spheres.push_back({{-80, 90, 200}, 30, blue, false});  // across the picture's edge
    for (std::size_t i = 0; i < 4; ++i) scene.spheres[i].color.r = static_cast<std::uint8_t>(10 * (i + 1));
    const Document document(scene);
    const View view{scene.camera, {121, 100}};
    for (const int step : {4, 2, 1}) {
        const Image plain = shown(picture_, document, view, step);
        const std::vector<std::int32_t> what = numbers_in(plain);
        for (std::int32_t selected = 0; selected < 4; ++selected) {
            for (const float thickness : {1.0F, 2.0F, 4.5F}) {
                Selection selection;
                selection.set_only(static_cast<std::uint32_t>(selected));
                EXPECT_FALSE(picture_.update(document, view, step));
                const Image outlined = drawn_into_window(picture_, document, view, {&selection, {}, thickness});
                int line = 0;
                int rim = 0;
                for (int y = 0; y < view.size.height; ++y) {
                    for (int x = 0; x < view.size.width; ++x) {
                        const bool own = what[static_cast<std::size_t>(y * view.size.width + x)] == selected;
                        const auto within = [&](double distance) {
                            return !own && near_sphere(what, view.size, x, y, selected, distance);
                        };
                        const bool in_line = within(1.5 + thickness) && !within(1.5);
                        const bool in_rim = within(2.5 + thickness) && !in_line;
                        line += in_line ? 1 : 0;
                        rim += in_rim ? 1 : 0;
                        const Rgba before = at(plain, x, y);
                        const Rgba after = at(outlined, x, y);
                        if (in_line) {
                            ASSERT_EQ(after, amber) << x << "," << y << " step " << step;
                        } else if (in_rim) {
                            ASSERT_NEAR(after[0], 0.3 * before[0], 1.0) << x << "," << y;
                            ASSERT_NEAR(after[2], 0.3 * before[2], 1.0) << x << "," << y;
                        } else {
                            ASSERT_EQ(after, before) << x << "," << y << " step " << step;
                        }
                    }
                }
                if (selected != 2 || step == 1) {  // a coarse grid may miss the speck
                    EXPECT_GT(line, 3) << selected;
                    EXPECT_GT(rim, 3) << selected;
                }
            }
        }
    }
}

TEST_P(OutlineTest, TellsTheHoveredSphereFromTheSelectedOnes) {
    const Document document(two_spheres());
    const View view{document.scene().camera, {100, 100}};
    const Image plain = shown(picture_, document, view);
    Selection selection;
    selection.set_only(0);
    const auto count = [](const Image& image, const Rgba& color) {
        int found = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) found += at(image, x, y) == color ? 1 : 0;
        }
        return found;
    };
    const Image none = shown_again(picture_, document, view);
    EXPECT_TRUE(same(none, plain));
    const Image hovered = shown_again(picture_, document, view, {nullptr, 1, 3.0F});
    EXPECT_GT(count(hovered, white), 40);
    EXPECT_EQ(count(hovered, amber), 0);
    EXPECT_EQ(at(hovered, 40, 50), opaque(red));  // far from it
    const Image selected = shown_again(picture_, document, view, {&selection, {}, 3.0F});
    EXPECT_GT(count(selected, amber), 2 * count(hovered, white));  // twice as wide
    EXPECT_EQ(count(selected, white), 0);
    const Image both = shown_again(picture_, document, view, {&selection, 1, 3.0F});
    EXPECT_GT(count(both, amber), 40);
    EXPECT_GT(count(both, white), 40);
    const Image same_one = shown_again(picture_, document, view, {&selection, 0, 3.0F});
    EXPECT_GT(count(same_one, amber), 40);
    EXPECT_GT(count(same_one, white), 40);
    EXPECT_TRUE(same(shown_again(picture_, document, view, {&selection, {}, 3.0F}), selected));
}

TEST_P(OutlineTest, OfManyAndOfNone) {
    Document document(two_spheres());
    const View view{document.scene().camera, {100, 100}};
    const Image plain = shown(picture_, document, view);
    Selection all;
    all.set({0, 1});
    const Image outlined = shown_again(picture_, document, view, {&all, {}, 1.0F});
    // Where the two meet, each has the other's line, and none is dark.
    EXPECT_EQ(at(outlined, 51, 50), at(plain, 51, 50));
    int meeting = 0;
    for (int x = 30; x < 70; ++x) meeting += at(outlined, x, 50) == amber ? 1 : 0;
    EXPECT_EQ(meeting, 2);

    // What is hidden, gone or never seen has none.
    for (const std::vector<std::uint32_t>& numbers : {std::vector<std::uint32_t>{7, 4'000'000'000}, {}}) {
        Selection selection;
        selection.set(numbers);
        EXPECT_TRUE(same(shown_again(picture_, document, view, {&selection, 4'000'000'000, 2.0F}), plain));
    }
    Sphere hidden = document.scene().spheres[1];
    hidden.hidden = true;
    document.apply(change(1, hidden), "hide");
    const Image without = shown(picture_, document, view);
    Selection second;
    second.set_only(1);
    EXPECT_TRUE(same(shown_again(picture_, document, view, {&second, 1, 2.0F}), without));

    // The line follows an edit of its sphere's place, and of its colour.
    Sphere moved = document.scene().spheres[0];
    moved.center.x = -50.0;
    document.apply(change(0, moved), "move");
    EXPECT_FALSE(same(shown(picture_, document, view, 1, {&all, {}, 1.0F}), outlined));
    moved.color = {5, 6, 7};
    document.apply(change(0, moved), "colour");
    const Image recolored = shown_again(picture_, document, view, {&all, {}, 1.0F});
    EXPECT_EQ(at(recolored, 25, 50), opaque({5, 6, 7}));
    int line = 0;
    for (int x = 0; x < 100; ++x) line += at(recolored, x, 50) == amber ? 1 : 0;
    EXPECT_EQ(line, 2);
}

// A wall of spheres that overlap: lines around each would hide it.
TEST_P(OutlineTest, OfVeryManyIsOneLineAroundAllAndATint) {
    Scene scene;
    constexpr int side = 15;
    for (int i = 0; i < side * side; ++i) {
        scene.spheres.push_back({{-42.0 + 6.0 * (i % side), -42.0 + 6.0 * (i / side), 200.0}, 5.0, blue, false});
    }
    const Document document(scene);
    const View view{scene.camera, {200, 200}};
    std::vector<std::uint32_t> numbers(scene.spheres.size());
    std::iota(numbers.begin(), numbers.end(), 0U);
    for (const int step : {4, 1}) {
        const Image plain = shown(picture_, document, view, step);
        // In the wall's middle, and all over the picture.
        const auto count = [&](const Image& image, bool everywhere, const std::function<bool(const Rgba&)>& is_counted) {
            int found = 0;
            for (int y = everywhere ? 0 : 70; y < (everywhere ? 200 : 130); ++y) {
                for (int x = everywhere ? 0 : 70; x < (everywhere ? 200 : 130); ++x) found += is_counted(at(image, x, y)) ? 1 : 0;
            }
            return found;
        };
        const auto is_amber = [](const Rgba& color) { return color == amber; };
        const auto is_tinted = [](const Rgba& color) {
            return std::abs(color[0] - (0.7 * blue.r + 0.3 * amber[0])) <= 1.0 && std::abs(color[2] - 0.7 * blue.b) <= 1.0;
        };
        Selection all;
        all.set(numbers);
        ASSERT_GT(numbers.size(), most_outlined_alone);
        const Image set = drawn_into_window(picture_, document, view, {&all, {}, 2.0F});
        EXPECT_EQ(count(set, false, is_amber), 0);
        EXPECT_EQ(count(set, false, is_tinted), 60 * 60);
        EXPECT_GT(count(set, true, is_amber), 400);
        EXPECT_EQ(at(set, 2, 2), at(plain, 2, 2)) << "far from all";
        // The one under the pointer has its line there too.
        const Image hovered = drawn_into_window(picture_, document, view, {&all, 7 * side + 7, 2.0F});
        EXPECT_GT(count(hovered, false, [](const Rgba& color) { return color == white; }), 20);
        EXPECT_EQ(count(hovered, false, is_amber), 0);
        Selection fewer;
        fewer.set({numbers.begin() + 25, numbers.begin() + 25 + static_cast<std::ptrdiff_t>(most_outlined_alone)});
        const Image alone = drawn_into_window(picture_, document, view, {&fewer, {}, 2.0F});
        EXPECT_GT(count(alone, false, is_amber), 500) << "each has its own";
        EXPECT_EQ(count(alone, false, is_tinted), 0);
        EXPECT_TRUE(same(drawn_into_window(picture_, document, view, {}), plain));
    }
}

INSTANTIATE_TEST_SUITE_P(Contexts, OutlineTest, testing::ValuesIn(context_kinds()), testing::PrintToStringParamName());

}  // namespace
}  // namespace sphereview::test
