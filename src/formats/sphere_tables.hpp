// The [[sphere]] tables of a native scene, found without a TOML parser, which makes some 20 bytes of each byte of a text: a large
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
    std::size_t names = 0;                   // of them at most, that have one
    std::string rest{};                      // the document without them
};

// Finds the tables where that is plain: each head alone on its line, and no string of several lines in the document. Each piece
// has about `piece` bytes. Nothing where there are none. What looks like a head and is none, or is written in another way, makes
// the pieces or the rest wrong: then the whole document tells.
std::optional<SphereTables> find_sphere_tables(std::string_view content, std::size_t piece);

}  // namespace sphereview
