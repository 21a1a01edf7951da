#include "base/standard_streams.hpp"

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#else
#include <unistd.h>
#endif

#include "base/text.hpp"

namespace sphereview {

#ifdef _WIN32
std::FILE* binary_stdin() {
    _setmode(_fileno(stdin), _O_BINARY);
    return stdin;
}
std::FILE* binary_stdout() {
    _setmode(_fileno(stdout), _O_BINARY);
    return stdout;
}
bool stderr_is_terminal() { return _isatty(_fileno(stderr)) != 0; }
#else
std::FILE* binary_stdin() { return stdin; }
std::FILE* binary_stdout() { return stdout; }
bool stderr_is_terminal() { return isatty(STDERR_FILENO) != 0; }
#endif

void say(std::string_view line) { std::fputs((on_one_line(line) + "\n").c_str(), stderr); }

}  // namespace sphereview
