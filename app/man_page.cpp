#include <algorithm>
#include <string_view>

#include "app/command_line_texts.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

// A text as roff shows it unchanged: no hyphen for a minus, no command at the beginning of a line.
std::string escaped(std::string_view text) {
    std::string roff;
    for (const char c : text) {
        const bool begins_line = roff.empty() || roff.back() == '\n';
        if (begins_line && (c == '.' || c == '\'')) roff += "\\&";
        if (c == '\\') {
            roff += "\\e";
        } else if (c == '-') {
            roff += "\\-";
        } else if (c == '\'') {
            roff += "\\(aq";
        } else {
            roff += c;
        }
    }
    return roff;
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + escaped(text) + "\\fR"; }

// Lines that stay as they are.
std::string verbatim(const std::string& text) {
    const std::size_t begin = std::min(text.find_first_not_of('\n'), text.size());
    const std::size_t end = text.find_last_not_of('\n') + 1;
    return ".PP\n.nf\n" + escaped(text.substr(begin, std::max(begin, end) - begin)) + "\n.fi\n";
}

bool is_positional(const CLI::Option& option) { return !option.nonpositional(); }

std::string described(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back(bold("-" + name));
    for (const std::string& name : option.get_lnames()) names.push_back(bold("--" + name));
    if (names.empty()) names.push_back(italic(option.get_name()));
    const std::string type = option.nonpositional() ? option.get_type_name() : "";
    const bool has_value = option.get_items_expected_max() != 0 && !type.empty();
    return ".TP\n" + joined(names, ", ") + (has_value ? " " + italic(type) : "") + "\n" + escaped(option.get_description()) + "\n";
}

// A command's arguments in the synopsis: options first.
std::string synopsis(const CLI::App& command) {
    std::string text = bold("sphereview " + command.get_name()) + " [" + italic("OPTION") + "...]";
    for (const CLI::Option* option : shown_options(command)) {
        if (!is_positional(*option)) continue;
        const bool many = option->get_items_expected_max() > 1;
        const std::string name = italic(option->get_name()) + (many ? "..." : "");
        text += option->get_required() ? " " + name : " [" + name + "]";
    }
    return text;
}

std::string described_options(const CLI::App& command) {
    std::string text;
    for (const bool positional : {true, false}) {
        for (const CLI::Option* option : shown_options(command)) {
            if (is_positional(*option) == positional) text += described(*option);
        }
    }
    return text;
}

}  // namespace

std::string man_page(const CLI::App& app, const std::string& program_and_version) {
    const auto commands = app.get_subcommands({});
    const std::string exit_status = app.get_footer();
    const std::string about = app.get_description();
    const std::size_t first_line = about.find('\n');
    const std::string purpose =
        about.substr(std::string_view("sphereview ").size(), first_line - std::string_view("sphereview .").size());
    std::string page = ".TH SPHEREVIEW 1 \"\" \"" + program_and_version + "\" \"User Commands\"\n.SH NAME\nsphereview \\- " +
                       escaped(purpose) + "\n.SH SYNOPSIS\n";
    for (const CLI::App* command : commands) page += synopsis(*command) + "\n.br\n";
    page += ".SH DESCRIPTION\n" + escaped(about.substr(0, first_line)) + "\n" + verbatim(about.substr(first_line)) +
            ".SH OPTIONS\n" + described_options(app);
    for (const CLI::App* command : commands) {
        std::string examples = command->get_footer();
        if (examples.ends_with(exit_status)) examples.resize(examples.size() - exit_status.size());
        page += ".SH " + escaped("COMMAND " + command->get_name()) + "\n" + synopsis(*command) + "\n.PP\n" +
                escaped(command->get_description()) + ".\n" + described_options(*command) + verbatim(examples);
    }
    return page + ".SH EXIT STATUS\n" + escaped(exit_status);
}

}  // namespace sphereview
