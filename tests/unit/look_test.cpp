// Colours and sizes by what a file holds of each sphere.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "base/logarithm.hpp"
#include "look/coloring.hpp"
#include "look/sizes.hpp"
#include "unit/message_of.hpp"

namespace sphereview {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

Scene scene_with(Property property) {
    Scene scene;
    for (std::size_t i = 0; i < size_of(property); ++i) {
        Sphere sphere;
        sphere.center.x = static_cast<double>(i);
        scene.spheres.push_back(sphere);
    }
    scene.properties.push_back(std::move(property));
    return scene;
}

Coloring colored(const Scene& scene, ColorBy by) {
    by.property = scene.properties[0].name;
    return coloring_of(scene, scene.properties[0], by);
}

// What messages of a wrong look say.
std::string fault_of(const Scene& scene, const ColorBy& by) {
    return message_of<InputError>([&] { colored(scene, by); });
}

std::vector<std::string> texts(const std::vector<Tick>& ticks) {
    std::vector<std::string> found;
    for (const Tick& tick : ticks) found.push_back(tick.text);
    return found;
}

std::vector<std::string> names(const Coloring& coloring) {
    std::vector<std::string> found;
    for (const Category& category : coloring.categories) found.push_back(category.name + " " + std::to_string(category.count));
    return found;
}

}  // namespace

TEST(Logarithm, IsTheSameEverywhere) {
    for (const int exponent : {-1074, -3, 0, 1, 1023}) EXPECT_EQ(binary_logarithm(std::ldexp(1.0, exponent)), exponent);
    const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(binary_logarithm(x)); };
    EXPECT_EQ(bits(10.0), 0x400a934f0979a371U);
    EXPECT_EQ(bits(0.3), 0xbffbca9c6f53897bU);
    for (double x = 1e-300; x < 1e300; x *= 37.7) {
        EXPECT_NEAR(binary_logarithm(x), std::log2(x), std::ldexp(std::abs(std::log2(x)) + 0.1, -50)) << x;
    }
}

TEST(ColorMaps, AreThoseThatPeopleKnow) {
    // A few colours that the maps' authors published.
    struct Known {
        ColorMap map;
        double part;
        Color color;
    };
    for (const auto& [map, part, color] : std::vector<Known>{{ColorMap::viridis, 0.0, {68, 1, 84}},
                                                             {ColorMap::viridis, 128.0 / 255, {33, 145, 140}},
                                                             {ColorMap::viridis, 1.0, {253, 231, 37}},
                                                             {ColorMap::plasma, 64.0 / 255, {126, 3, 168}},
                                                             {ColorMap::plasma, 1.0, {240, 249, 33}},
                                                             {ColorMap::cividis, 32.0 / 255, {26, 56, 111}},
                                                             {ColorMap::cividis, 1.0, {254, 232, 56}},
                                                             {ColorMap::turbo, 0.0, {48, 18, 59}},
                                                             {ColorMap::turbo, 192.0 / 255, {251, 126, 33}},
                                                             {ColorMap::coolwarm, 128.0 / 255, {221, 220, 220}},
                                                             {ColorMap::coolwarm, 1.0, {180, 4, 38}},
                                                             {ColorMap::grey, 0.2, {51, 51, 51}}}) {
        const Color found = color_of(map, part);
        EXPECT_LE(std::abs(found.r - color.r), 3) << name_of(map) << " " << part;
        EXPECT_LE(std::abs(found.g - color.g), 3) << name_of(map) << " " << part;
        EXPECT_LE(std::abs(found.b - color.b), 3) << name_of(map) << " " << part;
    }
    EXPECT_EQ(color_of(ColorMap::turbo, -5.0), color_of(ColorMap::turbo, 0.0));
    EXPECT_EQ(color_of(ColorMap::turbo, 5.0), color_of(ColorMap::turbo, 1.0));
    for (const std::string_view name : color_map_names) EXPECT_EQ(name_of(*color_map_named(name)), name);
    EXPECT_EQ(color_map_named("jet"), std::nullopt);
}

TEST(ColorMaps, CategoriesDiffer) {
    constexpr std::size_t all = 35;
    for (std::size_t a = 0; a < all; ++a) {
        for (std::size_t b = 0; b < a; ++b) EXPECT_NE(category_color(a), category_color(b)) << a << " " << b;
        EXPECT_EQ(category_color(a + all), category_color(a));
    }
}

