// Memory for results that several threads are about to write.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace sphereview {

// As std::allocator, but leaves elements without a value uninitialized. Else one thread would write zeros and wait for the system's
// memory while the others idle.
template <typename T>
struct UninitializedAllocator : std::allocator<T> {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

    template <typename Other>
    struct rebind {
        using other = UninitializedAllocator<Other>;
    };

    template <typename U>
    void construct(U*) {}
    template <typename U, typename First, typename... Rest>
    void construct(U* place, First&& first, Rest&&... rest) {
        std::construct_at(place, std::forward<First>(first), std::forward<Rest>(rest)...);
    }
};

// resize(n) and its constructor from n leave new elements without a value.
template <typename T>
using UninitializedVector = std::vector<T, UninitializedAllocator<T>>;

}  // namespace sphereview
