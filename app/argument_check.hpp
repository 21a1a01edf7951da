// Mistakes in the command line that CLI11 lets pass, or would report in words of its own.
#pragma once

#include <CLI/App.hpp>
#include <span>
#include <string>
#include <vector>

namespace sphereview {

// Whether the first word already belongs to `usual`, the command that need not be named: its option or a scene. If it is neither
// that nor a command nor an option of the program itself, throws WrongUsage that says what it may have been meant as.
bool begins_usual_command(const CLI::App& app, const CLI::App& usual, const std::string& word);

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
