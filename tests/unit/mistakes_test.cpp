// A deliberately wrong tracer, which shares no code with the program's: the diagnosis must name what is wrong with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "mistakes/diagnosis.hpp"
#include "support/spheres.hpp"

namespace sphereview {

namespace {

// The names of the mistakes that it makes, as the diagnosis calls them; "" for none. Of the rules several, with + between them.
struct Mistakes {
    std::string orientation{};
    std::string place{};
    std::string rule{};
};

// "a+b": a, b.
std::set<std::string> parts_of(const std::string& names) {
    std::set<std::string> parts;
    std::istringstream rest(names);
    for (std::string part; std::getline(rest, part, '+');) parts.insert(part);
    return parts;
}

// The numbers of the spheres as somebody's program may find them who reads the definition of the picture, and makes mistakes.
template <typename Real>
std::vector<int> traced(const Scene& scene, PictureSize size, const Mistakes& mistakes) {
    std::vector<int> numbers;
    const std::set<std::string> rules = parts_of(mistakes.rule);
    const bool first = rules.contains("no-depth-test");
    const bool last = rules.contains("last-in-file");
    const bool last_of_equals = rules.contains("last-of-equals");
    const bool farthest = rules.contains("farthest");
    const bool far_root = rules.contains("far-root");
    const bool behind = rules.contains("behind-the-eye");
    const bool inside_missed = rules.contains("inside-missed");
    const bool tangent_missed = rules.contains("tangent-missed");
    const int four = rules.contains("discriminant") ? 1 : 4;
    const bool edges = mistakes.place == "edge-to-edge";
    const bool corner = mistakes.place.ends_with("corner");
    const Real in_x = corner ? (mistakes.place.find("left") != std::string::npos ? 0 : 1) : Real(0.5);
    const Real in_y = corner ? (mistakes.place.starts_with("top") ? 0 : 1) : Real(0.5);
    for (int row = 0; row < size.height; ++row) {
        for (int column = 0; column < size.width; ++column) {
            const Real m = static_cast<Real>(std::min(size.width, size.height));
            const Real w = static_cast<Real>(size.width);
            const Real h = static_cast<Real>(size.height);
            const bool stretched = mistakes.place == "stretched";
            Real x = Real(50) * (2 * (static_cast<Real>(column) + in_x) - w) / (stretched ? w : m);
            Real y = Real(50) * (h - 2 * (static_cast<Real>(row) + in_y)) / (stretched ? h : m);
            if (edges) x = (Real(-50) + Real(100) * static_cast<Real>(column) / (w - 1)) * w / m;
            if (edges) y = (Real(50) - Real(100) * static_cast<Real>(row) / (h - 1)) * h / m;
            if (mistakes.orientation == "x-y-exchanged") std::tie(x, y) = std::pair(-y, -x);
            if (mistakes.orientation == "y-down" || mistakes.orientation == "turned") y = -y;
            if (mistakes.orientation == "x-mirrored" || mistakes.orientation == "turned") x = -x;
            const Real z = 100;
            int seen = -1;
            Real nearest = farthest ? -std::numeric_limits<Real>::max() : std::numeric_limits<Real>::max();
            for (std::size_t k = 0; k < scene.spheres.size(); ++k) {
                const auto cx = static_cast<Real>(scene.spheres[k].center.x);
                const auto cy = static_cast<Real>(scene.spheres[k].center.y);
                const auto cz = static_cast<Real>(scene.spheres[k].center.z);
                const auto r = static_cast<Real>(scene.spheres[k].radius);
                const Real a = x * x + y * y + z * z;
                const Real b = -2 * (x * cx + y * cy + z * cz);
                const Real c = cx * cx + cy * cy + cz * cz - r * r;
                const Real discriminant = b * b - static_cast<Real>(four) * a * c;
                if (discriminant < 0 || (tangent_missed && discriminant == 0)) continue;
                const Real t1 = (-b - std::sqrt(discriminant)) / (2 * a);
                const Real t2 = (-b + std::sqrt(discriminant)) / (2 * a);
                Real t = t1 > 0 ? t1 : t2;
                if (inside_missed || behind) t = t1;
                if (far_root) t = t2;
                if (t <= 0 && !behind) continue;
                const bool wins = first            ? seen < 0
                                  : last           ? true
                                  : last_of_equals ? t <= nearest
                                  : farthest       ? t > nearest
                                                   : t < nearest;
                if (wins) std::tie(seen, nearest) = std::pair(static_cast<int>(k), t);
            }
            numbers.push_back(seen);
        }
    }
    return numbers;
}

Image painted(const Scene& scene, PictureSize size, const std::vector<int>& numbers, bool swapped = false) {
    Image picture(size.width, size.height, 3);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const Color color = numbers[i] < 0 ? Color{} : scene.spheres[static_cast<std::size_t>(numbers[i])].color;
        std::uint8_t* at = picture.bytes().data() + 3 * i;
        at[0] = swapped ? color.b : color.r;
        at[1] = color.g;
        at[2] = swapped ? color.r : color.b;
    }
    return picture;
}

Diagnosis diagnosed(const Image& picture, const Scene& scene) {
    WrongPictures wrong(scene, {picture.width(), picture.height()});
    return diagnose(picture, scene, {}, wrong);
}

// Spheres in front of the eye and behind it, overlapping, none of them like another in its colour.
Scene usual_scene(unsigned seed) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) { return low + (high - low) * static_cast<double>(random()) / 4294967296.0; };
    Scene scene;
    for (std::uint8_t i = 0; i < 14; ++i) {
        const double z = i % 7 == 6 ? between(-500, -200) : between(200, 500);
        scene.spheres.push_back({{between(-120, 120), between(-120, 120), z},
                                 between(20, 70),
                                 {static_cast<std::uint8_t>(10 * i + 30), static_cast<std::uint8_t>(250 - 9 * i), i}});
    }
    return scene;
}

}  // namespace

