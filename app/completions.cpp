#include <algorithm>
#include <array>
#include <string_view>

#include "app/command_line_texts.hpp"
#include "app/usage_error.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

// An option or a positional argument, as a shell has to know it.
struct Argument {
    enum class Value { none, file, folder, word };
    std::vector<std::string> names;  // with their hyphens; of a positional argument none
    std::string type;                // what --help calls the value
    std::string help;
    Value value = Value::none;
    std::vector<std::string> choices;  // of a word, as far as they can be listed
    bool is_many = false;              // a positional argument that may be given more than once
};

struct Command {
    std::string name;  // "" for the program itself
    std::string help;
    std::vector<Argument> arguments;
};

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) text.replace(at, from.size(), to);
    return text;
}

Argument argument_of(CLI::Option& option) {
    Argument argument{
        {}, option.get_type_name(), option.get_description(), Argument::Value::none, {}, option.get_items_expected_max() > 1};
    for (const std::string& name : option.get_snames()) argument.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) argument.names.push_back("--" + name);
    if (argument.names.empty()) argument.type = option.get_name();
    if (option.get_items_expected_max() == 0) return argument;
    const std::string expected = expected_value(option);
    argument.value = expected == a_file     ? Argument::Value::file
                     : expected == a_folder ? Argument::Value::folder
                                            : Argument::Value::word;
    if (argument.value == Argument::Value::word) argument.choices = words_listed(expected);
    return argument;
}

Command command_of(CLI::App& app) {
    Command command{app.get_parent() == nullptr ? "" : app.get_name(), app.get_description(), {}};
    for (CLI::Option* option : shown_options(app)) command.arguments.push_back(argument_of(*option));
    return command;
}

// What may stand where a command may: its own arguments, and for the program those of `view`, which need not be named.
std::vector<Argument> arguments_at(const Command& command, const std::vector<Command>& commands) {
    std::vector<Argument> arguments = command.arguments;
    if (!command.name.empty()) return arguments;
    for (const Argument& argument : std::ranges::find(commands, "view", &Command::name)->arguments) {
        const bool is_new = std::ranges::find(arguments, argument.names, &Argument::names) == arguments.end();
        if (is_new) arguments.push_back(argument);
    }
    return arguments;
}

std::vector<std::string> names_of(const std::vector<Argument>& arguments) {
    std::vector<std::string> names;
    for (const Argument& argument : arguments) names.insert(names.end(), argument.names.begin(), argument.names.end());
    return names;
}

// The text with a backslash before each of the characters.
std::string with_backslashes(std::string_view text, std::string_view characters) {
    std::string result;
    for (const char c : text) {
        if (characters.find(c) != std::string_view::npos) result += '\\';
        result += c;
    }
    return result;
}

