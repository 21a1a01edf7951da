// Conditions that people write to find spheres.
#include "edit/condition.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

using Numbers = std::vector<std::uint32_t>;

// Five atoms: two of chain A, two of chain a, and one of none and without a charge.
Scene charged_atoms() {
    Scene scene;
    for (int i = 0; i < 5; ++i) scene.spheres.push_back({{i, 2.0 * i, 200.0}, 1.0 + i, {}, false});
    scene.names = {{0, "CA"}, {2, "C B"}};
    scene.properties = {{"charge", std::vector<double>{0.5, -1.0, 0.25, 2.0, NAN}},
                        {"id", std::vector<std::int32_t>{1, 2, 3, 4, no_whole_number}},
                        {"chain", Labels{{"A", "a", ""}, {0, 0, 1, 1, 2}}},
                        {"type", Labels{{"1", "2", "10"}, {0, 1, 2, 1, 0}}},
                        {"b factor", std::vector<float>{0.1F, 30.0F, 40.0F, 50.0F, 60.0F}},
                        {"or", std::vector<float>{1.0F, 2.0F, 3.0F, 4.0F, 5.0F}}};
    return scene;
}

Numbers spheres_where(const Condition& condition, const Scene& scene) {
    const SphereTest test(condition, scene);
    Numbers found;
    for (std::uint32_t i = 0; i < scene.spheres.size(); ++i) {
        if (test(i)) found.push_back(i);
    }
    return found;
}

Numbers spheres_matching(const std::string& text) { return spheres_where(Condition(text), charged_atoms()); }

std::string condition_fault(const std::string& text) {
    return message_of<InputError>([&] { spheres_matching(text); });
}

}  // namespace

TEST(Condition, ComparesNumbers) {
    EXPECT_EQ(spheres_matching("charge > 0.25"), (Numbers{0, 3}));
    EXPECT_EQ(spheres_matching("charge>=.25"), (Numbers{0, 2, 3}));
    EXPECT_EQ(spheres_matching("CHARGE <= -1e0"), (Numbers{1}));
    EXPECT_EQ(spheres_matching("id == 2"), (Numbers{1}));
    EXPECT_EQ(spheres_matching("x < 2"), (Numbers{0, 1}));
    EXPECT_EQ(spheres_matching("y = 8"), (Numbers{4}));
    EXPECT_EQ(spheres_matching("radius >= 4 && number != 4"), (Numbers{3}));
    EXPECT_EQ(spheres_matching("'b factor' > 40"), (Numbers{3, 4}));
}

// A sphere without a value fulfils no comparison, whatever it is.
TEST(Condition, TakesNoValueForNone) {
    EXPECT_EQ(spheres_matching("charge != 0.5"), (Numbers{1, 2, 3}));
    EXPECT_EQ(spheres_matching("id != 1"), (Numbers{1, 2, 3}));
    EXPECT_EQ(spheres_matching("chain != A"), (Numbers{2, 3}));
    EXPECT_EQ(spheres_matching("not charge > 0"), (Numbers{1, 4}));
}

TEST(Condition, ComparesWords) {
    EXPECT_EQ(spheres_matching("chain = A"), (Numbers{0, 1}));
    EXPECT_EQ(spheres_matching("chain = \"a\""), (Numbers{2, 3}));
    EXPECT_EQ(spheres_matching("chain = B"), Numbers{});
    EXPECT_EQ(spheres_matching("type = 2"), (Numbers{1, 3}));
    EXPECT_EQ(spheres_matching("type = 2.0"), (Numbers{1, 3}));
    EXPECT_EQ(spheres_matching("type > 1"), (Numbers{1, 2, 3}));
    EXPECT_EQ(spheres_matching("name = CA"), (Numbers{0}));
    EXPECT_EQ(spheres_matching("name != CA"), (Numbers{2}));
    EXPECT_EQ(spheres_matching("name = 'C B'"), (Numbers{2}));
}

