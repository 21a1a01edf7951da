#include "formats/elements.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace sphereview {

TEST(Elements, AreFoundByTheirSymbolInAnyLetterCase) {
    for (const char* symbol : {"Fe", "FE", "fe", "fE"}) {
        const Element* iron = find_element(symbol);
        ASSERT_NE(iron, nullptr) << symbol;
        EXPECT_EQ(iron->symbol, "Fe");
        EXPECT_EQ(iron->color, (Color{0xE0, 0x66, 0x33}));
        EXPECT_EQ(iron->radius, 1.32);
    }
    for (const char* symbol : {"", "X", "Q", "Fee", "F1", "1", "{", "C ", "\xC3\xA9", "Jq"}) {
        EXPECT_EQ(find_element(symbol), nullptr) << symbol;
    }
}

const Element& element_of_number(std::int64_t number) { return element_of_species(std::to_string(number)); }

TEST(Elements, HaveOneSymbolAndOneNumberEach) {
    std::set<std::string_view> symbols;
    for (int number = 1; number <= 118; ++number) {
        const Element& element = element_of_number(number);
        EXPECT_EQ(find_element(element.symbol), &element) << number;
        EXPECT_TRUE(symbols.insert(element.symbol).second) << element.symbol;
        EXPECT_GT(element.radius, 0.2) << number;
        EXPECT_LT(element.radius, 3.0) << number;
    }
    const std::vector<std::pair<int, const char*>> some = {{1, "H"},   {6, "C"},   {8, "O"},  {26, "Fe"}, {47, "Ag"}, {57, "La"},
                                                           {71, "Lu"}, {79, "Au"}, {92, "U"}, {96, "Cm"}, {118, "Og"}};
    for (const auto& [number, symbol] : some) EXPECT_EQ(element_of_number(number).symbol, symbol);
    for (const std::int64_t number : {std::int64_t{-1}, std::int64_t{119}, std::int64_t{1} << 40}) {
        EXPECT_EQ(&element_of_number(number), &unknown_element());
    }
    EXPECT_EQ(find_element("D"), find_element("H"));
    EXPECT_EQ(find_element("t"), find_element("H"));
}

// Bonded atoms touch: the radii of two add up to the length of their bond, in angstrom.
TEST(Elements, HaveRadiiThatAddUpToBonds) {
    const auto bond = [](const char* a, const char* b) { return find_element(a)->radius + find_element(b)->radius; };
    EXPECT_NEAR(bond("C", "C"), 1.53, 0.02);    // ethane
    EXPECT_NEAR(bond("C", "H"), 1.09, 0.03);    // methane
    EXPECT_NEAR(bond("O", "H"), 0.96, 0.02);    // water
    EXPECT_NEAR(bond("Si", "Si"), 2.35, 0.15);  // the crystal
    EXPECT_NEAR(bond("Cl", "Cl"), 1.99, 0.06);
}

TEST(Elements, AreLargerThanWhatIsNone) {
    for (const char* species :
         {"X",   "Xx",  "xx", "X1",  "Bq",  "BQ2", "bqO", "Gh",  "Gh(O)", "@O", "O_ghost", "H-Ghost", "Du",    "DU", "dummy", "LP",
          "Lp1", "LPX", "EP", "EPW", "EP2", "M",   "MW",  "MW1", "Tv",    "0",  "O-Bq",    "C_BQ",    "H(Bq)", "O:", "Cl:"}) {
        EXPECT_TRUE(is_virtual(element_of_species(species))) << species;
    }
    for (const char* species : {"Xe", "XE", "Xe1", "B",  "Ba", "Br", "D",   "Dy", "Db", "Mg",   "Mn",     "Md", "Li",
                                "Lu", "Er", "Eu",  "Ti", "Ge", "Ga", "Wat", "Q",  "6",  "O(1)", "Fe(II)", "06", "Oxygen"}) {
        EXPECT_FALSE(is_virtual(element_of_species(species))) << species;
    }
    EXPECT_LE(unknown_element().radius, find_element("C")->radius);
    for (int number = 1; number <= 118; ++number) EXPECT_GT(element_of_number(number).radius, virtual_site().radius) << number;
}

TEST(Elements, AreRecognizedInWhatFilesCallAtoms) {
    const std::vector<std::pair<const char*, const char*>> cases = {
        {"C", "C"},    {"C1", "C"},    {"Fe2+", "Fe"}, {"fe", "Fe"},  {"O_w", "O"}, {"OW", "O"},  {"CG1", "C"},
        {"HW2", "H"},  {"CL", "Cl"},   {"6", "C"},     {"026", "Fe"}, {"0", ""},    {"119", ""},  {"6a", ""},
        {"-6", ""},    {"Carbon", ""}, {"X", ""},      {"", ""},      {"+", ""},    {"Zz", ""},   {"99999999999999999999", ""},
        {"SOD", "Na"}, {"POT", "K"},   {"CLA", "Cl"},  {"ces", "Cs"}, {"CAT", ""},  {"CH3", "C"}, {"Si4", "Si"},
    };
    for (const auto& [species, symbol] : cases) EXPECT_EQ(element_of_species(species).symbol, symbol) << species;
}

}  // namespace sphereview
