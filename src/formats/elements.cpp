#include "formats/elements.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/number.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

// By atomic number, from 1.
//
// Colours: Jmol's, which most viewers of molecules share (https://jmol.sourceforge.net/jscolors/, "Element colors"). It has
// none beyond meitnerium, which gives its own to the rest.
//
// Radii: covalent radii of B. Cordero et al., "Covalent radii revisited", Dalton Trans. 2008, 2832 (table 2; carbon sp3,
// manganese, iron and cobalt of low spin). The radii of two bonded atoms add up to the length of their bond, so neighbours just
// touch, and one sees into molecules and crystals; van der Waals radii would show their outside alone. The table ends with
// curium, which gives its own to the rest.
constexpr auto elements = std::to_array<Element>({
    {"H", {0xFF, 0xFF, 0xFF}, 0.31},  {"He", {0xD9, 0xFF, 0xFF}, 0.28}, {"Li", {0xCC, 0x80, 0xFF}, 1.28},
    {"Be", {0xC2, 0xFF, 0x00}, 0.96}, {"B", {0xFF, 0xB5, 0xB5}, 0.84},  {"C", {0x90, 0x90, 0x90}, 0.76},
    {"N", {0x30, 0x50, 0xF8}, 0.71},  {"O", {0xFF, 0x0D, 0x0D}, 0.66},  {"F", {0x90, 0xE0, 0x50}, 0.57},
    {"Ne", {0xB3, 0xE3, 0xF5}, 0.58}, {"Na", {0xAB, 0x5C, 0xF2}, 1.66}, {"Mg", {0x8A, 0xFF, 0x00}, 1.41},
    {"Al", {0xBF, 0xA6, 0xA6}, 1.21}, {"Si", {0xF0, 0xC8, 0xA0}, 1.11}, {"P", {0xFF, 0x80, 0x00}, 1.07},
    {"S", {0xFF, 0xFF, 0x30}, 1.05},  {"Cl", {0x1F, 0xF0, 0x1F}, 1.02}, {"Ar", {0x80, 0xD1, 0xE3}, 1.06},
    {"K", {0x8F, 0x40, 0xD4}, 2.03},  {"Ca", {0x3D, 0xFF, 0x00}, 1.76}, {"Sc", {0xE6, 0xE6, 0xE6}, 1.70},
    {"Ti", {0xBF, 0xC2, 0xC7}, 1.60}, {"V", {0xA6, 0xA6, 0xAB}, 1.53},  {"Cr", {0x8A, 0x99, 0xC7}, 1.39},
    {"Mn", {0x9C, 0x7A, 0xC7}, 1.39}, {"Fe", {0xE0, 0x66, 0x33}, 1.32}, {"Co", {0xF0, 0x90, 0xA0}, 1.26},
    {"Ni", {0x50, 0xD0, 0x50}, 1.24}, {"Cu", {0xC8, 0x80, 0x33}, 1.32}, {"Zn", {0x7D, 0x80, 0xB0}, 1.22},
    {"Ga", {0xC2, 0x8F, 0x8F}, 1.22}, {"Ge", {0x66, 0x8F, 0x8F}, 1.20}, {"As", {0xBD, 0x80, 0xE3}, 1.19},
    {"Se", {0xFF, 0xA1, 0x00}, 1.20}, {"Br", {0xA6, 0x29, 0x29}, 1.20}, {"Kr", {0x5C, 0xB8, 0xD1}, 1.16},
    {"Rb", {0x70, 0x2E, 0xB0}, 2.20}, {"Sr", {0x00, 0xFF, 0x00}, 1.95}, {"Y", {0x94, 0xFF, 0xFF}, 1.90},
    {"Zr", {0x94, 0xE0, 0xE0}, 1.75}, {"Nb", {0x73, 0xC2, 0xC9}, 1.64}, {"Mo", {0x54, 0xB5, 0xB5}, 1.54},
    {"Tc", {0x3B, 0x9E, 0x9E}, 1.47}, {"Ru", {0x24, 0x8F, 0x8F}, 1.46}, {"Rh", {0x0A, 0x7D, 0x8C}, 1.42},
    {"Pd", {0x00, 0x69, 0x85}, 1.39}, {"Ag", {0xC0, 0xC0, 0xC0}, 1.45}, {"Cd", {0xFF, 0xD9, 0x8F}, 1.44},
    {"In", {0xA6, 0x75, 0x73}, 1.42}, {"Sn", {0x66, 0x80, 0x80}, 1.39}, {"Sb", {0x9E, 0x63, 0xB5}, 1.39},
    {"Te", {0xD4, 0x7A, 0x00}, 1.38}, {"I", {0x94, 0x00, 0x94}, 1.39},  {"Xe", {0x42, 0x9E, 0xB0}, 1.40},
    {"Cs", {0x57, 0x17, 0x8F}, 2.44}, {"Ba", {0x00, 0xC9, 0x00}, 2.15}, {"La", {0x70, 0xD4, 0xFF}, 2.07},
    {"Ce", {0xFF, 0xFF, 0xC7}, 2.04}, {"Pr", {0xD9, 0xFF, 0xC7}, 2.03}, {"Nd", {0xC7, 0xFF, 0xC7}, 2.01},
    {"Pm", {0xA3, 0xFF, 0xC7}, 1.99}, {"Sm", {0x8F, 0xFF, 0xC7}, 1.98}, {"Eu", {0x61, 0xFF, 0xC7}, 1.98},
    {"Gd", {0x45, 0xFF, 0xC7}, 1.96}, {"Tb", {0x30, 0xFF, 0xC7}, 1.94}, {"Dy", {0x1F, 0xFF, 0xC7}, 1.92},
    {"Ho", {0x00, 0xFF, 0x9C}, 1.92}, {"Er", {0x00, 0xE6, 0x75}, 1.89}, {"Tm", {0x00, 0xD4, 0x52}, 1.90},
    {"Yb", {0x00, 0xBF, 0x38}, 1.87}, {"Lu", {0x00, 0xAB, 0x24}, 1.87}, {"Hf", {0x4D, 0xC2, 0xFF}, 1.75},
    {"Ta", {0x4D, 0xA6, 0xFF}, 1.70}, {"W", {0x21, 0x94, 0xD6}, 1.62},  {"Re", {0x26, 0x7D, 0xAB}, 1.51},
    {"Os", {0x26, 0x66, 0x96}, 1.44}, {"Ir", {0x17, 0x54, 0x87}, 1.41}, {"Pt", {0xD0, 0xD0, 0xE0}, 1.36},
    {"Au", {0xFF, 0xD1, 0x23}, 1.36}, {"Hg", {0xB8, 0xB8, 0xD0}, 1.32}, {"Tl", {0xA6, 0x54, 0x4D}, 1.45},
    {"Pb", {0x57, 0x59, 0x61}, 1.46}, {"Bi", {0x9E, 0x4F, 0xB5}, 1.48}, {"Po", {0xAB, 0x5C, 0x00}, 1.40},
    {"At", {0x75, 0x4F, 0x45}, 1.50}, {"Rn", {0x42, 0x82, 0x96}, 1.50}, {"Fr", {0x42, 0x00, 0x66}, 2.60},
    {"Ra", {0x00, 0x7D, 0x00}, 2.21}, {"Ac", {0x70, 0xAB, 0xFA}, 2.15}, {"Th", {0x00, 0xBA, 0xFF}, 2.06},
    {"Pa", {0x00, 0xA1, 0xFF}, 2.00}, {"U", {0x00, 0x8F, 0xFF}, 1.96},  {"Np", {0x00, 0x80, 0xFF}, 1.90},
    {"Pu", {0x00, 0x6B, 0xFF}, 1.87}, {"Am", {0x54, 0x5C, 0xF2}, 1.80}, {"Cm", {0x78, 0x5C, 0xE3}, 1.69},
    {"Bk", {0x8A, 0x4F, 0xE3}, 1.69}, {"Cf", {0xA1, 0x36, 0xD4}, 1.69}, {"Es", {0xB3, 0x1F, 0xD4}, 1.69},
    {"Fm", {0xB3, 0x1F, 0xBA}, 1.69}, {"Md", {0xB3, 0x0D, 0xA6}, 1.69}, {"No", {0xBD, 0x0D, 0x87}, 1.69},
    {"Lr", {0xC7, 0x00, 0x66}, 1.69}, {"Rf", {0xCC, 0x00, 0x59}, 1.69}, {"Db", {0xD1, 0x00, 0x4F}, 1.69},
    {"Sg", {0xD9, 0x00, 0x45}, 1.69}, {"Bh", {0xE0, 0x00, 0x38}, 1.69}, {"Hs", {0xE6, 0x00, 0x2E}, 1.69},
    {"Mt", {0xEB, 0x00, 0x26}, 1.69}, {"Ds", {0xEB, 0x00, 0x26}, 1.69}, {"Rg", {0xEB, 0x00, 0x26}, 1.69},
    {"Cn", {0xEB, 0x00, 0x26}, 1.69}, {"Nh", {0xEB, 0x00, 0x26}, 1.69}, {"Fl", {0xEB, 0x00, 0x26}, 1.69},
    {"Mc", {0xEB, 0x00, 0x26}, 1.69}, {"Lv", {0xEB, 0x00, 0x26}, 1.69}, {"Ts", {0xEB, 0x00, 0x26}, 1.69},
    {"Og", {0xEB, 0x00, 0x26}, 1.69},
});

