// Mistakes in the command line that CLI11 lets pass, or would report in words of its own.
#pragma once

#include <CLI/App.hpp>
#include <span>
#include <string>
#include <vector>

namespace sphereview {

// The first word is a command or an option of the program itself; else throws WrongUsage that says what it may have been meant as.
void check_first_word(const CLI::App& app, const std::string& word);

// The words behind a command.
struct Arguments {
    bool help = false;               // asked for, before any mistake
    std::vector<std::string> files;  // all that are neither options nor their values
};

// Every option is known, is given once, and has a value just where it takes one; else throws WrongUsage. That values make sense
// is for app/typed_options.hpp to say.
Arguments check_options(const CLI::App& command, std::span<const char* const> words);

// After parsing: nothing that the command needs is missing, and nothing is left over; throws WrongUsage.
void check_complete(const CLI::App& command);

}  // namespace sphereview