TEST(Diagnosis, NamesTheOneMistakeOfAWrongTracer) {
    const PictureSize square{120, 120};
    const PictureSize wide{150, 100};
    for (unsigned seed = 1; seed <= 3; ++seed) {
        const Scene scene = usual_scene(seed);
        EXPECT_EQ(diagnosed(painted(scene, wide, traced<double>(scene, wide, {})), scene).different, 0);
        const auto expect_named = [&](const Mistakes& mistakes, PictureSize size) {
            const std::string name = mistakes.orientation + mistakes.place + mistakes.rule;
            SCOPED_TRACE("seed " + std::to_string(seed) + ", " + name);
            const Diagnosis found = diagnosed(painted(scene, size, traced<double>(scene, size, mistakes)), scene);
            ASSERT_GT(found.different, 0);
            EXPECT_EQ(found.likeliest, (std::vector{name}));
            EXPECT_EQ(found.explained, found.different);
            EXPECT_EQ(found.contradicting, 0);
            ASSERT_EQ(found.shares.size(), 1U);
            EXPECT_EQ(found.shares[0].pixels, found.different);
            EXPECT_EQ(found.examples.size(), std::min<std::size_t>(3, static_cast<std::size_t>(found.different)));
        };
        for (const char* name : {"y-down", "x-mirrored", "turned"}) expect_named({.orientation = name}, wide);
        expect_named({.orientation = "x-y-exchanged"}, square);
        for (const char* name :
             {"top-left-corner", "top-right-corner", "bottom-left-corner", "bottom-right-corner", "edge-to-edge", "stretched"}) {
            expect_named({.place = name}, wide);
        }
        for (const char* name : {"far-root", "behind-the-eye", "no-depth-test", "last-in-file", "farthest", "discriminant"}) {
            expect_named({.rule = name}, wide);
        }
    }
}

// Whole numbers, for which double arithmetic is exact: rays at the pixels of a 5 x 5 picture.
TEST(Diagnosis, NamesMistakesOfTiesTangentsAndInsides) {
    Scene ties = scene_of({{{0, 0, 300}, 100, {1, 2, 3}}, {{0, 0, 300}, 100, {4, 5, 6}}, {{200, 0, 300}, 40, {7, 8, 9}}});
    Scene tangent = scene_of({{{50, 0, 300}, 50, {9, 9, 9}}});
    Scene inside = scene_of({{{0, 0, 100}, 150, {9, 9, 9}}, {{40, 0, 200}, 30, {5, 5, 5}}});
    const std::vector<std::pair<std::string, const Scene*>> cases = {
        {"last-of-equals", &ties}, {"tangent-missed", &tangent}, {"inside-missed", &inside}};
    for (const auto& [name, scene] : cases) {
        const PictureSize size{5, 5};
        const Diagnosis found = diagnosed(painted(*scene, size, traced<double>(*scene, size, {.rule = name})), *scene);
        EXPECT_GT(found.different, 0) << name;
        EXPECT_EQ(found.likeliest, (std::vector{name}));
        EXPECT_EQ(found.contradicting, 0) << name;
    }
}

