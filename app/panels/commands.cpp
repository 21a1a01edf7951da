#include "panels/commands.hpp"

#include <algorithm>
#include <cassert>
#include <vector>

#include "base/text.hpp"

namespace sphereview {

namespace {

bool take(std::string_view& text, std::string_view beginning) {
    // What is only a modifier's name is a key: the "+" of "Ctrl++" must stay.
    if (!text.starts_with(beginning) || text.size() == beginning.size()) return false;
    text.remove_prefix(beginning.size());
    return true;
}

std::vector<std::string> alternatives(std::string_view shortcut) {
    std::vector<std::string> found;
    while (!shortcut.empty()) {
        const std::size_t end = std::min(shortcut.find('|'), shortcut.size());
        found.emplace_back(shortcut.substr(0, end));
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

std::optional<CommandId> first_match(std::span<const CommandInfo> commands, std::string_view key_name, bool control, bool shift,
                                     bool alt) {
    const auto is_meant = [&](const CommandInfo& info) { return matches(info.shortcut, key_name, control, shift, alt); };
    auto info = std::ranges::find_if(commands, [&](const CommandInfo& one) { return one.enabled && is_meant(one); });
    if (info == commands.end()) info = std::ranges::find_if(commands, is_meant);
    return info == commands.end() ? std::nullopt : std::optional(info->id);
}

}  // namespace

const CommandInfo& info_of(std::span<const CommandInfo> commands, CommandId id) {
    const auto info = std::ranges::find(commands, id, &CommandInfo::id);
    assert(info != commands.end());
    return *info;
}

std::string first_shortcut(std::string_view shortcut) { return std::string(shortcut.substr(0, shortcut.find('|'))); }

std::string every_shortcut(std::string_view shortcut) { return joined(alternatives(shortcut), " or "); }

bool matches(std::string_view shortcut, std::string_view key_name, bool control, bool shift, bool alt) {
    return std::ranges::any_of(alternatives(shortcut), [&](std::string_view key) {
        const bool wants_control = take(key, "Ctrl+");
        const bool wants_shift = take(key, "Shift+");
        const bool wants_alt = take(key, "Alt+");
        const bool shift_fits = wants_shift == shift || (shift && is_symbol(key));
        return wants_control == control && wants_alt == alt && shift_fits && lower_case(key) == lower_case(key_name);
    });
}

std::optional<CommandId> command_for_key(std::span<const CommandInfo> commands, std::string_view key_name, bool control, bool shift,
                                         bool alt) {
    if (is_symbol(key_name) && !control && !alt) return std::nullopt;
    return first_match(commands, key_name, control, shift, alt);
}

std::optional<CommandId> command_for_character(std::span<const CommandInfo> commands, char32_t character) {
    const char key = character <= U'~' ? static_cast<char>(character) : ' ';
    return is_symbol({&key, 1}) ? first_match(commands, {&key, 1}, false, false, false) : std::nullopt;
}

}  // namespace sphereview
