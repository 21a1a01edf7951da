// What packages say of the command line, written from the declarations of command_line.cpp alone.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace sphereview {

// What messages say that the value of an option should be: completions offer files or folders for these.
inline constexpr const char* a_file = "the name of a file";
inline constexpr const char* a_folder = "a folder";

// The options and positional arguments that --help shows.
template <typename App>
auto shown_options(App& command) {
    auto options = command.get_options();
    std::erase_if(options, [](const CLI::Option* option) { return option->get_group().empty(); });
    return options;
}

// The manual page, in roff, without an end of line behind the last line.
std::string man_page(const CLI::App& app, const std::string& program_and_version);

// The shells that completion_script() knows.
std::vector<std::string> completion_shells();

// A script that completes commands, options and their values in that shell; "" for a shell that is not known. Without an end of
// line behind the last line. Forgets the values of options.
std::string completion_script(CLI::App& app, const std::string& shell);

}  // namespace sphereview