TEST(Condition, JoinsComparisons) {
    EXPECT_EQ(spheres_matching("chain = A and charge > 0 or type = 10"), (Numbers{0, 2}));
    EXPECT_EQ(spheres_matching("chain = A AND (charge > 0 OR type = 2)"), (Numbers{0, 1}));
    EXPECT_EQ(spheres_matching("!(chain = A || chain = a)"), (Numbers{4}));
    EXPECT_EQ(spheres_matching("not not id = 1"), (Numbers{0}));
    EXPECT_EQ(spheres_matching("or > 4 or or = 1"), (Numbers{0, 4}));
    std::string deep = "x = 0";
    for (int i = 0; i < 32; ++i) deep = "x = 9 or x = 9 and (" + deep + ")";
    EXPECT_EQ(spheres_matching(deep), Numbers{});
}

TEST(Condition, SaysWhatIsWrongAndWhere) {
    EXPECT_EQ(condition_fault("charge >"), "column 9: the text ends, expected a number or a word");
    EXPECT_EQ(condition_fault("charge 0.5"), "column 8: found '0.5', expected =, !=, <, <=, > or >=");
    EXPECT_EQ(condition_fault("charge > x"), "column 10: found 'x', expected a number");
    EXPECT_EQ(condition_fault("chain < A"), "column 9: found 'A', expected a number");
    const std::string names = "the name of a property: charge, id, chain, type, b factor, or, x, y, z, radius, number or name";
    EXPECT_EQ(condition_fault("chrage > 1"), "column 1: found 'chrage', expected " + names + "; did you mean 'charge'?");
    EXPECT_EQ(condition_fault("x = 1 y = 2"), "column 7: found 'y', expected and, or, or the end");
    EXPECT_EQ(condition_fault("(x = 1"), "column 7: the text ends, expected and, or, or a closing bracket");
    EXPECT_EQ(condition_fault("'x = 1"), "column 1: found a quote that nothing closes, expected another one behind it");
    EXPECT_EQ(condition_fault("x = 1 and"), "column 10: the text ends, expected the name of a property");
    EXPECT_EQ(condition_fault("\xC3\xA9 = 1"), "column 1: found '\\xc3\\xa9', expected " + names);
    EXPECT_EQ(condition_fault("x = 1 and \xC3\xA9 = 1 and y = z"), "column 11: found '\\xc3\\xa9', expected " + names);
    EXPECT_EQ(condition_fault(std::string(100, '(') + "x = 1"), "column 33: found brackets in brackets, expected at most 32");
}

TEST(Condition, FindsAPropertyWithoutItsUnit) {
    Scene scene = charged_atoms();
    scene.properties[0].name = "Charge [e]";
    EXPECT_EQ(spheres_where(Condition("charge > 0.25"), scene), (Numbers{0, 3}));
    EXPECT_EQ(spheres_where(Condition("'charge [E]' > 0.25"), scene), (Numbers{0, 3}));
    EXPECT_TRUE(can_compare(scene, "CHARGE"));
    // A name to the letter goes before, what every sphere has as well; of two units neither is meant.
    scene.properties[4].name = "charge (C)";
    EXPECT_FALSE(can_compare(scene, "charge"));
    EXPECT_NE(message_of<InputError>([&] { spheres_where(Condition("charge > 0"), scene); }).find("Charge [e], id"),
              std::string::npos);
    scene.properties[5].name = "charge";
    EXPECT_EQ(spheres_where(Condition("charge > 4"), scene), (Numbers{4}));
    scene.properties[3].name = "radius";
    const std::string named = message_of<InputError>([&] { spheres_where(Condition("mass > 0"), scene); });
    EXPECT_NE(named.find("y, z, number or name"), std::string::npos) << named << ": each once";
    scene.properties[4].name = "x (velocity)";
    EXPECT_EQ(spheres_where(Condition("x > 3"), scene), (Numbers{4}));
}

TEST(Condition, IsToldFromAName) {
    EXPECT_TRUE(is_condition("charge > 1"));
    EXPECT_FALSE(is_condition("A/ALA 52A/CA"));
    EXPECT_TRUE(can_compare(charged_atoms(), "Charge"));
    EXPECT_TRUE(can_compare(charged_atoms(), "radius"));
    EXPECT_FALSE(can_compare(charged_atoms(), "occupancy"));
}

}  // namespace sphereview
