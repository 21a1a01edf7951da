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

// The number of columns of a field.
constexpr std::size_t columns_of(XyzField field) {
    if (field == XyzField::species || field == XyzField::radius) return 1;
    if (field == XyzField::flagged_position) return 6;
    return field == XyzField::flat_position ? 2 : 3;
}

struct XyzColumn {
    XyzField field;
    std::size_t first;  // the first of its columns, from 0
};

// The columns that are drawn, from left to right; a position is always among them.
struct XyzLayout {
    std::vector<XyzColumn> columns;
    double full_color = 1.0;                   // stands for 255
    std::vector<PropertyColumn> properties{};  // all but the position
    bool is_plain = false;                     // the columns have no names
    bool has_names = false;                    // the species are force fields' names of atoms
    bool has_types = false;                    // numbers as species are types, not elements
    std::size_t width = 4;                     // the least number of columns, drawn or not

    bool has(XyzField field) const { return std::ranges::find(columns, field, &XyzColumn::field) != columns.end(); }
};

// The value of a key, given in lower case, among the `key=value` of a comment, in any letter case.
std::optional<std::string_view> value_in_comment(std::string_view comment, std::string_view wanted);

// `comment`: the frame's, in which `Properties=species:S:1:pos:R:3:...` names the columns; without it they are a species and a
// position. Other properties are passed over. `atoms`: the frame's lines, which show whether MOPAC wrote them; the comment shows
// whether LAMMPS did. Throws InputError if Properties are wrong.
XyzLayout xyz_layout(const TextSource& source, std::string_view comment, const AtomLines& atoms);

// TINKER's columns: the atom's number, name, position, type and bound atoms.
XyzLayout tinker_layout();

}  // namespace sphereview
