#include "look/sizes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/elements.hpp"
#include "formats/point_radius.hpp"
#include "look/values.hpp"

namespace sphereview {

namespace {

struct Radii {
    std::string_view symbol;
    double vdw;
    double ionic;
};

constexpr double none = 0.0;

// Van der Waals: A. Bondi, "van der Waals Volumes and Radii", J. Phys. Chem. 1964, 441; for elements of the main groups of which
// that has none, and for hydrogen, M. Mantina et al., "Consistent van der Waals Radii for the Whole Main Group", J. Phys. Chem. A
// 2009, 5806; for the others S. Alvarez, "A cartography of the van der Waals territories", Dalton Trans. 2013, 8617.
//
// Ionic: R. Shannon, "Revised effective ionic radii", Acta Cryst. A 1976, 751: of the ion that is usual (Na+, Fe3+, O2-), with six
// neighbours, of high spin; nitrogen with four, radium with eight.
constexpr auto radii = std::to_array<Radii>({
    {"H", 1.10, none},   {"He", 1.40, none},  {"Li", 1.82, 0.76},  {"Be", 1.53, 0.45},  {"B", 1.92, 0.27},   {"C", 1.70, 0.16},
    {"N", 1.55, 1.46},   {"O", 1.52, 1.40},   {"F", 1.47, 1.33},   {"Ne", 1.54, none},  {"Na", 2.27, 1.02},  {"Mg", 1.73, 0.72},
    {"Al", 1.84, 0.535}, {"Si", 2.10, 0.40},  {"P", 1.80, 0.38},   {"S", 1.80, 1.84},   {"Cl", 1.75, 1.81},  {"Ar", 1.88, none},
    {"K", 2.75, 1.38},   {"Ca", 2.31, 1.00},  {"Sc", 2.58, 0.745}, {"Ti", 2.46, 0.605}, {"V", 2.42, 0.54},   {"Cr", 2.45, 0.615},
    {"Mn", 2.45, 0.83},  {"Fe", 2.44, 0.645}, {"Co", 2.40, 0.745}, {"Ni", 1.63, 0.69},  {"Cu", 1.40, 0.73},  {"Zn", 1.39, 0.74},
    {"Ga", 1.87, 0.62},  {"Ge", 2.11, 0.53},  {"As", 1.85, 0.58},  {"Se", 1.90, 1.98},  {"Br", 1.83, 1.96},  {"Kr", 2.02, none},
    {"Rb", 3.03, 1.52},  {"Sr", 2.49, 1.18},  {"Y", 2.75, 0.90},   {"Zr", 2.52, 0.72},  {"Nb", 2.56, 0.64},  {"Mo", 2.45, 0.59},
    {"Tc", 2.44, 0.645}, {"Ru", 2.46, 0.62},  {"Rh", 2.44, 0.665}, {"Pd", 1.63, 0.86},  {"Ag", 1.72, 1.15},  {"Cd", 1.58, 0.95},
    {"In", 1.93, 0.80},  {"Sn", 2.17, 0.69},  {"Sb", 2.06, 0.76},  {"Te", 2.06, 2.21},  {"I", 1.98, 2.20},   {"Xe", 2.16, none},
    {"Cs", 3.43, 1.67},  {"Ba", 2.68, 1.35},  {"La", 2.98, 1.032}, {"Ce", 2.88, 1.01},  {"Pr", 2.92, 0.99},  {"Nd", 2.95, 0.983},
    {"Pm", none, 0.97},  {"Sm", 2.90, 0.958}, {"Eu", 2.87, 0.947}, {"Gd", 2.83, 0.938}, {"Tb", 2.79, 0.923}, {"Dy", 2.87, 0.912},
    {"Ho", 2.81, 0.901}, {"Er", 2.83, 0.89},  {"Tm", 2.79, 0.88},  {"Yb", 2.80, 0.868}, {"Lu", 2.74, 0.861}, {"Hf", 2.63, 0.71},
    {"Ta", 2.53, 0.64},  {"W", 2.57, 0.60},   {"Re", 2.49, 0.63},  {"Os", 2.48, 0.63},  {"Ir", 2.41, 0.625}, {"Pt", 1.75, 0.625},
    {"Au", 1.66, 0.85},  {"Hg", 1.55, 1.02},  {"Tl", 1.96, 1.50},  {"Pb", 2.02, 1.19},  {"Bi", 2.07, 1.03},  {"Po", 1.97, 0.94},
    {"At", 2.02, none},  {"Rn", 2.20, none},  {"Fr", 3.48, 1.80},  {"Ra", 2.83, 1.48},  {"Ac", 2.80, 1.12},  {"Th", 2.93, 0.94},
    {"Pa", 2.88, 0.90},  {"U", 1.86, 0.89},   {"Np", 2.82, 0.87},  {"Pu", 2.81, 0.86},  {"Am", 2.83, 0.975}, {"Cm", 3.05, 0.97},
    {"Bk", 3.40, 0.96},  {"Cf", 3.05, 0.95},  {"Es", 2.70, none},
});

std::optional<double> known(double radius) { return radius > 0.0 ? std::optional(radius) : std::nullopt; }

bool is_size(double value) { return std::isfinite(value) && value > 0.0; }

double within_doubles(double radius) {
    return std::clamp(radius, std::numeric_limits<double>::min(), std::numeric_limits<double>::max());
}

}  // namespace

std::optional<RadiiKind> radii_named(std::string_view name) {
    const auto found = std::ranges::find(radii_names, name);
    return found == radii_names.end() ? std::nullopt : std::optional(static_cast<RadiiKind>(found - radii_names.begin()));
}

std::optional<double> radius_of_element(std::string_view symbol, RadiiKind kind) {
    const Element* element = find_element(symbol);
    if (element == nullptr) return std::nullopt;
    if (kind == RadiiKind::covalent) return element->radius;
    const auto row = std::ranges::find(radii, element->symbol, &Radii::symbol);
    const std::optional<double> found = row == radii.end() ? std::nullopt : known(kind == RadiiKind::vdw ? row->vdw : row->ionic);
    return !found && kind == RadiiKind::ionic ? std::optional(element->radius) : found;
}

std::optional<double> usual_scale(const Scene& scene, const Property& values) {
    const std::optional<ValueRange> range = range_of(values, true);
    const std::optional<double> quarter = radius_of_points(scene.spheres);
    if (!range || !quarter) return std::nullopt;
    double scale = 0.0;
    const std::string text = decimal(2.0 * *quarter / range->high, std::chars_format::scientific, 2);
    return parse_double(text, scale) == NumberFault::none && scale > 0.0 ? std::optional(scale) : std::nullopt;
}

Sizing size_by(std::vector<Sphere>& spheres, const Property& values, double scale) {
    Sizing sizing{scale, 0};
    const std::optional<ValueRange> range = range_of(values, true);
    if (!range) return {scale, spheres.size()};
    const double small = within_doubles(0.02 * within_doubles(scale * range->high));
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const double value = number_at(values, i);
        spheres[i].radius = is_size(value) ? within_doubles(scale * value) : small;
        sizing.small += is_size(value) ? 0 : 1;
    }
    return sizing;
}

