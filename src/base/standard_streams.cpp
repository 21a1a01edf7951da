#include "base/standard_streams.hpp"

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#else
#include <unistd.h>
#endif

#include "base/text.hpp"

namespace sphereview {

std::FILE* binary(std::FILE* stream) {
#ifdef _WIN32
    _setmode(_fileno(stream), _O_BINARY);
#endif
    return stream;
}

bool stderr_is_terminal() {
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(STDERR_FILENO) != 0;
#endif
}

void say(std::string_view line) { std::fputs((on_one_line(line) + "\n").c_str(), stderr); }

}  // namespace sphereview