TEST(Diagnosis, NamesTwoMistakesAtOnce) {
    const Scene scene = usual_scene(4);
    const PictureSize size{120, 120};
    const Diagnosis turned =
        diagnosed(painted(scene, size, traced<double>(scene, size, {.orientation = "y-down", .rule = "far-root"})), scene);
    EXPECT_EQ(turned.likeliest, (std::vector<std::string>{"y-down", "far-root"}));
    EXPECT_EQ(turned.explained, turned.different);
    const Diagnosis swapped = diagnosed(painted(scene, size, traced<double>(scene, size, {.rule = "last-in-file"}), true), scene);
    EXPECT_EQ(swapped.explained, swapped.different);
    EXPECT_EQ(std::set<std::string>(swapped.likeliest.begin(), swapped.likeliest.end()),
              (std::set<std::string>{"last-in-file", "red-blue-swapped"}));
}

// A beginner who has left out one test has often left out another.
TEST(Diagnosis, NamesSeveralMistakesOfTheHits) {
    const PictureSize size{120, 90};
    int named = 0;
    for (unsigned seed = 11; seed <= 13; ++seed) {
        const Scene scene = usual_scene(seed);
        for (const Mistakes& mistakes :
             {Mistakes{.rule = "no-depth-test+behind-the-eye"}, Mistakes{.rule = "last-in-file+behind-the-eye"},
              Mistakes{.rule = "farthest+behind-the-eye"}, Mistakes{.rule = "far-root+behind-the-eye"},
              Mistakes{.orientation = "y-down", .rule = "discriminant"},
              Mistakes{.orientation = "y-down", .rule = "last-in-file+behind-the-eye"}}) {
            SCOPED_TRACE(std::to_string(seed) + ", " + mistakes.orientation + " " + mistakes.rule);
            const std::vector<int> numbers = traced<double>(scene, size, mistakes);
            Mistakes without = mistakes;
            without.rule = mistakes.rule.substr(0, mistakes.rule.find('+'));
            if (mistakes.orientation.empty() && traced<double>(scene, size, without) == numbers)
                continue;  // the second does nothing
            ++named;
            const Diagnosis found = diagnosed(painted(scene, size, numbers), scene);
            EXPECT_EQ(std::set<std::string>(found.likeliest.begin(), found.likeliest.end()),
                      parts_of(mistakes.rule + (mistakes.orientation.empty() ? "" : "+" + mistakes.orientation)));
            EXPECT_EQ(found.explained, found.different);
            EXPECT_EQ(found.contradicting, 0);
        }
    }
    EXPECT_GE(named, 16);
}

// Wrong hits may cover most of the background with one sphere.
TEST(Diagnosis, TakesNoSpheresColourForTheBackground) {
    const Scene scene = usual_scene(2);
    const PictureSize size{80, 60};
    const std::vector<int> right = traced<double>(scene, size, {});
    std::vector<int> numbers = right;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] < 0 && i % 8 != 0) numbers[i] = 3;
        if (numbers[i] < 0) numbers[i] = 5;
    }
    const Diagnosis wrong = diagnosed(painted(scene, size, numbers), scene);
    EXPECT_TRUE(wrong.likeliest.empty()) << wrong.likeliest_words;
    // Nor one colour of many.
    Image gradient = painted(scene, size, right);
    for (std::size_t i = 0; i < right.size(); ++i) {
        if (right[i] < 0) gradient.bytes()[3 * i + 2] = static_cast<std::uint8_t>(100 + i / 160);
    }
    EXPECT_TRUE(diagnosed(gradient, scene).likeliest.empty());
    // But the same everywhere it may be.
    numbers = right;
    std::ranges::replace(numbers, -1, 3);
    EXPECT_EQ(diagnosed(painted(scene, size, numbers), scene).likeliest, (std::vector<std::string>{"background"}));
}

