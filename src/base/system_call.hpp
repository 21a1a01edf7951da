// Calls of POSIX.
#pragma once

#include <cerrno>

namespace sphereview {

// What a system call returns, which is made again when a signal has interrupted it: -1, with errno set, where it failed.
template <typename Call>
auto uninterrupted(const Call& call) {
    auto result = call();
    while (result == -1 && errno == EINTR) result = call();
    return result;
}

}  // namespace sphereview
