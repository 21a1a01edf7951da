#include "formats/csv_columns.hpp"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <iterator>

#include "base/number.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

// Three columns that belong together.
using Triple = std::array<std::string_view, 3>;

// The first that is whole is taken. Those of several programs' files stand behind what is plainer.
constexpr auto place_names = std::to_array<Triple>({
    {"x", "y", "z"},
    {"positionx", "positiony", "positionz"},  // OVITO, Imaris, TrackMate
    {"xposition", "yposition", "zposition"},
    {"posx", "posy", "posz"},
    {"xpos", "ypos", "zpos"},
    {"points0", "points1", "points2"},  // ParaView
    {"pointsx", "pointsy", "pointsz"},
    {"position0", "position1", "position2"},
    {"positions0", "positions1", "positions2"},
    {"coordinates0", "coordinates1", "coordinates2"},
    {"coords0", "coords1", "coords2"},
    {"coordinatex", "coordinatey", "coordinatez"},
    {"coordinatesx", "coordinatesy", "coordinatesz"},
    {"xcoordinate", "ycoordinate", "zcoordinate"},
    {"coordx", "coordy", "coordz"},
    {"coordsx", "coordsy", "coordsz"},
    {"xcoord", "ycoord", "zcoord"},
    {"cartnx", "cartny", "cartnz"},
    {"centerx", "centery", "centerz"},
    {"centrex", "centrey", "centrez"},
    {"xcenter", "ycenter", "zcenter"},
    {"xcentre", "ycentre", "zcentre"},
    {"centroidx", "centroidy", "centroidz"},
    {"xcentroid", "ycentroid", "zcentroid"},
    {"locationcenterx", "locationcentery", "locationcenterz"},     // CellProfiler
    {"areashapecenterx", "areashapecentery", "areashapecenterz"},  // CellProfiler
    {"centerofmassx", "centerofmassy", "centerofmassz"},
    {"cx", "cy", "cz"},
    {"xm", "ym", "zm"},                       // ImageJ's centre of mass
    {"centroid0", "centroid1", "centroid2"},  // scikit-image
    {"centroid1", "centroid2", "centroid3"},  // MATLAB's regionprops3
    {"var1", "var2", "var3"},                 // MATLAB's array2table
    {"v1", "v2", "v3"},                       // R's as.data.frame
});

constexpr auto color_names = std::to_array<Triple>({
    {"r", "g", "b"},
    {"red", "green", "blue"},
    {"colorr", "colorg", "colorb"},  // OVITO
    {"colorred", "colorgreen", "colorblue"},
    {"rgb0", "rgb1", "rgb2"},  // ParaView
    {"color0", "color1", "color2"},
    {"colors0", "colors1", "colors2"},
    {"rf", "gf", "bf"},  // CloudCompare
});

constexpr auto units = std::to_array<std::string_view>(
    {"nm",     "um",       "\xC2\xB5m", "\xCE\xBCm", "mm",       "cm",           "m",   "km",  "pm",    "fm",     "a",
     "ang",    "angstrom", "angstroms", "\xC3\xA5",  "\xC3\x85", "\xE2\x84\xAB", "px",  "pix", "pixel", "pixels", "voxel",
     "voxels", "micron",   "microns",   "unit",      "units",    "pc",           "kpc", "mpc", "au",    "in",     "ft"});

std::string compact(std::string_view name) {
    std::string key(name);
    std::erase_if(key, [](char c) { return std::string_view(" \t_.:-/").find(c) != std::string_view::npos; });
    return key;
}

// `name` without "[nm]", "(um)" or "{mm}" at its end.
std::string_view without_bracket(std::string_view name) {
    constexpr std::string_view opening = "([{";
    const std::size_t bracket = name.empty() ? std::string_view::npos : std::string_view(")]}").find(name.back());
    if (bracket == std::string_view::npos) return name;
    const std::size_t open = name.rfind(opening[bracket]);
    if (open == std::string_view::npos || open == 0) return name;
    return trimmed(name.substr(0, open));
}

// Where the unit of "x_um", "x nm" or "x in mm" begins; npos where there is none.
std::size_t unit_behind_name(std::string_view name) {
    const std::size_t end = name.find_last_of(" _/,-");
    if (end == std::string_view::npos || end == 0) return std::string_view::npos;
    return std::ranges::find(units, name.substr(end + 1)) == units.end() ? std::string_view::npos : end + 1;
}

