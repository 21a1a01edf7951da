// Messages for mistakes on the command line, where CLI11's are hard to understand.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace sphereview {

// Throws "NAME: found FOUND, expected EXPECTED", which CLI11 makes one line of.
[[noreturn]] void wrong(const std::string& name, const std::string& found, std::string_view expected);

// The command's option of that name, or null. CLI11's own search allocates in functions that are noexcept.
template <typename App>
auto find_option(App& command, const std::string& name) {
    const auto options = command.get_options();
    const auto found = std::ranges::find_if(options, [&](const CLI::Option* option) { return option->check_name(name); });
    return found == options.end() ? nullptr : *found;
}

// Whether `word` is written like an option.
bool is_option(const std::string& word);

// Refuses "--output=", for which CLI11 would take the next word as value, and "--json=no", whose value CLI11 would interpret.
void check_values(const CLI::App& command, const std::vector<std::string>& words);

// The expected value in the option's messages; "" where there is none. Clears the option's value.
std::string expected_value(CLI::Option& option);

// The message for an error in the words behind the command's name.
std::string in_words(CLI::App& command, const CLI::ParseError& error);

}  // namespace sphereview
