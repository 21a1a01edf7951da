#include "app/usage_error.hpp"

#include <algorithm>

#include "app/command_line_texts.hpp"
#include "base/input_file.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

// "; did you mean 'NAME'?" for an option of the command or of the program.
std::string similar_option(const CLI::App& command, const std::string& unknown) {
    std::vector<std::string> names;
    for (const CLI::App* app = &command; app != nullptr; app = app->get_parent()) {
        for (const CLI::Option* option : shown_options(*app)) {
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
            for (const std::string& name : option->get_snames()) names.push_back("-" + name);
        }
    }
    if (unknown.size() != 2) return did_you_mean(unknown, names);
    // Of two letters every other option is near. Likely meant were the other case, or words that begin so.
    std::vector<std::string> alike;
    for (const std::string& name : names) {
        if (lower_case(name) == lower_case(unknown)) return did_you_mean(unknown, std::span(&name, 1));
        if (name.starts_with("-" + unknown)) alike.push_back("'" + name + "'");
    }
    return alike.empty() ? "" : "; did you mean " + listed(alike, "or") + "?";
}

// What the option says of an empty value; "" if it has no objection.
std::string said_of_no_value(CLI::Option& option) {
    try {
        option.clear();
        option.add_result("")->run_callback();
    } catch (const CLI::ValidationError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

void wrong(const std::string& name, const std::string& found, std::string_view expected) {
    throw CLI::ValidationError(name, "found " + found + ", expected " + std::string(expected));
}

bool is_option(const std::string& word) { return word.starts_with('-') && word != standard_stream; }

void check_values(const CLI::App& command, const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        if (word == "--") return;
        const std::size_t equals = word.find('=');
        if (!word.starts_with("--") || equals == std::string::npos) continue;
        const std::string name = word.substr(0, equals);
        const CLI::Option* option = find_option(command, name);
        if (option == nullptr) continue;
        if (option->get_items_expected_max() == 0) wrong(name, in_quotes(word.substr(equals + 1)), "no value");
        if (equals + 1 == word.size()) throw CLI::ArgumentMismatch(name + ":", CLI::ExitCodes::ArgumentMismatch);
    }
}

std::string expected_value(CLI::Option& option) {
    constexpr std::string_view before = ", expected ";
    const std::string said = said_of_no_value(option);
    const std::size_t found = said.find(before);
    return found == std::string::npos ? "" : said.substr(found + before.size());
}

std::string in_words(CLI::App& command, const CLI::ParseError& error) {
    std::vector<std::string> left = command.remaining();
    std::erase(left, "--");  // that what follows are no options, CLI11 has heeded
    const auto unknown = std::ranges::find_if(left, is_option);
    if (unknown != left.end()) {
        const std::string name = unknown->starts_with("--") ? unknown->substr(0, unknown->find('=')) : *unknown;
        return "unknown option " + in_quotes(name) + similar_option(command, name);
    }
    std::string said = error.what();
    if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr) said.replace(said.find(" requires "), 10, " needs ");
    if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr) said.replace(said.find(" excludes "), 10, " does not go with ");
    const bool lacks_value =
        dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr || dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
    CLI::Option* option = lacks_value ? find_option(command, said.substr(0, said.find_first_of(": "))) : nullptr;
    if (lacks_value && option == nullptr) {
        // CLI11 does not name a hidden option; no command has two.
        for (CLI::Option* hidden : command.get_options([](const CLI::Option* any) { return any->get_group().empty(); })) {
            option = hidden;
        }
    }
    const std::string empty = option == nullptr ? "" : said_of_no_value(*option);
    if (!empty.empty()) return empty;
    return left.empty() ? said : "unexpected argument " + in_quotes(left.front());
}

}  // namespace sphereview
