// A process that can begin no more threads.
#pragma once

#include <cstddef>

#ifdef __linux__
#include <pthread.h>
#endif

namespace sphereview::test {

// While such an object lives no thread can begin: the stack of each would need more memory than there are addresses.
class NoThreads {
public:
    NoThreads(const NoThreads&) = delete;
    NoThreads& operator=(const NoThreads&) = delete;

#ifdef __linux__
    static constexpr bool possible = true;

    NoThreads() {
        pthread_getattr_default_np(&usual_);
        pthread_attr_t larger;
        pthread_getattr_default_np(&larger);
        pthread_attr_setstacksize(&larger, std::size_t{1} << 50);
        pthread_setattr_default_np(&larger);
        pthread_attr_destroy(&larger);
    }
    ~NoThreads() {
        pthread_setattr_default_np(&usual_);
        pthread_attr_destroy(&usual_);
    }

private:
    pthread_attr_t usual_{};
#else
    static constexpr bool possible = false;

    NoThreads() = default;
#endif
};

}  // namespace sphereview::test