// Colours of a program that shades or smooths, and of one that only writes colours in a wrong way.
TEST(Diagnosis, TellsAnotherStyleFromAMistake) {
    const Scene scene = usual_scene(1);
    const PictureSize size{120, 120};
    const std::vector<int> right = traced<double>(scene, size, {});
    const Image flat = painted(scene, size, right);
    const auto changed = [&](const auto& change) {
        Image picture = painted(scene, size, right);
        for (std::size_t i = 0; i < right.size(); ++i) change(i, picture.bytes().data() + 3 * i);
        return diagnosed(picture, scene);
    };
    const auto shade = [&](std::size_t i, std::uint8_t* color) {
        for (int c = 0; right[i] >= 0 && c < 3; ++c) color[c] = static_cast<std::uint8_t>(color[c] * (60 + i / 120) / 200);
    };
    EXPECT_EQ(changed(shade).style, "shaded");
    const auto mix_with_left = [&](std::size_t i, std::uint8_t* color) {
        const std::uint8_t* left = flat.bytes().data() + 3 * (i % 120 == 0 ? i : i - 1);
        for (int c = 0; c < 3; ++c) color[c] = static_cast<std::uint8_t>((color[c] + left[c] + 1) / 2);
    };
    EXPECT_EQ(changed(mix_with_left).style, "smoothed");

    // Each sphere's colour darker, as a wrong gamma makes it: few colours.
    const auto darken = [&](std::size_t, std::uint8_t* color) {
        for (int c = 0; c < 3; ++c) color[c] = static_cast<std::uint8_t>(color[c] * color[c] / 255);
    };
    EXPECT_EQ(changed(darken).style, "");
    // Shaded, and upside down.
    const std::vector<int> turned = traced<double>(scene, size, {.orientation = "y-down"});
    Image wrong = painted(scene, size, turned);
    for (std::size_t i = 0; i < turned.size(); ++i) {
        if (turned[i] >= 0) wrong.bytes()[3 * i] = static_cast<std::uint8_t>(i / 120);
    }
    EXPECT_EQ(diagnosed(wrong, scene).style, "");
    EXPECT_EQ(diagnosed(painted(scene, size, turned), scene).style, "");
}

// What only float cannot tell, a missing depth test may show as well.
TEST(Diagnosis, SaysThatFloatIsAsLikely) {
    Scene scene;
    scene.spheres = {{{0, 0, 3000}, 1000, {255, 0, 0}}, {{0.002, 0.001, 3000}, 1000, {0, 255, 0}}};
    const PictureSize size{100, 100};
    const Diagnosis found = diagnosed(painted(scene, size, traced<double>(scene, size, {.rule = "no-depth-test"})), scene);
    EXPECT_EQ(found.likeliest, (std::vector<std::string>{"no-depth-test"}));
    EXPECT_EQ(found.contradicting, 0);
    EXPECT_TRUE(std::ranges::count(found.as_likely, "float") == 1) << found.as_likely_words;
    EXPECT_NE(found.as_likely_words.find("too close for float"), std::string::npos);
    const Scene usual = usual_scene(1);
    const Diagnosis plain = diagnosed(painted(usual, size, traced<double>(usual, size, {.rule = "no-depth-test"})), usual);
    EXPECT_EQ(std::ranges::count(plain.as_likely, "float"), 0);
}

TEST(Diagnosis, NamesFloatArithmetic) {
    // Two spheres that are nearly the same: where the second is nearer, it is so by less than float can tell.
    Scene scene = scene_of({{{0, 0, 3000}, 1000, {255, 0, 0}}, {{0.002, 0.001, 3000}, 1000, {0, 255, 0}}});
    const PictureSize size{100, 100};
    const Diagnosis found = diagnosed(painted(scene, size, traced<float>(scene, size, {})), scene);
    ASSERT_GT(found.different, 0);
    EXPECT_EQ(found.likeliest, (std::vector<std::string>{"float"}));
    EXPECT_EQ(found.explained, found.different);
}

TEST(Diagnosis, SaysThatNothingIsDrawn) {
    const Scene scene = usual_scene(6);
    const PictureSize size{50, 40};
    const Diagnosis found = diagnosed(painted(scene, size, std::vector<int>(2000, -1)), scene);
    EXPECT_EQ(found.likeliest, (std::vector<std::string>{"blank"}));
    EXPECT_EQ(found.explained, found.different);
    EXPECT_NE(found.likeliest_words.find("no ray hits anything"), std::string::npos) << found.likeliest_words;
    const Diagnosis of_sphere = diagnosed(painted(scene, size, std::vector<int>(2000, 3)), scene);
    EXPECT_EQ(of_sphere.likeliest, (std::vector<std::string>{"blank"}));
    EXPECT_NE(of_sphere.likeliest_words.find("that of sphere 3: every ray counts as a hit"), std::string::npos)
        << of_sphere.likeliest_words;
}

