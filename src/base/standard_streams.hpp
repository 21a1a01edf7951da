// Standard input, output and error as this program uses them, on every platform; and other files of the standard library.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace sphereview {

// Standard input or output without any translation of line ends from now on.
std::FILE* binary(std::FILE* stream);

// As std::fopen(), and again when a signal has interrupted it.
std::FILE* open_file(const std::string& path, const char* mode);

// Whether a person watches standard error.
bool stderr_is_terminal();

// On Windows: the console shows UTF-8 and obeys escape sequences, until restore_console(). Nothing elsewhere.
void prepare_console();
void restore_console();

// On Windows: closes the console if nobody else uses it, as where the program was started from a folder: it has a window now.
void leave_own_console();

// Writes one line to standard error, made safe by on_one_line().
void say(std::string_view line);

}  // namespace sphereview