constexpr Element unknown{"", {0xFF, 0x14, 0x93}, 0.76};  // Jmol's colour for it
constexpr Element no_element{"", {0xFF, 0x14, 0x93}, 0.2};

constexpr std::size_t slots = 27;

// A slot by the places of the letters in the alphabet, from 1; 0 for no letter.
constexpr std::size_t slot(std::string_view symbol) {
    std::size_t place = 0;
    for (std::size_t i = 0; i < 2; ++i) place = slots * place + (i < symbol.size() ? static_cast<std::size_t>(symbol[i] & 31) : 0);
    return place;
}

// Atomic numbers by symbol, 0 for none.
constexpr auto numbers = [] {
    std::array<std::uint8_t, slots * slots> table{};
    for (std::size_t i = 0; i < elements.size(); ++i) table[slot(elements[i].symbol)] = static_cast<std::uint8_t>(i + 1);
    table[slot("D")] = table[slot("T")] = 1;  // deuterium, tritium
    return table;
}();

}  // namespace

const Element* find_element(std::string_view symbol) {
    if (symbol.empty() || symbol.size() > 2 || !std::all_of(symbol.begin(), symbol.end(), is_letter)) return nullptr;
    const std::size_t number = numbers[slot(symbol)];
    return number == 0 ? nullptr : &elements[number - 1];
}

