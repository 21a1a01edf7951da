// Calls of POSIX.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace sphereview {

// What a system call returns, which is made again when a signal has interrupted it: -1, with errno set, where it failed.
template <typename Call>
auto uninterrupted(const Call& call) {
    auto result = call();
    while (result == -1 && errno == EINTR) result = call();
    return result;
}

#ifndef _WIN32
// A pipe whose ends are closed in programs that this process starts: one that had an end of its own input would wait for ever.
// Ends of -1, with errno set, where there is none.
inline std::array<int, 2> own_pipe() {
    std::array<int, 2> ends{-1, -1};
#ifdef __linux__
    // In one call: another thread may start a program between two. Where it fails it leaves the ends as they are.
    [[maybe_unused]] const int failed = pipe2(ends.data(), O_CLOEXEC);
#else
    if (pipe(ends.data()) == 0 && (fcntl(ends[0], F_SETFD, FD_CLOEXEC) != 0 || fcntl(ends[1], F_SETFD, FD_CLOEXEC) != 0)) {
        const int error = errno;
        for (int& end : ends) {
            close(end);
            end = -1;
        }
        errno = error;
    }
#endif
    return ends;
}
#endif

}  // namespace sphereview
