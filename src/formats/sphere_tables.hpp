// Finds the [[sphere]] tables of a native scene without a TOML parser, which needs some 20 bytes for each byte of a text: a large
// scene is then parsed some hundred tables at a time.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sphereview {

struct SphereTables {
    std::vector<std::string_view> pieces{};  // of whole tables, in the document's order
    std::size_t count = 0;                   // of the tables
    std::size_t names = 0;                   // upper bound on the number of names
    std::string rest{};                      // the document without the tables
};

// Finds the tables in plain cases: each head alone on its line, and no string of several lines in the document. Each piece has
// about `piece` bytes. Nothing if there are none. Something that looks like a head and is none makes the pieces or the rest wrong;
// then the whole document must be parsed.
std::optional<SphereTables> find_sphere_tables(std::string_view content, std::size_t piece);

}  // namespace sphereview