TEST(Values, AreFoundByNameAndOfEveryScene) {
    Scene scene = scene_with({"Charge", std::vector<double>{1.0, 2.0}});
    scene.properties.push_back({"charge", std::vector<float>{3.0F, 4.0F}});
    Property own;
    EXPECT_EQ(find_values(scene, "charge", own), &scene.properties[1]);
    EXPECT_EQ(find_values(scene, "CHARGE", own), &scene.properties[0]);
    EXPECT_EQ(find_values(scene, "mass", own), nullptr);
    ASSERT_EQ(find_values(scene, "X", own), &own);
    EXPECT_EQ(number_at(own, 1), 1.0);
    ASSERT_EQ(find_values(scene, "radius", own), &own);
    EXPECT_EQ(number_at(own, 1), 20.0);
}

TEST(Values, RangeLeavesOutWhatIsNoNumber) {
    const Property values{"q", std::vector<double>{3.0, no_number, -infinite, -0.0, infinite, 0.5}};
    EXPECT_EQ(range_of(values, false), (ValueRange{0.0, 3.0}));
    EXPECT_EQ(range_of(values, true), (ValueRange{0.5, 3.0}));
    const std::vector<std::uint32_t> some = {1, 5};
    EXPECT_EQ(range_of(values, false, &some), (ValueRange{0.5, 0.5}));
    EXPECT_EQ(range_of({"q", std::vector<double>{no_number}}, false), std::nullopt);
    EXPECT_EQ(range_of({"q", Labels{{"A"}, {0}}}, false), std::nullopt);
}

TEST(Values, HaveAPartOfTheRange) {
    EXPECT_EQ(part_of(2.5, {2.0, 4.0}, false), 0.25);
    EXPECT_EQ(part_of(2.5, {4.0, 2.0}, false), 0.75) << "turned round";
    EXPECT_EQ(part_of(7.0, {3.0, 3.0}, false), 0.5) << "one number";
    EXPECT_EQ(part_of(0.0, {-1.7e308, 1.7e308}, false), 0.5);
    EXPECT_EQ(part_of(-infinite, {0.0, 1.0}, false), 0.0);
    EXPECT_TRUE(std::isnan(part_of(no_number, {0.0, 1.0}, false)));
    EXPECT_EQ(part_of(2.0, {1.0, 16.0}, true), 0.25);
    EXPECT_EQ(part_of(-3.0, {1.0, 16.0}, true), 0.0);
    EXPECT_EQ(part_of(-3.0, {16.0, 1.0}, true), 1.0);
    for (const bool log : {false, true}) EXPECT_NEAR(part_of(value_at(0.3, {1.0, 50.0}, log), {1.0, 50.0}, log), 0.3, 1e-12);
}

TEST(Values, TicksAreRound) {
    using Texts = std::vector<std::string>;
    EXPECT_EQ(texts(ticks_of({-0.83, 0.42}, false, 7)), (Texts{"-0.8", "-0.6", "-0.4", "-0.2", "0.0", "0.2", "0.4"}));
    EXPECT_EQ(texts(ticks_of({-0.83, 0.42}, false, 6)), (Texts{"-0.5", "0.0"}));
    EXPECT_EQ(texts(ticks_of({0.0, 100.0}, false, 6)), (Texts{"0", "20", "40", "60", "80", "100"}));
    EXPECT_EQ(texts(ticks_of({100.0, 0.0}, false, 3)), (Texts{"100", "50", "0"})) << "turned round";
    EXPECT_EQ(texts(ticks_of({0.0, 3e-7}, false, 4)), (Texts{"0", "1e-7", "2e-7", "3e-7"}));
    EXPECT_EQ(texts(ticks_of({1.0, 10000.0}, true, 5)), (Texts{"1", "10", "100", "1000", "10000"}));
    EXPECT_EQ(texts(ticks_of({1e-30, 1e30}, true, 5)), (Texts{"1e-30", "1e-15", "1", "1e15", "1e30"}));
    EXPECT_EQ(texts(ticks_of({3.0, 30.0}, true, 5)), (Texts{"5", "10", "20"}));
    EXPECT_EQ(texts(ticks_of({3.1, 3.4}, true, 3)), (Texts{"3.2", "3.4"}));
    EXPECT_EQ(texts(ticks_of({7.0, 7.0}, false, 5)), (Texts{"7"}));
    for (const Tick& tick : ticks_of({1e300, 1.5e300}, false, 4)) EXPECT_TRUE(tick.part >= 0.0 && tick.part <= 1.0);
    EXPECT_EQ(texts(ticks_of({-1.7e308, 1.7e308}, false, 4)), (Texts{"-1.7e308", "1.7e308"}));
}

