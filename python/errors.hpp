// The project's errors as Python's.
#pragma once

namespace sphereview {

// From now on what the module's functions throw becomes, with the words of the command line: ValueError for what is wrong in a
// scene or an argument, OSError (with errno and the file's name) for a file that cannot be read or written,
// MemoryError, and RuntimeError where nothing can render. Call once, while the module is made.
void translate_errors();

}  // namespace sphereview
