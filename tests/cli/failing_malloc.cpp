// Preloaded into a program: fails the allocation whose number FAILING_ALLOCATION says, from 1, and with FAILING_ALLOCATIONS=on all
// that follow.
#include <dlfcn.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>

namespace {

std::atomic<long> count = 0;

bool fails() {
    static const char* const number = std::getenv("FAILING_ALLOCATION");
    static const long failing = number != nullptr ? std::atol(number) : 0;
    static const bool on = std::getenv("FAILING_ALLOCATIONS") != nullptr;
    const long current = ++count;
    if (failing == 0 || (current != failing && !(on && current > failing))) return false;
    errno = ENOMEM;
    return true;
}

template <typename Function>
Function real(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

// The project hides symbols otherwise.
#pragma GCC visibility push(default)

extern "C" {

void* malloc(std::size_t size) {
    static const auto call = real<void* (*)(std::size_t)>("malloc");
    return fails() ? nullptr : call(size);
}

void* calloc(std::size_t number, std::size_t size) {
    static const auto call = real<void* (*)(std::size_t, std::size_t)>("calloc");
    return fails() ? nullptr : call(number, size);
}

void* realloc(void* memory, std::size_t size) {
    static const auto call = real<void* (*)(void*, std::size_t)>("realloc");
    return fails() ? nullptr : call(memory, size);
}
}

#pragma GCC visibility pop
