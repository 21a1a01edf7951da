#include "app/argument_check.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "app/typed_options.hpp"
#include "base/input_file.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

// An option as typed, in one word: --name, --name=value, -n or -nvalue.
struct OptionWord {
    std::string name;  // with its dashes
    bool has_value = false;
    std::string value;
};

OptionWord split(const std::string& word) {
    if (!word.starts_with("--")) return {word.substr(0, 2), word.size() > 2, word.size() > 2 ? word.substr(2) : ""};
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) return {word, false, ""};
    return {word.substr(0, equals), true, word.substr(equals + 1)};
}

const CLI::Option* find(const CLI::App& command, const std::string& name) {
    const auto options = command.get_options();
    const auto found = std::find_if(options.begin(), options.end(), [&](const auto* option) { return option->check_name(name); });
    return found == options.end() ? nullptr : *found;
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

std::string suggestion(const CLI::App& command, const std::string& name) {
    const bool one_letter = name.size() == 2;
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_group().empty()) continue;
        for (const std::string& known : option->get_lnames()) names.push_back("--" + known);
        for (const std::string& known : option->get_snames()) names.push_back("-" + known);
    }
    // Of two letters every other option is near: only the other case was likely meant.
    if (one_letter) std::erase_if(names, [&](const std::string& known) { return lower_case(known) != lower_case(name); });
    return did_you_mean(name, names);
}

bool is_option(const std::string& word) { return word.starts_with('-') && word != standard_stream; }

// Whether the word behind an option that takes a value is rather the next option. (--name=-word takes any word.)
bool is_known_option(const CLI::App& command, const std::string& word) {
    return word == "--" || (is_option(word) && find(command, split(word).name) != nullptr);
}

}  // namespace

bool begins_usual_command(const CLI::App& app, const CLI::App& usual, const std::string& word) {
    std::vector<std::string> commands;
    for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
    if (std::find(commands.begin(), commands.end(), word) != commands.end()) return false;
    if (is_option(word)) {
        if (find(app, word) != nullptr) return false;
        if (word == "--" || find(usual, split(word).name) != nullptr) return true;
        const std::string meant = suggestion(app, split(word).name);
        throw WrongUsage("unknown option " + in_quotes(word) + (meant.empty() ? suggestion(usual, split(word).name) : meant));
    }
    std::error_code ignored;
    const bool path =
        word == standard_stream || word.find_first_of("/\\.") != std::string::npos || std::filesystem::exists(word, ignored);
    if (!path) throw WrongUsage("unknown command " + in_quotes(word) + did_you_mean(word, commands));
    return true;
}

Arguments check_options(const CLI::App& command, std::span<const char* const> words) {
    Arguments arguments;
    bool options_end = false;
    std::map<const CLI::Option*, std::string> given;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string word = words[i];
        if (options_end || !is_option(word)) {
            arguments.files.push_back(word);
            continue;
        }
        if (word == "--") {
            options_end = true;
            continue;
        }
        OptionWord typed = split(word);
        // -output would be the option -o with the value 'utput'.
        const std::string whole = word.substr(0, word.find('='));
        if (!word.starts_with("--") && find(command, "-" + whole) != nullptr && whole.size() > 2) typed.name = whole;
        const CLI::Option* option = find(command, typed.name);
        if (option == nullptr) {
            const std::string& unknown = word.starts_with("--") ? typed.name : whole;
            throw WrongUsage("unknown option " + in_quotes(unknown) + suggestion(command, unknown));
        }
        if (option == command.get_help_ptr()) return {true, {}};
        const std::string name = "--" + option->get_lnames().front();
        if (!takes_value(*option)) {
            if (typed.has_value) throw WrongUsage(name + ": found " + in_quotes(typed.value) + ", but it takes no value");
            continue;
        }
        const std::string expected = ", expected " + option->get_type_name();
        if (!typed.has_value) {
            if (i + 1 == words.size()) throw WrongUsage(name + ": found no value" + expected);
            typed.value = words[++i];
            if (is_known_option(command, typed.value)) {
                throw WrongUsage(name + ": found the option " + in_quotes(typed.value) + expected);
            }
        } else if (typed.value.empty()) {  // CLI11 would take the next word
            throw WrongUsage(name + ": found no value" + expected);
        }
        const auto [before, first] = given.emplace(option, typed.value);
        if (!first) {
            throw WrongUsage(name + ": found " + in_quotes(before->second) + " and " + in_quotes(typed.value) +
                             ", expected only one value");
        }
    }
    return arguments;
}

void check_complete(const CLI::App& command) {
    std::vector<std::string> extras = command.remaining();
    std::erase(extras, "--");  // that what follows are no options, it has heeded itself
    if (!extras.empty()) throw WrongUsage("unexpected argument " + in_quotes(extras.front()));
    for (const CLI::Option* option : command.get_options()) {
        if (!option->get_required() || option->count() > 0) continue;
        const std::string value = option->get_positional() ? "" : " " + option->get_type_name();
        throw WrongUsage("found no " + option->get_name() + value + ", which " + command.get_name() + " needs");
    }
}

}  // namespace sphereview
