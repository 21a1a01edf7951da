// What the columns of an XYZ file are.
#pragma once

#include <cstddef>
#include <vector>

#include "formats/text_format.hpp"

namespace sphereview {

enum class XyzField { species, position, radius, real_color, byte_color };

// How many columns each takes.
constexpr std::size_t columns_of(XyzField field) { return field == XyzField::species || field == XyzField::radius ? 1 : 3; }

struct XyzColumn {
    XyzField field;
    std::size_t first;  // of its columns, from 0
};

// The columns that are drawn, from left to right; a position is always among them. `source` ends with the frame's comment, which
// begins at `begin`: `Properties=species:S:1:pos:R:3:...` names them; without it they are a species and a position. Other
// properties are passed over. Throws InputError where Properties are wrong.
std::vector<XyzColumn> xyz_layout(const TextSource& source, std::size_t begin);

}  // namespace sphereview
