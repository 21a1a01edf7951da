#include "base/process_name.hpp"

#include <charconv>
#include <fstream>
#include <iterator>
#include <sstream>

#ifdef _WIN32
#include <windows.h>
#else
#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#endif

namespace sphereview {

namespace {

#ifdef __linux__

// When a process started, in the system's ticks since it came up; "" if it does not run, also when it has only not been waited
// for by its parent.
std::string start_time(long number) {
    std::ifstream file("/proc/" + std::to_string(number) + "/stat");
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::size_t end_of_title = text.rfind(')');  // the title may hold anything, also brackets
    if (end_of_title == std::string::npos) return "";
    std::istringstream fields(text.substr(end_of_title + 1));
    constexpr int state_field = 3;  // counted from 1, as proc(5) does
    constexpr int start_field = 22;
    std::string field;
    for (int i = state_field; i <= start_field && fields >> field; ++i) {
        if (i == state_field && (field == "Z" || field == "X")) return "";
    }
    return fields ? field : "";
}

std::string name_of(long number) {
    const std::string time = start_time(number);
    return time.empty() ? "" : std::to_string(number) + "-" + time;
}
long own_number() { return getpid(); }

#elif defined(_WIN32)

std::string name_of(long number) {
    HANDLE process = OpenProcess(SYNCHRONIZE, FALSE, static_cast<DWORD>(number));
    const bool runs = process != nullptr && WaitForSingleObject(process, 0) == WAIT_TIMEOUT;
    if (process != nullptr) CloseHandle(process);
    return runs ? std::to_string(number) : "";
}
long own_number() { return static_cast<long>(GetCurrentProcessId()); }

#else

std::string name_of(long number) {
    const bool runs = kill(static_cast<pid_t>(number), 0) == 0 || errno == EPERM;
    return runs ? std::to_string(number) : "";
}
long own_number() { return getpid(); }

#endif

}  // namespace

std::string process_name() {
    const std::string name = name_of(own_number());
    return name.empty() ? std::to_string(own_number()) : name;  // where /proc is missing
}

bool process_runs(const std::string& name) {
    long number = 0;
    const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
    return read.ec == std::errc() && number > 0 && (name_of(number) == name || name == process_name());
}

}  // namespace sphereview
