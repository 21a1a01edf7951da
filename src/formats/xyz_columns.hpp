// The columns of an extended XYZ.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "formats/atom_lines.hpp"
#include "formats/lines.hpp"
#include "formats/property_columns.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

enum class XyzField {
    species,
    position,
    flat_position,     // x and y
    flagged_position,  // a flag of MOPAC behind each coordinate
    radius,
    color
};

// How many columns each takes.
constexpr std::size_t columns_of(XyzField field) {
    if (field == XyzField::species || field == XyzField::radius) return 1;
    if (field == XyzField::flagged_position) return 6;
    return field == XyzField::flat_position ? 2 : 3;
}

struct XyzColumn {
    XyzField field;
    std::size_t first;  // of its columns, from 0
};

// The columns that are drawn, from left to right; a position is always among them.
struct XyzLayout {
    std::vector<XyzColumn> columns;
    double full_color = 1.0;                   // what stands for 255
    std::vector<PropertyColumn> properties{};  // all but the position
    bool is_plain = false;                     // nothing names the columns
    bool has_names = false;                    // the species are atoms' names, as force fields have them
    bool has_types = false;                    // species that are numbers are types, whatever their element
    std::size_t width = 4;                     // how many columns there are at least, drawn or not

    bool has(XyzField field) const { return std::ranges::find(columns, field, &XyzColumn::field) != columns.end(); }
};

// The value of a key, in lower case, among the `key=value` of a comment, whose keys may be in any letter case.
std::optional<std::string_view> value_in_comment(std::string_view comment, std::string_view wanted);

// `comment`: the frame's, in which `Properties=species:S:1:pos:R:3:...` names the columns; without it they are a species and a
// position. Other properties are passed over. `atoms`: where the frame's lines are, which show whether MOPAC wrote them; the
// comment shows whether LAMMPS did. Throws InputError where Properties are wrong.
XyzLayout xyz_layout(const TextSource& source, std::string_view comment, const AtomLines& atoms);

// Of TINKER: the atom's number, its name, a position, its type and the atoms that it is bound to.
XyzLayout tinker_layout();

}  // namespace sphereview
