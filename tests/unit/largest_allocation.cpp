#include "unit/largest_allocation.hpp"

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <malloc.h>
#endif

namespace {

std::atomic<std::size_t> largest = 0;
std::atomic<std::int64_t> allocated = 0;
std::atomic<std::int64_t> most_allocated = 0;
std::int64_t allocated_before = 0;

void raise(auto& most, auto value) {
    auto old = most.load();
    while (old < value && !most.compare_exchange_weak(old, value)) continue;
}

std::int64_t size_of([[maybe_unused]] void* memory) {
#ifdef __linux__
    return static_cast<std::int64_t>(malloc_usable_size(memory));
#else
    return 0;
#endif
}

void release(void* memory) {
    allocated -= size_of(memory);
    std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) {
    raise(largest, size);
    if (void* memory = std::malloc(size)) {
        raise(most_allocated, allocated += size_of(memory));
        return memory;
    }
    throw std::bad_alloc();
}

void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }

namespace sphereview {

std::size_t take_largest_allocation() { return largest.exchange(0); }

void begin_most_bytes() { most_allocated = allocated_before = allocated; }

std::size_t most_bytes() { return static_cast<std::size_t>(most_allocated - allocated_before); }

}  // namespace sphereview
