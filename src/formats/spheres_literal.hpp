// The one long string of a native scene, found without a TOML parser: that copies it several times.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sphereview {

struct SpheresLiteral {
    std::string_view text;  // inside `spheres = """..."""`, without the line end that may stand first
    std::string rest;       // the whole document with that string emptied; every place outside it has the same line and column
};

// Finds the string where that is plain: a line of the top-level table, before any other string of several lines, and nothing but
// numbers and white space inside. Nothing otherwise: the TOML parser then reads or refuses it.
std::optional<SpheresLiteral> find_spheres_literal(std::string_view content);

}  // namespace sphereview