TEST(Coloring, OfNumbers) {
    const Scene scene = scene_with({"q", std::vector<double>{0.0, no_number, 1.0, 0.5}});
    const Coloring coloring = colored(scene, {.map = ColorMap::plasma});
    EXPECT_EQ(coloring.range, (ValueRange{0.0, 1.0}));
    EXPECT_EQ(coloring.without_value, 1U);
    const std::vector<Color> colors = colors_of(scene.properties[0], coloring);
    EXPECT_EQ(colors[0], color_of(ColorMap::plasma, 0.0));
    EXPECT_EQ(colors[1], no_value_color);
    EXPECT_EQ(colors[2], color_of(ColorMap::plasma, 1.0));
    EXPECT_EQ(colors[3], color_of(ColorMap::plasma, 0.5));
    EXPECT_EQ(in_words(coloring), "colours by q: plasma from 0 to 1; 1 sphere has no value, and is grey");

    Scene shown = scene;
    EXPECT_EQ(part_with_colors(shown, scene.properties[0], coloring), 0.0);
    for (std::size_t i = 0; i < colors.size(); ++i) shown.spheres[i].color = colors[i];
    EXPECT_EQ(part_with_colors(shown, scene.properties[0], coloring), 1.0);
    shown.spheres[2].color = {};
    EXPECT_EQ(part_with_colors(shown, scene.properties[0], coloring), 0.75);

    EXPECT_EQ(colored(scene, {.range = ValueRange{5.0, -5.0}}).range, (ValueRange{5.0, -5.0}));
    EXPECT_EQ(in_words(colored(scene, {.log = true})),
              "colours by q: viridis from 0.5 to 1, by the logarithm; 1 sphere has no value, and is grey");
    EXPECT_EQ(fault_of(scene, {.range = ValueRange{0.0, 1.0}, .log = true}),
              "q: found a range that is not above 0, expected one above 0 for a logarithm");
    EXPECT_EQ(fault_of(scene_with({"q", std::vector<double>{-1.0}}), {.log = true}),
              "q: found no number above 0, expected one for a logarithm");
}

TEST(Coloring, OfWords) {
    Scene scene = scene_with({"chain", Labels{{"B", "", "10", "9"}, {0, 1, 2, 3, 0}}});
    EXPECT_EQ(names(colored(scene, {})), (std::vector<std::string>{"9 1", "10 1", "B 2", " 1"}));
    const std::vector<Color> colors = colors_of(scene.properties[0], colored(scene, {}));
    EXPECT_EQ(colors,
              (std::vector<Color>{category_color(2), no_value_color, category_color(1), category_color(0), category_color(2)}));
    scene.spheres[4].hidden = true;
    EXPECT_EQ(colored(scene, {}).categories[2].count, 1U);
    EXPECT_EQ(in_words(colored(scene, {})), "colours by chain: 3 categories");
    EXPECT_EQ(fault_of(scene, {.log = true}), "chain: found words, expected numbers for a range or a logarithm");
}

TEST(Coloring, OfElementsIsTheUsualOne) {
    const Scene scene = scene_with({"species", Labels{{"O1", "h", "C", "Qq"}, {0, 1, 2, 1, 3}}});
    const Coloring coloring = colored(scene, {});
    EXPECT_EQ(names(coloring), (std::vector<std::string>{"C 1", "H 2", "O 1", "Qq 1"}));
    const std::vector<Color> colors = colors_of(scene.properties[0], coloring);
    EXPECT_EQ(colors[0], (Color{255, 13, 13}));
    EXPECT_EQ(colors[1], (Color{255, 255, 255}));
    EXPECT_EQ(colors[4], (Color{255, 20, 147}));
    EXPECT_EQ(find_elements(scene), &scene.properties[0]);
    // A chain's letters are no elements, nor are the names of atoms: CA is a carbon.
    EXPECT_EQ(colored(scene_with({"atom", Labels{{"CA", "C"}, {0, 1}}}), {}).categories[0].color, category_color(0));
    EXPECT_EQ(colored(scene_with({"chain", Labels{{"C"}, {0}}}), {}).categories[0].color, category_color(0));
}