const Element* find_ion(std::string_view name) {
    constexpr auto named = std::to_array<std::pair<std::string_view, std::string_view>>({{"bar", "Ba"},
                                                                                         {"cad", "Cd"},
                                                                                         {"cal", "Ca"},
                                                                                         {"ces", "Cs"},
                                                                                         {"cla", "Cl"},
                                                                                         {"iod", "I"},
                                                                                         {"lit", "Li"},
                                                                                         {"mag", "Mg"},
                                                                                         {"pot", "K"},
                                                                                         {"rub", "Rb"},
                                                                                         {"sod", "Na"}});
    if (name.size() != named[0].first.size()) return find_element(name);
    const auto ion = std::ranges::find(named, lower_case(name), &std::pair<std::string_view, std::string_view>::first);
    return ion == named.end() ? nullptr : find_element(ion->second);
}

const Element& unknown_element() { return unknown; }

const Element& virtual_site() { return no_element; }

bool is_dummy(std::string_view species) {
    constexpr auto beginnings = std::to_array<std::string_view>({"bq", "du", "ep", "gh", "lp", "mw", "tv", "vs"});
    if (species.empty()) return false;
    const std::string name = lower_case(species);
    const std::string_view letters(name.data(), static_cast<std::size_t>(std::ranges::find_if_not(name, is_letter) - name.begin()));
    if (letters.starts_with('x')) return letters != "xe";
    return std::ranges::find(beginnings, letters.substr(0, 2)) != beginnings.end() || letters == "m" || name[0] == '@' ||
           name == "0" || name.ends_with(':') || name.ends_with("-bq") || name.ends_with("_bq") || name.ends_with("(bq)") ||
           name.find("ghost") != std::string::npos;
}

const Element& element_of_species(std::string_view species) {
    // Most species begin with another character, and need no closer look.
    constexpr std::string_view firsts = "BDEGLMTVXbdeglmtvx@0";
    constexpr std::size_t longest_symbol = 5;  // with a charge or a number: longer ones may end in _ghost
    const auto is_last = [](char c) { return c == ':' || c == 'q' || c == 'Q' || c == ')'; };
    const bool may_be = !species.empty() && (species.size() > longest_symbol || firsts.find(species[0]) != std::string_view::npos ||
                                             (species.size() > 1 && is_last(species.back())));
    if (may_be && is_dummy(species)) return no_element;
    std::size_t letters = 0;
    while (letters < species.size() && is_letter(species[letters])) ++letters;
    if (letters == 0) {
        std::uint8_t number = 0;
        return parse_whole(species, number) && number >= 1 && number <= elements.size() ? elements[number - 1U] : unknown;
    }
    const Element* element = find_ion(species.substr(0, letters));
    if (element == nullptr && letters == 2) element = find_element(species.substr(0, 1));
    return element == nullptr ? unknown : *element;
}

std::string_view symbol_or_name(const Element& element, std::string_view name) {
    if (!element.symbol.empty()) return element.symbol;
    return is_virtual(element) && !element_of_species(name).symbol.empty() ? "X" : name;
}

Color color_of_type(std::uint64_t type) {
    constexpr auto colors = std::to_array<Color>({{0xE6, 0x9F, 0x00},
                                                  {0x56, 0xB4, 0xE9},
                                                  {0x00, 0x9E, 0x73},
                                                  {0xF0, 0xE4, 0x42},
                                                  {0x00, 0x72, 0xB2},
                                                  {0xD5, 0x5E, 0x00},
                                                  {0xCC, 0x79, 0xA7},
                                                  {0xBB, 0xBB, 0xBB}});
    return colors[(type - 1) % colors.size()];
}

}  // namespace sphereview
