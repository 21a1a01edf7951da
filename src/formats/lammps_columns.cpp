#include "formats/lammps_columns.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "base/text.hpp"

namespace sphereview {

namespace {

// Of old dumps, which name no columns: as they were written by default, unless a place is far outside of the box.
std::vector<std::string_view> unnamed_columns(const TextSource& source, const AtomLines& lines) {
    constexpr double far = 2.0;  // atoms may be a little outside
    LineWalker walker = lines.walker(source, 0);
    for (std::size_t i = 0; i < std::min(lines.count, atom_lines_a_piece); ++i) {
        std::vector<std::string_view> words;
        split_line(walker.step(), 5, words);
        for (std::size_t axis = 2; axis < words.size(); ++axis) {
            double place = 0.0;
            if (parse_any_double(words[axis], place) == NumberFault::none && std::abs(place) > far)
                return {"id", "type", "x", "y", "z"};
        }
    }
    return {"id", "type", "xs", "ys", "zs"};
}

}  // namespace

std::vector<std::string_view> names_of_columns(std::string_view head) {
    constexpr std::size_t longest_item = 1 << 16;
    auto names = words_of(head.substr(head.find(':') + 1, longest_item));
    names.erase(names.begin());  // ATOMS
    return names;
}

DumpColumns dump_columns(const TextSource& source, std::string_view head, const AtomLines& lines) {
    std::vector<std::string_view> names = names_of_columns(head);
    if (names.empty() && lines.count > 0) names = unnamed_columns(source, lines);
    constexpr auto kinds = std::to_array<std::array<std::string_view, 3>>(
        {{"x", "y", "z"}, {"xs", "ys", "zs"}, {"xu", "yu", "zu"}, {"xsu", "ysu", "zsu"}});
    const auto place_of = [&](std::string_view name) {
        return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    };
    DumpColumns found;
    const auto add = [&](DumpField field, std::string_view name) {
        const std::size_t place = place_of(name);
        if (place < names.size()) found.columns.push_back({field, place});
        return place < names.size();
    };
    const auto is_whole = [&](const std::array<std::string_view, 3>& kind) {
        return std::ranges::all_of(kind, [&](std::string_view name) { return place_of(name) < names.size(); });
    };
    const auto whole = std::ranges::find_if(kinds, is_whole);
    std::array<std::string_view, 3> places{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto has_axis = [&](const auto& kind) { return place_of(kind[axis]) < names.size(); };
        const auto kind = whole != kinds.end() ? whole : std::ranges::find_if(kinds, has_axis);
        if (kind == kinds.end()) continue;
        places[axis] = (*kind)[axis];
        found.scaled[axis] = (kind - kinds.begin()) % 2 == 1;
        add(std::array{DumpField::x, DumpField::y, DumpField::z}[axis], places[axis]);
    }
    if (places[0].empty() || places[1].empty()) {
        source.fail_at(trimmed(head, white_space),
                       "found no places among the columns, expected x y z, xs ys zs, xu yu zu or xsu ysu zsu");
    }
    add(DumpField::id, "id");
    add(DumpField::element, "element");
    add(DumpField::type, "type");
    if (!add(DumpField::radius, "radius")) add(DumpField::diameter, "diameter");
    std::ranges::sort(found.columns, {}, &DumpColumn::place);
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (std::ranges::find(places, names[i]) != places.end()) continue;
        const PropertyKind of_values = names[i] == "element" ? PropertyKind::element
                                       : names[i] == "type"  ? PropertyKind::words
                                                             : PropertyKind::found;
        add_column(found.properties, names[i], of_values, i);
    }
    for (const auto& [letter, length] : {std::pair("v", "velocity"), std::pair("f", "force")}) {
        for (std::size_t i = 0; i + 2 < names.size(); ++i) {
            const std::string axis(letter);
            const bool is_vector = names[i] == axis + "x" && names[i + 1] == axis + "y" && names[i + 2] == axis + "z";
            if (is_vector) add_column(found.properties, length, PropertyKind::magnitude, i);
        }
    }
    return found;
}

}  // namespace sphereview