// Of several frames those of the first have the first colours, the others by their names alone.
TEST(Coloring, OfCategoriesIsTheSameInEveryFrame) {
    const Scene first = scene_with({"chain", Labels{{"B", "A"}, {0, 1}}});
    const Scene later = scene_with({"chain", Labels{{"0", "C", "A", "long name", "B"}, {1, 2, 3, 4}}});
    const CategoryOrder order = colored(first, {}).order;
    EXPECT_EQ(order.names, (std::vector<std::string>{"A", "B"}));
    const Coloring with_first = colored(later, {.order = order});
    EXPECT_EQ(with_first.order, order);
    const std::vector<Color> colors = colors_of(later.properties[0], with_first);
    EXPECT_EQ(colors[1], category_color(0));
    EXPECT_EQ(colors[3], category_color(1));
    EXPECT_EQ(colors[0], colors_of(scene_with({"chain", Labels{{"C"}, {0}}}).properties[0],
                                   colored(scene_with({"chain", Labels{{"C"}, {0}}}), {.order = order}))[0]);
    for (std::size_t one = 0; one < 2; ++one) EXPECT_TRUE(colors[0] != category_color(one) && colors[2] != category_color(one));
    // Types as ever.
    const Scene types = scene_with({"type", std::vector<std::int32_t>{1, 2, 3, 4, 0, -40}});
    const CategoryOrder two = colored(scene_with({"type", std::vector<std::int32_t>{1, 2}}), {}).order;
    const std::vector<Color> of_types = colors_of(types.properties[0], colored(types, {.order = two}));
    for (std::size_t one = 0; one < 4; ++one) EXPECT_EQ(of_types[one], category_color(one));
    EXPECT_EQ(of_types[4], category_color(category_colors - 3));
    // Elements stay elements.
    const CategoryOrder elements = colored(scene_with({"species", Labels{{"C"}, {0}}}), {}).order;
    const Scene unknown = scene_with({"species", Labels{{"Qq"}, {0}}});
    EXPECT_EQ(colors_of(unknown.properties[0], colored(unknown, {.order = elements}))[0], (Color{255, 20, 147}));
}

TEST(Coloring, OfTypesIsByCategoryUnlessAMapIsAskedFor) {
    const Scene scene = scene_with({"type", std::vector<std::int32_t>{2, 10, 2}});
    EXPECT_EQ(names(colored(scene, {})), (std::vector<std::string>{"2 2", "10 1"}));
    EXPECT_EQ(colors_of(scene.properties[0], colored(scene, {}))[1], category_color(1));
    EXPECT_FALSE(colored(scene, {.map = ColorMap::turbo}).is_category());
    EXPECT_FALSE(colored(scene_with({"type", std::vector<double>{0.5}}), {}).is_category());
    EXPECT_FALSE(colored(scene_with({"id", std::vector<std::int32_t>{2}}), {}).is_category());
}

TEST(Sizes, AreTimesTheValue) {
    Scene scene = scene_with({"mass", std::vector<double>{1.0, 4.0, 0.0, -2.0, no_number, infinite}});
    EXPECT_EQ(usual_scale(scene, scene.properties[0]), 0.125) << "the largest is half the distance of 1";
    const Sizing sizing = size_by(scene.spheres, scene.properties[0], 0.5);
    EXPECT_EQ(sizing.small, 4U);
    std::vector<double> radii;
    for (const Sphere& sphere : scene.spheres) radii.push_back(sphere.radius);
    EXPECT_EQ(radii, (std::vector<double>{0.5, 2.0, 0.04, 0.04, 0.04, 0.04}));
    EXPECT_EQ(part_with_sizes(scene, scene.properties[0], 0.5), 1.0);
    EXPECT_EQ(part_with_sizes(scene, scene.properties[0], 1.0), 0.0);
    scale_radii(scene.spheres, 2.0);
    EXPECT_EQ(scene.spheres[1].radius, 4.0);
    scale_radii(scene.spheres, 1e308);
    EXPECT_TRUE(std::isfinite(scene.spheres[1].radius));

    Scene none = scene_with({"q", std::vector<double>{-1.0}});
    EXPECT_EQ(size_by(none.spheres, none.properties[0], 1.0).small, 1U);
    EXPECT_EQ(none.spheres[0].radius, 20.0);
}

TEST(Sizes, OfElements) {
    EXPECT_EQ(radius_of_element("C", RadiiKind::covalent), 0.76);
    EXPECT_EQ(radius_of_element("c", RadiiKind::vdw), 1.7);
    EXPECT_EQ(radius_of_element("Na", RadiiKind::ionic), 1.02);
    EXPECT_EQ(radius_of_element("H", RadiiKind::ionic), 0.31) << "covalent";
    EXPECT_EQ(radius_of_element("Og", RadiiKind::vdw), std::nullopt);
    Scene scene = scene_with({"element", Labels{{"C", "Qq", "D"}, {0, 1, 2}}});
    EXPECT_EQ(use_radii(scene.spheres, scene.properties[0], RadiiKind::vdw), 1U);
    EXPECT_EQ(scene.spheres[0].radius, 1.7);
    EXPECT_EQ(scene.spheres[1].radius, 20.0);
    EXPECT_EQ(scene.spheres[2].radius, 1.1) << "deuterium is hydrogen";
    for (const std::string_view name : radii_names) EXPECT_EQ(radii_names[static_cast<std::size_t>(*radii_named(name))], name);
}

}  // namespace sphereview