// `name` without "_um", " nm" or " in mm" at its end.
std::string_view without_unit(std::string_view name) {
    constexpr std::string_view in = " in";
    const std::size_t unit = unit_behind_name(name);
    if (unit == std::string_view::npos) return name;
    name = name.substr(0, unit - 1);
    return name.size() > in.size() && name.ends_with(in) ? name.substr(0, name.size() - in.size()) : name;
}

// Where the key is among what `key_of` makes of the names.
template <typename KeyOf = std::identity>
std::optional<std::size_t> place_among(const std::vector<std::string>& names, std::string_view key, KeyOf key_of = {}) {
    const auto found = std::ranges::find(names, key, key_of);
    return found == names.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - names.begin()));
}

class Names {
public:
    explicit Names(const std::vector<std::string>& names) : names_(names) {
        std::ranges::transform(names, std::back_inserter(keys_), [](const std::string& name) { return column_key(name); });
    }

    std::optional<std::size_t> find(std::string_view key) const { return place_among(keys_, key); }

    // The column that is called so, to the letter.
    std::optional<std::size_t> find_exactly(std::string_view name) const { return place_among(names_, name); }

    std::optional<std::size_t> first_of(std::initializer_list<std::string_view> keys) const {
        for (const std::string_view key : keys) {
            if (const auto place = find(key)) return place;
        }
        return std::nullopt;
    }

    // pandas writes an array's columns as their numbers, behind a nameless one of the rows'.
    bool are_numbers() const {
        if (keys_.size() < 3 || !keys_[0].empty()) return false;
        for (std::size_t i = 1; i < keys_.size(); ++i) {
            if (keys_[i] != std::to_string(i - 1)) return false;
        }
        return true;
    }

private:
    const std::vector<std::string>& names_;
    std::vector<std::string> keys_{};
};

void put(CsvColumns& columns, CsvColumn first, const std::array<std::optional<std::size_t>, 3>& places) {
    for (std::size_t i = 0; i < 3; ++i) columns.places[static_cast<std::size_t>(first) + i] = places[i];
}

// By what their names say.
CsvColumns columns_by_name(const ColumnNames& names) {
    const Names known(names);
    const auto found = [&](const Triple& triple) {
        return std::array{known.find(triple[0]), known.find(triple[1]), known.find(triple[2])};
    };
    CsvColumns columns;
    if (known.are_numbers()) {
        columns.places = {1, 2, names.size() > 3 ? std::optional<std::size_t>(3) : std::nullopt};
        return columns;
    }
    // Beside x, y and z there may be an X, or a Z for atomic numbers.
    const std::array exactly = {known.find_exactly("x"), known.find_exactly("y"), known.find_exactly("z")};
    const bool is_exact = exactly[0] && exactly[1] && exactly[2];
    for (const Triple& triple : place_names) {
        const auto places = is_exact ? exactly : found(triple);
        if (!places[0] || !places[1]) continue;
        const bool numbered = triple[2].back() >= '0' && triple[2].back() <= '9';
        if (places[2]) {
            put(columns, CsvColumn::x, places);
            break;
        }
        // A plane, unless there are places in space, too.
        if (!columns.has(CsvColumn::x) && !numbered) put(columns, CsvColumn::x, places);
    }
    columns[CsvColumn::radius] = known.first_of({"radius", "rad", "radii", "meanradius", "rayon"});
    if (!columns.has(CsvColumn::radius) && !known.find("g") && !known.find("b")) columns[CsvColumn::radius] = known.find("r");
    columns[CsvColumn::diameter] = known.first_of({"diameter", "diam", "estimateddiameter", "equivalentdiameter", "equivdiameter",
                                                   "areashapeequivalentdiameter", "durchmesser", "diametre"});
    for (const Triple& triple : color_names) {
        const auto places = found(triple);
        if (!places[0] || !places[1] || !places[2]) continue;
        put(columns, CsvColumn::red, places);
        break;
    }
    columns[CsvColumn::color] = known.first_of({"color", "colour", "hex", "hexcolor", "colorhex", "rgb", "farbe", "couleur"});
    columns[CsvColumn::element] = known.first_of({"element", "species", "symbol", "atomsymbol", "elementsymbol", "type", "atomtype",
                                                  "particletype", "atom", "atomname", "atomicnumber"});
    const bool has_other_places = known.find_exactly("X") || known.find_exactly("Y");
    if (!columns.has(CsvColumn::element) && is_exact && !has_other_places) columns[CsvColumn::element] = known.find_exactly("Z");
    columns[CsvColumn::name] = known.find("name");
    return columns;
}

