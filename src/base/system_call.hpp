// Calls of POSIX.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace sphereview {

// The result of a system call, repeated while signals interrupt it: -1, with errno set, on failure.
template <typename Call>
auto uninterrupted(const Call& call) {
    auto result = call();
    while (result == -1 && errno == EINTR) result = call();
    return result;
}

#ifndef _WIN32
// A pipe whose ends are closed in programs that this process starts: a program with an end of its own input would wait for ever.
// Ends of -1, with errno set, on failure.
inline std::array<int, 2> own_pipe() {
    std::array<int, 2> ends{-1, -1};
#ifdef __linux__
    // One call, since another thread may start a program between two. On failure the ends stay -1.
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
