#include "base/standard_streams.hpp"

#include <cerrno>

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#include <windows.h>
#else
#include <unistd.h>
#endif

#include "base/path.hpp"
#include "base/text.hpp"

namespace sphereview {

std::FILE* binary(std::FILE* stream) {
#ifdef _WIN32
    _setmode(_fileno(stream), _O_BINARY);
#endif
    return stream;
}

std::FILE* open_file(const std::string& path, const char* mode) {
#ifdef _WIN32
    return _wfopen(path_from(path).c_str(), path_from(mode).c_str());  // whatever the process's code page is
#else
    std::FILE* file = nullptr;
    do {
        file = std::fopen(path.c_str(), mode);
    } while (file == nullptr && errno == EINTR);
    return file;
#endif
}

bool stderr_is_terminal() {
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(STDERR_FILENO) != 0;
#endif
}

#ifdef _WIN32

namespace {

UINT earlier_code_page = 0;

}  // namespace

void prepare_console() {
    earlier_code_page = GetConsoleOutputCP();
    if (earlier_code_page == 0) return;  // there is no console
    SetConsoleOutputCP(CP_UTF8);
    DWORD mode = 0;
    const HANDLE console = GetStdHandle(STD_ERROR_HANDLE);
    if (GetConsoleMode(console, &mode) != 0) SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

void restore_console() {
    if (earlier_code_page != 0) SetConsoleOutputCP(earlier_code_page);
}

void leave_own_console() {
    DWORD users = 0;
    if (GetConsoleProcessList(&users, 1) == 1) FreeConsole();
}

#else

void prepare_console() {}
void restore_console() {}
void leave_own_console() {}

#endif

void say(std::string_view line) { std::fputs((on_one_line(line) + "\n").c_str(), stderr); }

}  // namespace sphereview
