// What can be told of a text in TOML or JSON without parsing it. How deep it nests: foreign parsers and the trees that they make
// recurse, so what they get is bounded. And whether it has comments, which those trees do not hold.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace sphereview {

inline constexpr int most_nested = 32;  // levels of brackets, and parts of a dotted key or of a table's head

// Where `text` first goes deeper than most_nested levels, and in what.
struct TooDeep {
    std::size_t offset = 0;  // of the bracket or the dot that is one too many
    bool in_key = false;     // else in brackets
};

// Strings and comments count for nothing. What is no TOML may be judged wrongly behind its first fault, which parsers end at.
std::optional<TooDeep> find_too_deep(std::string_view text);

// Whether a comment of TOML stands in the text, outside its strings.
bool has_comment(std::string_view text);

}  // namespace sphereview
