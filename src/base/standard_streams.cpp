#include "base/standard_streams.hpp"

#include <cerrno>

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

std::FILE* open_file(const std::string& path, const char* mode) {
    std::FILE* file = nullptr;
    do {
        file = std::fopen(path.c_str(), mode);
    } while (file == nullptr && errno == EINTR);
    return file;
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
