// What can be told of a text in TOML or JSON without parsing it. How deep it nests: foreign parsers and the trees that they make
// recurse, so what they get is bounded. Which keys it has that nobody knows, before a tree is made of them. And whether it has
// comments, which those trees do not hold.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
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

struct KeyInText {
    std::size_t offset = 0;
    std::string_view key{};  // without quotes
};

// The first key of TOML's top level, which the head of a table may name too, that `known` lacks. Nothing where there is none, or
// something before it is no TOML. A key with an escape in it is passed over.
std::optional<KeyInText> find_unknown_key(std::string_view text, std::span<const std::string> known);

// Whether a comment of TOML stands in the text, outside its strings.
bool has_comment(std::string_view text);

}  // namespace sphereview