double part_with_sizes(const Scene& scene, const Property& values, double scale) {
    if (scene.spheres.empty() || size_of(values) != scene.spheres.size()) return 0.0;
    constexpr std::size_t most_looked_at = 1000;
    std::size_t looked_at = 0;
    std::size_t same = 0;
    for (std::size_t i = 0; i < scene.spheres.size(); i += scene.spheres.size() / most_looked_at + 1) {
        const double value = number_at(values, i);
        if (!is_size(value)) continue;
        ++looked_at;
        same += scene.spheres[i].radius == within_doubles(scale * value) ? 1 : 0;
    }
    return looked_at == 0 ? 0.0 : static_cast<double>(same) / static_cast<double>(looked_at);
}

std::size_t use_radii(std::vector<Sphere>& spheres, const Property& elements, RadiiKind kind) {
    const auto& [words, numbers] = std::get<Labels>(elements.values);
    std::vector<std::optional<double>> of_words;
    for (const std::string& word : words) of_words.push_back(radius_of_element(element_of_species(word).symbol, kind));
    std::size_t kept = 0;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const std::optional<double>& radius = of_words[numbers[i]];
        if (radius) spheres[i].radius = *radius;
        kept += radius ? 0 : 1;
    }
    return kept;
}

void scale_radii(std::vector<Sphere>& spheres, double factor) {
    for (Sphere& sphere : spheres) sphere.radius = within_doubles(factor * sphere.radius);
}

}  // namespace sphereview
