// Examines a text in TOML or JSON without parsing it: its nesting, which is bounded because the parsers and their trees recurse;
// unknown keys, before a tree is made of them; and comments, which the trees do not hold.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace sphereview {

inline constexpr int most_nested = 32;  // levels of brackets, and parts of a dotted key or of a table's head

// The place where a text first goes deeper than most_nested levels.
struct TooDeep {
    std::size_t offset = 0;  // of the bracket or the dot that is one too many
    bool in_key = false;     // in a key; else in brackets
};

// Ignores strings and comments. May be wrong behind the first fault of a text, where parsers stop anyway.
std::optional<TooDeep> find_too_deep(std::string_view text);

struct KeyInText {
    std::size_t offset = 0;
    std::string_view key{};  // without quotes
};

// The first key of TOML's top level, also in the head of a table, that is not in `known`. Nothing if there is none, or behind a
// fault. Keys with escapes are passed over.
std::optional<KeyInText> find_unknown_key(std::string_view text, std::span<const std::string> known);

// Whether the text has a comment of TOML outside strings.
bool has_comment(std::string_view text);

}  // namespace sphereview
