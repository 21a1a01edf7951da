// The project's errors as Python's.
#pragma once

#include <string>

namespace sphereview {

// From now on what the module's functions throw becomes, with the words of the command line: ValueError for what is wrong in a
// scene or an argument, OSError (with errno and the file's name) for a file that cannot be read or written,
// MemoryError, and RuntimeError where nothing can render. Call once, while the module is made.
void translate_errors();

// Of an argument, in the words that the command line has for its options: throws InputError "NAME: found FOUND, expected EXPECTED".
[[noreturn]] void wrong_argument(const char* name, const std::string& found, const std::string& expected);

}  // namespace sphereview