TEST(Diagnosis, TakesAPictureOfOneColourForWrongOnlyWhereTheRightOneHasSeveral) {
    Image white(20, 10, 3);
    std::ranges::fill(white.bytes(), std::uint8_t{255});
    EXPECT_EQ(diagnosed(white, {}).likeliest, (std::vector<std::string>{"background"}));
}

TEST(Diagnosis, NamesColoursThatWereTakenForZeroToOne) {
    Scene scene = usual_scene(8);
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        scene.spheres[i].color = {static_cast<std::uint8_t>(i % 2 == 0 ? 255 : 90), static_cast<std::uint8_t>(i % 3 == 0 ? 0 : 70),
                                  static_cast<std::uint8_t>(i % 5 == 0 ? 255 : 12)};
    }
    const PictureSize size{120, 90};
    const std::vector<int> numbers = traced<double>(scene, size, {});
    for (const bool clamped : {true, false}) {
        Image picture = painted(scene, size, numbers);
        for (std::uint8_t& value : picture.bytes()) {
            value = static_cast<std::uint8_t>(clamped ? (value > 0 ? 255 : 0) : value / 255);
        }
        const Diagnosis found = diagnosed(picture, scene);
        EXPECT_EQ(found.likeliest, (std::vector<std::string>{clamped ? "clamped-colors" : "divided-colors"}));
        EXPECT_EQ(found.explained, found.different);
        EXPECT_EQ(found.contradicting, 0);
    }
}

// Also where rays are parallel.
TEST(Diagnosis, NamesMistakesOfAnOrthographicTracer) {
    Scene scene = usual_scene(7);
    scene.camera.projection = Projection::orthographic;
    const PictureSize size{150, 100};
    for (const char* name : {"y-down", "x-mirrored", "top-left-corner", "far-root", "last-in-file"}) {
        Scene other = scene;
        WrongPictures wrong(other, size);
        WrongTracer tracer;
        for (const WrongTracer& one : with_one_more_mistake({}, size)) {
            if (mistakes_of(one)[0].name == name) tracer = one;
        }
        const Diagnosis found = diagnosed(painted(scene, size, wrong.numbers(tracer)), scene);
        EXPECT_GT(found.different, 0) << name;
        EXPECT_EQ(found.likeliest, (std::vector<std::string>{name}));
    }
}

TEST(Diagnosis, SaysWhatNoUsualMistakeExplains) {
    const Scene scene = usual_scene(5);
    const PictureSize size{60, 60};
    const std::vector<int> numbers = traced<double>(scene, size, {});
    Image picture = painted(scene, size, numbers);
    const auto middle = static_cast<std::size_t>(numbers[60 * 30 + 30]);
    const auto other = scene.spheres[(middle + 1) % scene.spheres.size()].color;
    const auto set = [&](int x, int y, const Color& color) {
        picture.at(x, y)[0] = color.r;
        picture.at(x, y)[1] = color.g;
        picture.at(x, y)[2] = color.b;
    };
    set(30, 30, other);
    set(31, 30, {255, 0, 255});
    Image marked;
    WrongPictures wrong(scene, size);
    const Diagnosis found = diagnose(picture, scene, {}, wrong, &marked);
    EXPECT_EQ(found.different, 2);
    EXPECT_TRUE(found.likeliest.empty());
    ASSERT_EQ(found.shares.size(), 2U);
    EXPECT_EQ(found.shares[0].name, "unknown");
    EXPECT_EQ(found.shares[1].name, "no-color");
    ASSERT_EQ(found.examples.size(), 1U);
    EXPECT_EQ(found.examples[0].pixel, (Pixel{30, 30}));
    EXPECT_EQ(found.examples[0].found_number, (middle + 1) % scene.spheres.size());
    EXPECT_EQ(marked.at(31, 30)[0], found.shares[1].mark.r);
    EXPECT_EQ(marked.at(5, 5)[1], picture.at(5, 5)[1] / 4);
}

}  // namespace sphereview
