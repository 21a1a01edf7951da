// Declares options to CLI11, each in one place: its field, its check, its words in --help and in messages.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/command_line_texts.hpp"
#include "app/usage_error.hpp"
#include "base/number.hpp"
#include "base/text.hpp"

namespace sphereview {

// An option's names, the type and help for --help, and the expected value for messages.
struct Words {
    std::string names;
    std::string type;
    std::string help;
    std::string expected;
};

// Declares an option. `read` gives the field's value for a text, or nothing for a wrong text.
template <typename Field, typename Read>
CLI::Option* add_option(CLI::App& command, Field& field, const Words& words, Read read) {
    const std::string name = words.names.substr(words.names.find(',') + 1);
    const auto take = [&command, &field, read, name, expected = words.expected](const CLI::results_t& found) {
        if (found.size() > 1) wrong(name, in_quotes(found[0]) + " and " + in_quotes(found[1]), "only one value");
        if (found[0].empty()) wrong(name, "no value", expected);  // perhaps a script's variable that was never set
        const bool option = found[0].starts_with('-') && find_option(command, found[0]) != nullptr;
        if (option) wrong(name, "the option " + in_quotes(found[0]), expected);
        auto value = read(found[0]);
        if (!value) wrong(name, in_quotes(found[0]), expected + did_you_mean(found[0], words_listed(expected)));
        field = *std::move(value);
        return true;
    };
    return command.add_option(words.names, CLI::callback_t(take), words.help)
        ->type_name(words.type)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

// Declares an option without a value, which sets the field to `value`.
template <typename Field, typename Value = bool>
CLI::Option* add_flag(CLI::App& command, Field& field, const std::string& name, const std::string& help, Value value = true) {
    const auto set = [&field, value] { field = value; };
    return command.add_flag_callback(name, set, help);
}

// The number that the whole text is, from `least` to the type's largest.
template <typename Number>
std::optional<Number> whole_number(std::string_view text, Number least) {
    Number number{};
    return parse_whole(text, number) && number >= least ? std::optional(number) : std::nullopt;
}

inline std::optional<double> number_above_0(std::string_view text, double most = std::numeric_limits<double>::max()) {
    double number = 0.0;
    const bool is_one = parse_double(text, number) == NumberFault::none && number > 0.0 && number <= most;
    return is_one ? std::optional(number) : std::nullopt;
}

// Two numbers with one of the separators between them.
inline std::optional<std::pair<int, int>> whole_numbers(std::string_view text, const char* separators, int least) {
    const std::size_t middle = std::min(text.find_first_of(separators), text.size());
    const auto first = whole_number(text.substr(0, middle), least);
    const auto second = whole_number(text.substr(std::min(middle + 1, text.size())), least);
    return first && second ? std::optional(std::pair(*first, *second)) : std::nullopt;
}

template <typename Field>
CLI::Option* add_file(CLI::App& command, Field& field, const std::string& name, const std::string& type, const std::string& help) {
    return add_option(command, field, {name, type, help, a_file}, [](const std::string& text) { return std::optional(text); });
}

// One file or more.
inline CLI::Option* add_files(CLI::App& command, std::vector<std::string>& files, const std::string& name,
                              const std::string& help) {
    return command.add_option(name, files, help)->required()->type_name("")->check([](const std::string& file) {
        return file.empty() ? std::string("found no value, expected ") + a_file : "";
    });
}

}  // namespace sphereview