std::optional<std::size_t> place_of(const std::string& choice, const ColumnNames& names) {
    if (const auto place = place_among(names, choice)) return place;
    if (const auto place = place_among(names, lower_case(choice), lower_case)) return place;
    return place_among(names, column_key(choice), column_key);
}

std::optional<std::size_t> number_of(const std::string& choice, std::size_t fields) {
    std::size_t number = 0;
    return parse_whole(choice, number) && number >= 1 && number <= fields ? std::optional(number - 1) : std::nullopt;
}

}  // namespace

std::string column_key(std::string_view name) {
    std::string lower = lower_case(name);
    constexpr std::string_view no_break_space = "\xC2\xA0";
    for (std::size_t i = 0; (i = lower.find(no_break_space, i)) != std::string::npos;) lower.replace(i, no_break_space.size(), " ");
    const std::string_view plain = without_bracket(trimmed(lower));
    return compact(without_unit(plain));
}

bool is_unit(std::string_view text) {
    const std::string lower = lower_case(trimmed(text, " ()[]{}"));
    return std::ranges::find(units, lower) != units.end();
}

std::string unit_in(std::string_view name) {
    const std::string_view plain = trimmed(name);
    const std::string_view before = without_bracket(plain);
    if (before.size() < plain.size()) {
        const std::string_view bracket = trimmed(plain.substr(before.size()));
        const std::string_view inside = trimmed(bracket.substr(1, bracket.size() - 2));
        const bool may_be_any = bracket[0] == '[' && inside.find_first_of("0123456789") == std::string_view::npos;
        return is_unit(inside) || may_be_any ? std::string(inside) : "";
    }
    const std::size_t unit = unit_behind_name(lower_case(plain));
    return unit == std::string_view::npos ? "" : std::string(plain.substr(unit));
}

ChosenColumns choose_columns(const ColumnNames& names, const std::vector<ColumnChoice>& choices) {
    ChosenColumns chosen;
    chosen.columns = columns_by_name(names);
    apply_choices(names, choices, chosen);
    return chosen;
}

void apply_choices(const ColumnNames& names, const std::vector<ColumnChoice>& choices, ChosenColumns& chosen) {
    std::size_t numbers = 0;
    for (const ColumnChoice& choice : choices) {
        const auto known = std::ranges::find(csv_column_names, choice.column);
        auto place = number_of(choice.field, names.size());
        if (place && (choice.column == "x" || choice.column == "y")) ++numbers;
        if (!place) place = place_of(choice.field, names);
        if (!place && chosen.missing == nullptr) chosen.missing = &choice;
        const auto column = static_cast<std::size_t>(known - csv_column_names.begin());
        for (auto& other : chosen.columns.places) {
            if (other == place) other.reset();  // what is asked for and what its name says
        }
        chosen.columns.places[column] = place;
        if (choice.column == "diameter") chosen.columns[CsvColumn::radius].reset();
    }
    chosen.places_by_number = numbers == 2;
}

std::optional<std::vector<ColumnChoice>> parse_column_choices(const std::string& text) {
    std::vector<ColumnChoice> choices;
    std::string_view rest = text;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(','), rest.size());
        const std::string_view part = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        const std::string column = lower_case(trimmed(part.substr(0, part.find('='))));
        if (part.find('=') != std::string_view::npos && std::ranges::find(csv_column_names, column) != csv_column_names.end()) {
            const auto same = std::ranges::find(choices, column, &ColumnChoice::column);
            if (same != choices.end()) return std::nullopt;
            choices.push_back({column, std::string(trimmed(part.substr(part.find('=') + 1)))});
        } else if (!choices.empty()) {
            choices.back().field += "," + std::string(part);
        } else {
            return std::nullopt;
        }
    }
    const auto is_named = [](const ColumnChoice& choice) { return !choice.field.empty(); };
    return !choices.empty() && std::ranges::all_of(choices, is_named) ? std::optional(choices) : std::nullopt;
}

}  // namespace sphereview
