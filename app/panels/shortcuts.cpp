#include <algorithm>
#include <vector>

#include "base/text.hpp"
#include "panels/commands.hpp"

namespace sphereview {

namespace {

// A key with what must be held.
struct Keys {
    bool control = false;
    bool shift = false;
    bool alt = false;
    std::string_view key;
};

bool take(std::string_view& text, std::string_view beginning) {
    // What is only a modifier's name is a key: the "+" of "Ctrl++" must stay.
    if (!text.starts_with(beginning) || text.size() == beginning.size()) return false;
    text.remove_prefix(beginning.size());
    return true;
}

Keys keys_of(std::string_view text) {
    Keys keys;
    keys.control = take(text, "Ctrl+");
    keys.shift = take(text, "Shift+");
    keys.alt = take(text, "Alt+");
    keys.key = text;
    return keys;
}

std::vector<std::string_view> alternatives(std::string_view shortcut) {
    std::vector<std::string_view> found;
    while (!shortcut.empty()) {
        const std::size_t end = std::min(shortcut.find('|'), shortcut.size());
        found.push_back(shortcut.substr(0, end));
        shortcut.remove_prefix(std::min(end + 1, shortcut.size()));
    }
    return found;
}

// One printable ASCII character that is neither a letter nor a digit.
bool is_symbol(std::string_view key) {
    if (key.size() != 1 || key[0] <= ' ' || key[0] > '~') return false;
    const char c = lower_case(key)[0];
    return !(c >= 'a' && c <= 'z') && !(c >= '0' && c <= '9');
}

}  // namespace

std::string first_shortcut(std::string_view shortcut) { return std::string(shortcut.substr(0, shortcut.find('|'))); }

std::string every_shortcut(std::string_view shortcut) {
    std::string text;
    for (const std::string_view one : alternatives(shortcut)) text += (text.empty() ? "" : " or ") + std::string(one);
    return text;
}

bool matches(std::string_view shortcut, std::string_view key_name, bool control, bool shift, bool alt) {
    return std::ranges::any_of(alternatives(shortcut), [&](std::string_view one) {
        const Keys keys = keys_of(one);
        const bool shift_fits = keys.shift == shift || (shift && is_symbol(keys.key));
        return keys.control == control && keys.alt == alt && shift_fits && lower_case(keys.key) == lower_case(key_name);
    });
}

std::optional<CommandId> command_for_key(std::string_view key_name, bool control, bool shift, bool alt) {
    if (is_symbol(key_name) && !control && !alt) return std::nullopt;
    for (const CommandInfo& info : all_commands()) {
        if (matches(info.shortcut, key_name, control, shift, alt)) return info.id;
    }
    return std::nullopt;
}

std::optional<CommandId> command_for_character(char32_t character) {
    if (character > U'~') return std::nullopt;
    const char key = static_cast<char>(character);
    if (!is_symbol({&key, 1})) return std::nullopt;
    for (const CommandInfo& info : all_commands()) {
        if (matches(info.shortcut, {&key, 1}, false, false, false)) return info.id;
    }
    return std::nullopt;
}

}  // namespace sphereview