// In single quotes, as bash and zsh read them.
std::string in_single_quotes(std::string_view text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

std::string values_in_bash(const Argument& argument) {
    switch (argument.value) {
        case Argument::Value::file: return "compopt -o default";
        case Argument::Value::folder: return "compopt -o dirnames";
        default: break;
    }
    if (argument.choices.empty()) return ":";
    return "mapfile -t COMPREPLY < <(compgen -W " + in_single_quotes(joined(argument.choices, " ")) + " -- \"$word\")";
}

std::string bash_script(const std::vector<Command>& commands, const std::string& names) {
    std::string values;
    std::string options;
    for (const Command& command : commands) {
        options += "    " + in_single_quotes(command.name) +
                   ") options=" + in_single_quotes(joined(names_of(arguments_at(command, commands)), " ")) + " ;;\n";
        for (const Argument& argument : command.arguments) {
            if (argument.value == Argument::Value::none || argument.names.empty()) continue;
            std::vector<std::string> patterns;
            for (const std::string& name : argument.names) {
                patterns.push_back((command.name.empty() ? "*" : command.name) + "\\ " + name);
            }
            values += "    " + joined(patterns, " | ") + ") " + values_in_bash(argument) + "; return ;;\n";
        }
    }
    // A word such as --size=640x480 comes in three pieces.
    return R"(# Completes the command line of sphereview in bash.
_sphereview() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=view options= words
    [ "$word" != = ] || word=
    [ "$before" != = ] || before=${COMP_WORDS[COMP_CWORD - 2]}
    case ${COMP_WORDS[1]} in
    )" + names +
           R"() command=${COMP_WORDS[1]} ;;
    esac
    [ "$COMP_CWORD" -gt 1 ] || command=
    COMPREPLY=()
    case $command\ $before in
)" + values +
           R"(    esac
    case $command in
)" + options +
           R"(    esac
    case $command/$word in
    */-*) words=$options ;;
    /*) words=')" +
           replaced(names, " | ", " ") + R"(' ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
    compopt -o bashdefault -o default
}
complete -F _sphereview sphereview)";
}

std::string spec_in_zsh(const Argument& argument) {
    std::string value;
    if (argument.value != Argument::Value::none) {
        value = ":" + argument.type + ":" +
                (argument.value == Argument::Value::file     ? "_files"
                 : argument.value == Argument::Value::folder ? "_files -/"
                 : argument.choices.empty()                  ? " "
                                                             : "(" + joined(argument.choices, " ") + ")");
    }
    if (argument.names.empty()) return in_single_quotes((argument.is_many ? "*" : "") + value);
    const std::string others = argument.names.size() > 1 ? "(" + joined(argument.names, " ") + ")" : "";
    std::vector<std::string> specs;
    for (const std::string& name : argument.names) {
        const bool takes_equals = name.starts_with("--") && !value.empty();
        specs.push_back(in_single_quotes(others + name + (takes_equals ? "=" : "") + "[" +
                                         with_backslashes(argument.help, "\\[]:") + "]" + value));
    }
    return joined(specs, " ");
}

std::string zsh_script(const std::vector<Command>& commands, const std::string& names) {
    std::string described;
    std::string arguments;
    for (const Command& command : commands) {
        std::string specs;
        for (const Argument& argument : arguments_at(command, commands)) specs += " \\\n        " + spec_in_zsh(argument);
        arguments += "    (" + in_single_quotes(command.name) + ") _arguments -S" + specs + " ;;\n";
        if (!command.name.empty())
            described += "        " + in_single_quotes(command.name + ":" + with_backslashes(command.help, "\\:")) + "\n";
    }
    return R"(#compdef sphereview
# Completes the command line of sphereview in zsh.
_sphereview() {
    local command=view
    local -a commands=(
)" + described +
           R"(    )
    if (( CURRENT == 2 )); then
        command=
        _describe -t commands command commands
        _files
    else
        case $words[2] in
        ()" +
           replaced(names, " | ", "|") + R"() command=$words[2]; shift words; (( CURRENT-- )) ;;
        esac
    fi
    case $command in
)" + arguments +
           R"(    esac
}
if [[ $funcstack[1] == _sphereview ]]; then _sphereview "$@"; else compdef _sphereview sphereview; fi)";
}

// In single quotes, as fish reads them.
std::string quoted_for_fish(std::string_view text) { return "'" + with_backslashes(text, "\\'") + "'"; }

std::string fish_script(const std::vector<Command>& commands, const std::string& names) {
    const std::string complete = "complete -c sphereview -n ";
    const std::string begin = "__fish_use_subcommand";
    std::string script = "# Completes the command line of sphereview in fish.\n";
    for (const Command& command : commands) {
        std::string where = "__fish_seen_subcommand_from " + command.name;
        if (command.name.empty()) {
            where = begin;
        } else {
            script += complete + begin + " -a " + command.name + " -d " + quoted_for_fish(command.help) + "\n";
        }
        // A command that is not named is `view`.
        if (command.name == "view")
            where = "not __fish_seen_subcommand_from " + replaced(replaced(names, "view | ", ""), " | ", " ");
        for (const Argument& argument : command.arguments) {
            if (argument.names.empty()) continue;
            script += complete + quoted_for_fish(where);
            for (const std::string& name : argument.names) {
                script += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
            }
            switch (argument.value) {
                case Argument::Value::none: break;
                case Argument::Value::file: script += " -rF"; break;
                case Argument::Value::folder: script += " -xa '(__fish_complete_directories)'"; break;
                case Argument::Value::word: script += " -xa " + quoted_for_fish(joined(argument.choices, " ")); break;
            }
            script += " -d " + quoted_for_fish(argument.help) + "\n";
        }
    }
    script.pop_back();
    return script;
}

struct Shell {
    std::string_view name;
    // What completes these commands; their names are "view | render | ...".
    std::string (*script)(const std::vector<Command>& commands, const std::string& names);
};
constexpr std::array<Shell, 3> shells = {{{"bash", bash_script}, {"zsh", zsh_script}, {"fish", fish_script}}};

}  // namespace

std::vector<std::string> completion_shells() {
    std::vector<std::string> names;
    for (const Shell& shell : shells) names.emplace_back(shell.name);
    return names;
}

std::string completion_script(CLI::App& app, const std::string& shell) {
    const auto found = std::ranges::find(shells, shell, &Shell::name);
    if (found == shells.end()) return "";
    std::vector<Command> commands = {command_of(app)};
    std::vector<std::string> names;
    for (CLI::App* command : app.get_subcommands({})) {
        commands.push_back(command_of(*command));
        names.push_back(command->get_name());
    }
    return found->script(commands, joined(names, " | "));
}

}  // namespace sphereview
