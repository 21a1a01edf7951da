// Standard input, output and error on every platform, and other files of the standard library.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace sphereview {

// Turns any translation of line ends off, from now on.
std::FILE* binary(std::FILE* stream);

// As std::fopen(), and again when a signal has interrupted it.
std::FILE* open_file(const std::string& path, const char* mode);

bool stderr_is_terminal();

// On Windows: the console shows UTF-8 and obeys escape sequences, until restore_console(). Nothing elsewhere.
void prepare_console();
void restore_console();

// On Windows: closes the console if nobody else uses it, as when the program with its window was started from a folder.
void leave_own_console();

// Writes one line to standard error, made safe by on_one_line().
void say(std::string_view line);

}  // namespace sphereview
